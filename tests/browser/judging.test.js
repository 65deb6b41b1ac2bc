// SPDX-License-Identifier: MIT
/**
 * @file Judging a surface on the page: where its energy sits, and where it crosses itself.
 */
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { cubes } from './cubes.js';
import { allPixels, drawn, openPage, screenshots } from './page.js';
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
    acceptDownloads: true,
    ...allPixels,
  }));
}, 60_000);
afterAll(() => page?.context().close());

/** @param {string} name */
async function photograph(name) {
  for (const scheme of /** @type {const} */ (['dark', 'light'])) {
    await page.emulateMedia({ colorScheme: scheme });
    await drawn(page);
    await page.screenshot({ path: path.join(screenshots, `judging-${name}-${scheme}.png`) });
  }
}

/** @param {RegExp} text */
const legendSays = (text) =>
  page.waitForFunction(
    ([source]) => new RegExp(source).test(document.querySelector('#legend figure')?.textContent ?? ''),
    [text.source],
  );

describe('the density of the energy', () => {
  test('is the shading, of the energy that is chosen, with a legend and a reading', async () => {
    await page.locator('[name=shading]').selectOption('energy');
    await legendSays(/energy per area: .* with the factor A, in 1\/length²/);
    await page.locator('#legend .ticks span').first().waitFor();
    await photograph('density');
    await page.locator('#surface canvas').hover();
    await page.locator('#reading').waitFor();
    expect(await page.locator('#reading').innerText()).toMatch(/energy density\s\S+ per length², at \(/);
    expect(new URL(page.url()).searchParams.get('shading')).toBe('energy');
  }, 60_000);

  test('is coloured by decades too, with its own numbers in the legend, the fields of its range and the reading', async () => {
    await page.mouse.move(0, 0);
    const ticks = () => page.locator('#legend .ticks span').allInnerTexts();
    const evenly = await ticks();
    await page.locator('[name=shading]').selectOption('energy_log');
    await page.waitForFunction(
      (before) => document.querySelector('#legend .ticks')?.textContent !== before,
      evenly.join(''),
    );
    const values = (await ticks()).map((text) => Number(text.replaceAll(/[\s\u202f]/g, '').replace('k', 'e3')));
    for (let i = 1; i < values.length; i++) {
      const decades = Math.log10(values[i] / values[i - 1]);
      expect(decades).toBeCloseTo(Math.round(decades), 9);
      expect(decades).toBeGreaterThan(0.5);
    }
    await page.locator('#surface canvas').hover();
    await page
      .locator('#reading')
      .filter({ hasText: /energy density/ })
      .waitFor();
    expect(await page.locator('#legend .mark').isVisible()).toBe(true);
    await photograph('decades');
    await page.locator('#legend summary').click();
    const low = page.getByRole('textbox', { name: 'Least value' });
    expect(Number(await low.inputValue())).toBe(values[0]);
    await low.fill('0');
    await low.press('Enter');
    await page.locator('#legend .problem').filter({ hasText: 'Both ends must be above 0.' }).waitFor();
    await low.fill('0.5');
    await low.press('Enter');
    await page.locator('#legend summary').filter({ hasText: 'Range, pinned' }).waitFor();
    expect((await ticks())[0]).toBe('0.5');
    await page.locator('#legend').getByRole('button', { name: 'Reset' }).click();
    await page.locator('#legend summary').click();
  }, 60_000);
});

describe('a section', () => {
  const words = () => page.locator('#section .note');
  /** @param {string} name @param {string} key @param {number} times */
  async function press(name, key, times) {
    const control = page.locator(`[name=section-${name}]`);
    await control.focus();
    for (let i = 0; i < times; i++) await control.press(key);
  }

  test('is drawn with its comb, moved by key, turned, and cuts the front away', async () => {
    await page.locator('[name=shading]').selectOption('mean');
    await page.locator('#show summary').click();
    expect(await words().isVisible()).toBe(false);
    await page.getByRole('checkbox', { name: 'Section', exact: true }).check();
    await page.getByText(/curvature .* per length/).waitFor();
    await page.keyboard.press('Escape');
    await page.locator('[name=section-axis][value=z]').click();
    await page.waitForFunction(() => document.querySelector('#section .note')?.textContent?.startsWith('3 curves'));
    await photograph('section');
    await press('position', 'End', 1);
    await page.waitForFunction(() => !document.querySelector('#section .note')?.textContent?.startsWith('3 curves'));
    await press('position', 'Home', 1);
    await press('position', 'ArrowRight', 100);
    await page.waitForFunction(() => document.querySelector('#section .note')?.textContent?.startsWith('3 curves'));
    await page.locator('[name=section-axis][value=view]').click();
    const reading = page.locator('#reading');
    const box = await page.locator('#surface canvas').boundingBox();
    if (!box) throw new Error('there is no picture');
    await page.mouse.move(box.x + 0.26 * box.width, box.y + 0.5 * box.height);
    await reading.waitFor();
    const whole = await reading.innerText();
    await page.getByRole('checkbox', { name: 'Cut away the front' }).check();
    await page.mouse.move(box.x + 0.26 * box.width, box.y + 0.5 * box.height);
    await page.waitForFunction((before) => {
      const line = /** @type {HTMLElement} */ (document.querySelector('#reading'));
      return line.hidden || line.innerText !== before;
    }, whole);
    await photograph('cut');
    for (const width of [390, 1024, 1440]) {
      await page.setViewportSize({ width, height: 800 });
      await drawn(page);
      for (const control of await page.locator('#section input').all()) {
        const box = await control.boundingBox();
        expect(box && box.x >= 0 && box.x + box.width <= width).toBe(true);
      }
      await page.screenshot({ path: path.join(screenshots, `judging-section-${width}.png`) });
    }
    await page.setViewportSize({ width: 1280, height: 800 });
    await page.locator('#show summary').click();
    await page.getByRole('checkbox', { name: 'Section', exact: true }).uncheck();
    expect(await words().isVisible()).toBe(false);
    await page.keyboard.press('Escape');
    expect(errors).toEqual([]);
  }, 60_000);
});

describe('self-intersections', () => {
  test('are marked on the surface and counted', async () => {
    const buffer = Buffer.from(cubes(0.9));
    await page.locator('#file').setInputFiles({ name: 'cubes.obj', mimeType: 'text/plain', buffer });
    await page.waitForFunction(() => document.querySelector('#cage')?.textContent?.includes('cubes'));
    await page.locator('[name=shading]').selectOption('plain');
    await page.locator('#show summary').click();
    await page.getByRole('checkbox', { name: 'Self-intersections' }).check();
    await page.getByText('The surface crosses itself in 1 place.').first().waitFor();
    await page.keyboard.press('Escape');
    expect(await page.locator('#crossings .swatch').isVisible()).toBe(true);
    await photograph('crossings');
  }, 60_000);

  test('are told before a file for printing is saved, which can be saved all the same', async () => {
    await page.locator('#show summary').click();
    await page.getByRole('checkbox', { name: 'Self-intersections' }).uncheck();
    await page.keyboard.press('Escape');
    expect(await page.locator('#crossings').isVisible()).toBe(false);
    await page.locator('#downloads [name=what]').selectOption('stl');
    await page.locator('#printing', { hasText: 'The surface crosses itself in 1 place.' }).waitFor();
    await page.locator('#printing').scrollIntoViewIfNeeded();
    await photograph('printing');
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('#downloads').getByRole('button', { name: 'Save' }).click(),
    ]);
    expect(file.suggestedFilename()).toMatch(/\.stl$/);
    await page.locator('#downloads [name=what]').selectOption('glb');
    expect(await page.locator('#printing').isVisible()).toBe(false);
    expect(errors).toEqual([]);
  }, 60_000);
});
