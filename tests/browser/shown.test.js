// SPDX-License-Identifier: MIT
/**
 * @file What is shown over the surface and of it: lines, values, the legend's range, cameras and the cage's own surface, on
 * one page.
 */
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { drawn, look, minimized, openAddress, openPage, screenshots, status } from './page.js';
import { difference, surfacePicture } from './pictures.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** @type {Page} */
let page;
/** @type {string[]} */
let errors;
beforeAll(async () => {
  ({ page, errors } = await openPage(served.browser, served.url, {
    reducedMotion: 'reduce',
    viewport: { width: 760, height: 520 }, // few pixels are drawn soon
    bypassCSP: true, // pictures are taken with a style of their own
  }));
}, 60_000);
afterAll(() => page?.context().close());

const picture = () => surfacePicture(page);

/**
 * Where in a picture the surface begins, at 45 % of the canvas' height, as a fraction of the canvas' width.
 * @param {string} encoded
 */
function coveredFrom(encoded) {
  return page.evaluate(async (text) => {
    const response = await fetch(`data:image/png;base64,${text}`);
    const bitmap = await createImageBitmap(await response.blob());
    const context = new OffscreenCanvas(bitmap.width, 1).getContext('2d');
    if (!context) throw new Error('there is no canvas');
    const row = Math.round(0.45 * bitmap.height);
    context.drawImage(bitmap, 0, -row);
    const { data } = context.getImageData(0, 0, bitmap.width, 1);
    let x = 0;
    while (
      x < bitmap.width &&
      Math.max(...data.slice(4 * x, 4 * x + 3)) - Math.min(...data.slice(4 * x, 4 * x + 3)) < 24
    )
      x++;
    return x / bitmap.width;
  }, encoded);
}

/** The picture, as soon as it differs from another. @param {string} before */
async function changed(before) {
  for (let i = 0; i < 50; i++) {
    const now = await picture();
    if (now !== before) return now;
  }
  throw new Error('the picture stays as it is');
}

/** The picture once it stays. */
async function rested() {
  let last = await picture();
  for (let now = await picture(); now !== last; now = await picture()) last = now;
  return last;
}

const camera = () => page.evaluate(() => new URLSearchParams(location.search).get('camera'));
/** @param {string | null} expected */
const rests = (expected) =>
  page.waitForFunction((value) => new URLSearchParams(location.search).get('camera') === value, expected);

describe('the menu of what is shown', () => {
  test('has isolines, the edges of patches and both cages, each drawn while it is on', async () => {
    await page.locator('#show summary').click();
    const plain = await picture();
    const pictures = new Set([plain]);
    for (const name of ['Isolines', 'Patch edges', 'Control cage', 'Original cage']) {
      const box = page.getByRole('checkbox', { name });
      await box.check();
      // The cage that it began from comes from the worker.
      const shown = await changed(plain);
      expect(await difference(page, plain, shown)).toBeGreaterThan(0.002);
      pictures.add(shown);
      await page.screenshot({ path: path.join(screenshots, `shown-${name}.png`) });
      await box.uncheck();
    }
    expect(pictures.size).toBe(5);
    expect((await picture()) === plain).toBe(true);
    await page.keyboard.press('Escape');
    expect(await page.getByRole('checkbox', { name: 'Isolines' }).isVisible()).toBe(false);
  }, 60_000);

  test('has no isolines where no quantity colours the surface', async () => {
    const isolines = page.locator('[name=show-isolines]');
    await page.locator('[name=shading]').selectOption('isophotes');
    expect(await isolines.isDisabled()).toBe(true);
    await page.locator('[name=shading]').selectOption('mean');
    expect(await isolines.isDisabled()).toBe(false);
    await drawn(page);
    expect(errors).toEqual([]);
  });
});

