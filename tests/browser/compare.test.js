// SPDX-License-Identifier: MIT
/**
 * @file The comparison: surfaces that turn together and share one colour scale, their energies, and the page's address.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { openAddress, screenshots } from './page.js';
import { cameraRests, difference, pictureOf } from './pictures.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** @param {string} search @param {import('playwright-core').BrowserContextOptions} [options] @param {(page: Page) => Promise<void>} [prepare] */
async function open(search, options = {}, prepare) {
  const address = `${served.url}compare.html${search}`;
  const permissions = ['clipboard-read', 'clipboard-write'];
  const watched = await openAddress(
    served.browser,
    address,
    { permissions, reducedMotion: 'reduce', ...options },
    prepare,
  );
  await watched.page.locator('#energies tbody tr').first().waitFor();
  return watched;
}

/** Waits until every surface has loaded. @param {Page} page */
async function complete(page) {
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.pane:not([hidden]) .place')].every((place) => !place.textContent),
  );
  await page.locator('#legend .ticks span').first().waitFor();
}

/** @param {Page} page @param {number} index */
const place = (page, index) => page.locator('.place').nth(index);

/** Turns by dragging on a surface. @param {Page} page @param {number} index */
async function drag(page, index) {
  const box = await place(page, index).boundingBox();
  if (!box) throw new Error('there is no such surface');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const camera = new URL(page.url()).searchParams.get('camera');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 90, y + 50, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(0, 0);
  await cameraRests(page, camera);
}

/** @param {string} text as the page prints numbers */
const number = (text) => Number(text.replaceAll('\u202f', '').replaceAll('−', '-'));

