// SPDX-License-Identifier: MIT
/**
 * @file The page opens without errors and with a surface: from any folder of any host, in dark and light, on a phone,
 * and without WebGL.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { allPixels, drawn, energies, evaluated, look, minimized, openPage, screenshots, status } from './page.js';
import { servedPage } from './served.js';

const served = servedPage();

describe('the page', () => {
  test('opens from a sub-path without errors and asks nobody else for anything', async () => {
    const { page, errors, requests } = await openPage(served.browser, served.url);
    expect(await page.title()).toBe('Studio · umbilic');
    expect(errors).toEqual([]);
    expect(requests.length).toBeGreaterThan(3);
    for (const request of requests) expect(request.startsWith(served.url) || request.startsWith('data:')).toBe(true);
    await page.context().close();
  });

  test('opens on the genus-2 frame, shaded, with its energies', async () => {
    const { page } = await openPage(served.browser, served.url);
    expect(await page.locator('[name=shape]').inputValue()).toBe('two-3');
    expect(await page.locator('.facts').innerText()).toMatch(/Genus\s*2/);
    const table = await energies(page);
    const names = Object.keys(table);
    expect(names.slice(8, 10)).toEqual(['Area A', '∫ K dA / 4π']); // after eight functionals
    expect(names.filter((name) => /^J[₃₄₆]/.test(name))).toHaveLength(3);
    expect(Number(table['∫ K dA / 4π'].replace('−', '-'))).toBeCloseTo(-1, 3);
    expect(table['MVS with cross terms']).toMatch(/^\d[\d\u202f.]*$/);
    const { coloured, colours, chroma } = await look(page);
    expect(coloured).toBeGreaterThan(0.1);
    expect(colours).toBeGreaterThan(60);
    expect(chroma).toBeGreaterThan(90);
    await page.context().close();
  });

  test('shades by every quantity, by patterns, and plainly; the legend has numbers', async () => {
    const { page } = await openPage(served.browser, served.url, allPixels);
    const pictures = new Set();
    for (const shading of [
      'mean',
      'gaussian',
      'kappa1',
      'kappa2',
      'magnitude',
      'difference',
      'stripes',
      'isophotes',
      'plain',
    ]) {
      await page.locator('[name=shading]').selectOption(shading);
      const { coloured, colours, chroma } = await look(page);
      pictures.add(`${coloured} ${colours} ${chroma}`);
      const ticks = await page.locator('#legend .ticks span').allInnerTexts();
      if (['stripes', 'isophotes', 'plain'].includes(shading)) {
        expect(await page.locator('#legend figure').isVisible()).toBe(false);
        expect(chroma).toBeLessThan(60);
        continue;
      }
      const numbers = ticks.map((tick) => Number(tick.replace('−', '-').replace('\u202f', '')));
      expect(numbers.length).toBeGreaterThanOrEqual(3);
      expect(numbers.every((number, i) => i === 0 || number > numbers[i - 1])).toBe(true);
      expect(numbers[0]).toBe(['magnitude', 'difference'].includes(shading) ? 0 : -numbers[numbers.length - 1]);
      expect(await page.locator('#legend figcaption').innerText()).toMatch(/1\/length/);
    }
    expect(pictures.size).toBe(9);
    await page.context().close();
  });

  test('draws nothing while nothing changes, and draws when the view is turned', async () => {
    const { page } = await openPage(served.browser, served.url, {}, async (fresh) => {
      await fresh.addInitScript(() => {
        const request = window.requestAnimationFrame.bind(window);
        let frames = 0;
        window.requestAnimationFrame = (callback) => {
          frames++;
          document.documentElement.dataset.frames = String(frames);
          return request(callback);
        };
      });
    });
    const frames = () => page.evaluate(() => Number(document.documentElement.dataset.frames));
    await page.waitForTimeout(500);
    const before = await frames();
    await page.waitForTimeout(1000);
    expect(await frames()).toBe(before);
    await page.locator('canvas').focus();
    await page.keyboard.press('ArrowLeft');
    await page.waitForFunction((count) => Number(document.documentElement.dataset.frames) > count, before);
    // The motion ends: for a whole second no frame is drawn.
    let turned = -1;
    for (let i = 0; i < 20 && turned !== (await frames()); i++) {
      turned = await frames();
      await page.waitForTimeout(1000);
    }
    expect(await frames()).toBe(turned);
    await page.context().close();
  });

  test('turns by keys: the picture changes, and the fit brings the surface back to its size', async () => {
    const { page } = await openPage(served.browser, served.url, { reducedMotion: 'reduce' });
    const first = await look(page);
    await page.locator('canvas').focus();
    for (let i = 0; i < 5; i++) await page.keyboard.press('-');
    const small = await look(page);
    expect(small.coloured).toBeLessThan(0.5 * first.coloured);
    await page.keyboard.press('f');
    const again = await look(page);
    expect(Math.abs(again.coloured / first.coloured - 1)).toBeLessThan(0.02);
    await page.context().close();
  });

  test('says so where WebGL is missing, and works all the same', async () => {
    const { page, errors } = await openPage(served.browser, served.url, {}, async (fresh) => {
      await fresh.addInitScript(() => {
        const getContext = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
          /** @this {HTMLCanvasElement} @param {string} type @param {...any} rest */
          function (type, ...rest) {
            return type.startsWith('webgl') ? null : getContext.call(this, type, ...rest);
          }
        );
      });
    });
    expect(await page.getByText('This browser shows no WebGL 2').isVisible()).toBe(true);
    expect(errors).toEqual([]);
    await page.getByRole('switch', { name: 'Keep symmetry' }).click(); // or the run could end before it is cancelled
    await page.getByRole('button', { name: 'Start' }).click();
    await evaluated(page, 3);
    await page.getByRole('button', { name: 'Cancel' }).click();
    await status(page, /^Stopped/);
    await page.context().close();
  });
});