describe('the legend', () => {
  const ends = async () => {
    const texts = await page.locator('#legend .ticks span').allInnerTexts();
    return [texts[0], texts[texts.length - 1]];
  };

  test('has a histogram, and a range that can be pinned, typed and reset', async () => {
    expect(await page.locator('#legend svg').getAttribute('aria-label')).toMatch(/^The area by value, /);
    expect(await page.locator('#legend svg path').getAttribute('d')).toMatch(/^M0 7V/);
    const free = await ends();
    const plain = await picture();
    await page.locator('#legend summary').click();
    const largest = page.getByRole('textbox', { name: 'Largest value' });
    await largest.fill('-20');
    await largest.press('Enter');
    expect(await page.locator('#legend .problem').innerText()).toMatch('less than');
    await largest.fill('1.5');
    await largest.press('Enter');
    const typed = [free[0], '1.5'];
    expect(await ends()).toEqual(typed);
    await changed(plain);
    // It stays with another surface, and belongs to this quantity.
    await page.locator('[name=shading]').selectOption('gaussian');
    expect(await ends()).not.toEqual(typed);
    await page.locator('[name=shading]').selectOption('mean');
    expect(await ends()).toEqual(typed);
    expect(await page.getByRole('button', { name: 'Pin' }).getAttribute('aria-pressed')).toBe('true');
    await page.locator('#legend').getByRole('button', { name: 'Reset' }).click();
    expect(await ends()).toEqual(free);
    await page.locator('#legend summary').click();
    expect((await picture()) === plain).toBe(true);
  }, 60_000);
});

describe('the values of the surface', () => {
  const reading = () => page.locator('#reading');
  const mark = () => page.locator('#legend .mark');

  test('under the pointer are told and marked in the legend, and not beside the surface', async () => {
    const box = await page.locator('#surface canvas').boundingBox();
    if (!box) throw new Error('there is no canvas');
    // Left of the hole in the middle.
    await page.mouse.move(box.x + 0.24 * box.width, box.y + 0.5 * box.height);
    await reading().waitFor();
    expect(await reading().innerText()).toMatch(
      /^κ₁\s\S+, κ₂\s\S+, H\s\S+ per length, K\s\S+ per length²\s+at \(.*\)$/,
    );
    expect(await mark().isVisible()).toBe(true);
    expect(await reading().getAttribute('aria-live')).toBe('off');
    await page.mouse.move(box.x + 0.95 * box.width, box.y + 0.5 * box.height);
    await reading().waitFor({ state: 'hidden' });
    expect(await mark().isVisible()).toBe(false);
  }, 30_000);

  test('at the middle of the picture are told by key, also while the surface is turned', async () => {
    await page.mouse.move(0, 0);
    await page.locator('#surface canvas').focus();
    await page.keyboard.press('v');
    await reading().waitFor();
    expect(await reading().getAttribute('aria-live')).toBe('polite');
    await page.keyboard.press('ArrowDown');
    await rests('38.7,14.6,1');
    const first = await reading().innerText();
    expect(first).toMatch(/^κ₁/);
    await page.screenshot({ path: path.join(screenshots, 'shown-reading.png') });
    await page.keyboard.press('ArrowUp');
    await page.waitForFunction((before) => document.querySelector('#reading')?.textContent !== before, first);
    await rests(null);
    await page.keyboard.press('v');
    await reading().waitFor({ state: 'hidden' });
  }, 30_000);
});