describe('surfaces side by side', () => {
  test('turn together, whichever is dragged: of one entry twice both pictures stay the same', async () => {
    const { page, errors } = await open('?entries=two-3.mvs_cross,two-3.mvs_cross');
    await complete(page);
    /** @type {string[]} */
    const seen = [];
    for (const step of [() => {}, () => drag(page, 0), () => drag(page, 1), () => turn(page)]) {
      await step();
      const [left, right] = [await pictureOf(page, place(page, 0)), await pictureOf(page, place(page, 1))];
      expect(await difference(page, left, right)).toBeLessThan(0.002); // edges of pixels
      for (const before of seen) expect(await difference(page, before, left)).toBeGreaterThan(0.01);
      seen.push(left);
    }
    expect(errors).toEqual([]);
    await page.context().close();
  }, 90_000);

  test('are drawn when something changes and at no other time', async () => {
    const { page } = await open(
      '?entries=two-3.bending,two-3.mvs_cross,torus.bending,cube-frame.bending',
      {},
      async (fresh) => {
        await fresh.addInitScript(() => {
          const request = window.requestAnimationFrame.bind(window);
          let frames = 0;
          window.requestAnimationFrame = (callback) => {
            document.documentElement.dataset.frames = String(++frames);
            return request(callback);
          };
        });
      },
    );
    await complete(page);
    await pictureOf(page, page.locator('#panes'));
    const frames = () => page.evaluate(() => Number(document.documentElement.dataset.frames));
    const before = await frames();
    await page.waitForTimeout(1000);
    expect(await frames()).toBe(before);
    await turn(page);
    expect(await frames()).toBeGreaterThan(before);
    await page.context().close();
  }, 60_000);

  test('share one scale, which is that of the widest, and is symmetric', async () => {
    const { page } = await open('?entries=two-3.bending,torus.bending');
    await complete(page);
    const end = async () => number(await page.locator('#legend .ticks span').last().innerText());
    expect(await page.locator('#legend').count()).toBe(1);
    const ticks = (await page.locator('#legend .ticks span').allInnerTexts()).map(number);
    expect(ticks[0]).toBe(-ticks[ticks.length - 1]);
    const both = await end();
    const single = [];
    for (const [shape, index] of /** @type {Array<[string, number]>} */ ([
      ['torus', 0],
      ['two-3', 1],
    ])) {
      // Shows the same surface twice, then the other one twice.
      await page.locator(`select[aria-label="Shape ${index + 1}"]`).selectOption(shape);
      if (index) await page.locator('select[aria-label="Shape 1"]').selectOption(shape);
      await complete(page);
      single.push(await end());
    }
    expect(both).toBeGreaterThanOrEqual(Math.min(...single));
    expect(both).toBeLessThanOrEqual(Math.max(...single));
    await page.context().close();
  }, 60_000);

  test('are chosen, added and removed; the least energy of each row is marked', async () => {
    const { page, errors } = await open('?entries=two-3.bending,two-3.mvs_cross');
    await complete(page);
    await page.getByRole('button', { name: 'Add a surface' }).click();
    await page.locator('select[aria-label="Functional 3"]').selectOption('mvs');
    await page.locator('select[aria-label="Shape 3"]').selectOption('tetrahedron-frame');
    await page.waitForFunction(() => location.search.endsWith('two-3.mvs_cross,tetrahedron-frame.mvs'));
    const rows = await page.locator('#energies tbody tr').evaluateAll((all) =>
      all.slice(1).map((row) => ({
        values: [...row.querySelectorAll('td')].map((cell) => cell.textContent ?? ''),
        least: [...row.querySelectorAll('td')].map((cell) => cell.querySelector('.least') !== null),
      })),
    );
    expect(rows).toHaveLength(8);
    for (const { values, least } of rows) {
      const numbers = values.map(number);
      expect(least.filter(Boolean)).toHaveLength(1);
      expect(numbers[least.indexOf(true)]).toBe(Math.min(...numbers));
    }
    expect(rows[0].least).toEqual([true, false, false]); // bending of the bending minimizer
    await page.getByRole('button', { name: 'Remove 1' }).click();
    await page.waitForFunction(() => location.search.includes('entries=two-3.mvs_cross,tetrahedron-frame.mvs'));
    expect(await page.getByRole('button', { name: 'Remove 1' }).count()).toBe(0); // two remain
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('have an address that opens them again as they are', async () => {
    const { page } = await open('?entries=two-3.bending,torus.bending&shading=kappa2');
    await complete(page);
    const picture = (/** @type {Page} */ shown) => pictureOf(shown, shown.locator('#panes'));
    const before = await picture(page);
    await drag(page, 0);
    await page.getByRole('button', { name: 'Copy address' }).click();
    await page.getByRole('button', { name: 'Copied' }).waitFor();
    const { search } = new URL(await page.evaluate(() => navigator.clipboard.readText()));
    const again = await open(search);
    await complete(again.page);
    expect(new URL(again.page.url()).search).toBe(search);
    // Either page may still be drawing when all messages have arrived; and addresses round angles to a tenth of a
    // degree.
    let different = 1;
    for (let tries = 0; tries < 20 && different >= 0.02; tries++) {
      different = await difference(page, await picture(page), await picture(again.page));
    }
    expect(different).toBeLessThan(0.02);
    expect(await difference(page, before, await picture(again.page))).toBeGreaterThan(0.05);
    await Promise.all([page.context().close(), again.page.context().close()]);
  }, 60_000);

  test('that are not there are told, beside those that are', async () => {
    const { page, errors } = await open('?entries=two-3.bending,two-99.bending&shading=red');
    await place(page, 1).getByText('no such entry').waitFor();
    expect(await page.locator('#notices').innerText()).toMatch(/“shading=red”/);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    expect(await page.locator('#notices').isVisible()).toBe(false);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test.each(/** @type {const} */ (['light', 'dark']))(
    'fit a phone in %s, four of them',
    async (colorScheme) => {
      const search = '?entries=two-3.bending,two-3.mvs_cross,cube-frame.bending,torus.bending';
      const { page, errors } = await open(search, { colorScheme, viewport: { width: 390, height: 844 } });
      await complete(page);
      await pictureOf(page, page.locator('#panes'));
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(width).toBe(390);
      await page.screenshot({ path: path.join(screenshots, `compare-phone-${colorScheme}.png`), fullPage: true });
      expect(errors).toEqual([]);
      await page.context().close();
    },
    60_000,
  );

  test('are pictures and energies where nothing can be drawn', async () => {
    const { page, errors } = await open('?entries=two-3.bending,two-3.mvs_cross', {}, async (fresh) => {
      await fresh.addInitScript(() => {
        const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
          /** @this {HTMLCanvasElement} @param {string} kind @param {any[]} rest */
          function (kind, ...rest) {
            return /webgl/.test(kind) ? null : Reflect.apply(get, this, [kind, ...rest]);
          }
        );
      });
    });
    await page.getByText('shows no WebGL 2').waitFor();
    expect(await page.locator('.place img').nth(1).getAttribute('src')).toBe('./catalog/pictures/two-3.mvs_cross.webp');
    await page.waitForFunction(() => [...document.images].filter((image) => image.naturalWidth > 0).length === 2);
    expect(await page.locator('#energies .least').count()).toBe(8);
    expect(page.workers()).toHaveLength(0);
    expect(errors).toEqual([]);
    await page.screenshot({ path: path.join(screenshots, 'compare-pictures.png'), fullPage: true });
    await page.context().close();
  });
});

/** By the keyboard. @param {Page} page */
async function turn(page) {
  const camera = new URL(page.url()).searchParams.get('camera');
  await page.locator('#panes canvas').focus();
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp']) await page.keyboard.press(key);
  await cameraRests(page, camera);
  // The focus has an outline, which is not of the surfaces.
  await page.locator('#panes canvas').blur();
}