describe('a picture', () => {
  test.each(
    /** @type {Array<[string, import('playwright-core').BrowserContextOptions]>} */ ([
      ['light', { colorScheme: 'light', ...allPixels }],
      ['dark', { colorScheme: 'dark', ...allPixels }],
      ['phone', { colorScheme: 'light', viewport: { width: 390, height: 844 }, deviceScaleFactor: 2 }],
      ['phone-dark', { colorScheme: 'dark', viewport: { width: 390, height: 844 }, deviceScaleFactor: 2 }],
    ]),
  )(
    'is taken of the page in %s, at rest and after a run; nothing is cut off',
    async (name, options) => {
      const { page, errors } = await openPage(served.browser, served.url, options);
      await drawn(page);
      await page.screenshot({ path: path.join(screenshots, `${name}-opened.png`) });
      const background = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
      const dark = options.colorScheme === 'dark';
      expect(Number(/\d+/.exec(background)?.[0]) < 128).toBe(dark);

      await page.locator('[name=functional]').selectOption('bending');
      await page.getByRole('button', { name: 'Start' }).click();
      await status(page, minimized, 120_000);
      await page.waitForTimeout(300); // the last surface is on its way
      await drawn(page);
      await page.screenshot({ path: path.join(screenshots, `${name}-ended.png`), fullPage: true });
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(overflow).toBeLessThanOrEqual(0);
      expect(errors).toEqual([]);
      await page.context().close();
    },
    180_000,
  );

  test('follows the theme button, also after a reload', async () => {
    const { page } = await openPage(served.browser, served.url, { colorScheme: 'light' });
    const background = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
    const light = await background();
    await page.getByRole('button', { name: 'Dark theme' }).click();
    const dark = await background();
    expect(dark).not.toBe(light);
    await page.reload();
    expect(await background()).toBe(dark);
    expect(await page.getByRole('button', { name: 'Light theme' }).isVisible()).toBe(true);
    await page.context().close();
  });
});