describe('the camera', () => {
  test('looks along the axes and back again, by button and by key', async () => {
    const [before, plain] = [await camera(), await picture()];
    await page.locator('#camera summary').click();
    const top = page.getByRole('button', { name: 'Top' });
    await top.click();
    await rests('0,90,1');
    expect(await top.getAttribute('aria-pressed')).toBe('true');
    const above = await changed(plain);
    await page.getByRole('button', { name: 'Front' }).click();
    await rests('0,0,1');
    await page.getByRole('button', { name: 'Front' }).click();
    await rests(before);
    await page.keyboard.press('Escape');
    await page.locator('#surface canvas').focus();
    await page.keyboard.press('3');
    await rests('0,90,1');
    expect((await picture()) === above).toBe(true);
    await page.keyboard.press('3');
    await rests(before);
    expect((await picture()) === plain).toBe(true);
  }, 30_000);

  test('projects in parallel when asked, and what is pointed at stays where it is drawn', async () => {
    const plain = await picture();
    const canvas = page.locator('#surface canvas');
    await canvas.focus();
    await page.keyboard.press('o');
    const parallel = await changed(plain);
    expect(await page.locator('[value=orthographic]').isChecked()).toBe(true);
    const box = await canvas.boundingBox();
    if (!box) throw new Error('there is no canvas');
    // On the surface near its left rim, and just beside it.
    const surface = await coveredFrom(parallel);
    for (const [beside, text] of /** @type {const} */ ([
      [0.02, true],
      [-0.02, false],
    ])) {
      await page.mouse.move(box.x + (surface + beside) * box.width, box.y + 0.45 * box.height);
      await page.locator('#reading').waitFor({ state: text ? 'visible' : 'hidden' });
    }
    await page.mouse.move(0, 0);
    await canvas.focus();
    await page.keyboard.press('o');
    expect((await changed(parallel)) === plain).toBe(true);
  }, 30_000);

  test('finds the surface again when it is lost', async () => {
    const plain = await picture();
    const lost = new URL(page.url());
    lost.searchParams.set('camera', '10,20,6,12,0,-9');
    const { page: far, errors: failed } = await openAddress(served.browser, lost.href, {
      reducedMotion: 'reduce',
      viewport: { width: 390, height: 700 },
    });
    await drawn(far);
    const { coloured } = await look(far);
    expect(coloured).toBe(0);
    await far.locator('#fit').click();
    await far.waitForFunction(() => location.search.includes('camera=10,20,1'));
    expect((await look(far)).coloured).toBeGreaterThan(0.1);
    expect(failed).toEqual([]);
    await far.context().close();
    expect((await picture()) === plain).toBe(true);
  }, 60_000);
});

describe('the cage’s own surface', () => {
  const told = () => page.locator('#before-told');

  test('is shown while the key or the button is held down, in the same colours, and this is told', async () => {
    await page.locator('[name=functional]').selectOption('bending');
    await page.locator('[name=last]').selectOption('0');
    await page.locator('[name=shading]').selectOption('plain');
    await page.locator('#primary').click();
    await status(page, minimized, 60_000);
    await page.locator('#downloads [name=save]:not([aria-disabled=true])').waitFor();
    const result = await rested();

    await page.locator('#surface canvas').focus();
    await page.keyboard.down('b');
    await told()
      .filter({ hasText: /^This is the cage’s own surface/ })
      .waitFor();
    const before = await changed(result);
    await page.keyboard.up('b');
    expect((await changed(before)) === result).toBe(true);
    expect(await told().innerText()).toMatch('as it is now');

    const button = page.getByRole('button', { name: 'Before' });
    await button.hover();
    await page.mouse.down();
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    expect(await told().innerText()).toMatch('the cage’s own');
    await page.mouse.up();
    expect(await button.getAttribute('aria-pressed')).toBe('false');
    await page.locator('[name=shading]').selectOption('mean');
    const ticks = () => page.locator('#legend .ticks').innerText();
    const scale = await ticks();
    await button.focus();
    await page.keyboard.down('Space');
    expect(await ticks()).toBe(scale);
    expect(await button.getAttribute('aria-pressed')).toBe('true');
    await page.keyboard.up('Space');
    expect(await button.getAttribute('aria-pressed')).toBe('false');

    // It is what the cage shows.
    await page.locator('[name=shading]').selectOption('plain');
    await page.locator('#reset').click();
    await status(page, /^Ready/);
    await changed(result);
    const own = await rested();
    expect(await difference(page, result, own)).toBeGreaterThan(0.01);
    expect(await difference(page, before, own)).toBeLessThan(0.001);
    expect(errors).toEqual([]);
  }, 90_000);
});
