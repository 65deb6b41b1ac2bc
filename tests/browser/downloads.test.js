// SPDX-License-Identifier: MIT
/**
 * @file Every kind of file that the studio saves, by its control: what it is called, how large it was said to be, and that it
 * holds the surface on the screen.
 */
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { allPixels, download, drawn, minimized, openPage, screenshots, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** @type {Page} */
let page;
/** @type {string[]} */
let errors;

beforeAll(async () => {
  ({ page, errors } = await openPage(served.browser, served.url, allPixels));
  await page.locator('[name=functional]').selectOption('bending');
  await page.locator('[name=last]').selectOption('1');
  await page.locator('#primary').click();
  await status(page, minimized);
  await drawn(page);
}, 60_000);

afterAll(async () => {
  expect(errors).toEqual([]);
  await page.context().close();
});

/** The size that is said before saving, in bytes. */
async function saidSize() {
  const [, number, unit] = /About ([\d.]+)\s(kB|MB)/.exec(await page.locator('#download-words').innerText()) ?? [];
  return Number(number) * (unit === 'MB' ? 1e6 : 1e3);
}

describe('the surface is saved as', () => {
  test.each(
    /** @type {Array<[import('../../web/pages/studio/state/types.js').Download, string, RegExp]>} */ ([
      ['control', 'two-3-bending-level1.obj', /^v \S+ \S+ \S+\n/m],
      ['quads', 'two-3-bending-level1-refined1.obj', /^f \d+ \d+ \d+ \d+\n/m],
      ['limit', 'two-3-bending-level1-limit.obj', /^vn \S+ \S+ \S+\n/m],
      ['ply', 'two-3-bending-level1-limit.ply', /^ply\nformat binary_little_endian 1.0\n/],
      ['stl', 'two-3-bending-level1-limit.stl', /^\0{80}/],
      ['glb', 'two-3-bending-level1-mean-limit.glb', /^glTF[^]*COLOR_0/],
    ]),
  )('%s, under the name %s, about as large as was said', async (what, name, content) => {
    const file = await download(page, what);
    expect(file.name).toBe(name);
    expect(file.content.toString('latin1')).toMatch(content);
    expect(file.content.length / (await saidSize())).toBeGreaterThan(0.8);
    expect(file.content.length / (await saidSize())).toBeLessThan(1.25);
    expect(file.content.length).toBeLessThan(6e6);
  });

  test('a picture of the chosen size, of the surface alone or with the page behind it', async () => {
    await page.locator('#downloads [name=what]').selectOption('picture');
    const onScreen = await page.locator('#surface').evaluate((view) => [view.clientWidth, view.clientHeight]);
    const file = await download(page, 'picture');
    expect(file.name).toBe(`two-3-bending-level1-mean-${onScreen.join('x')}.png`);
    const bare = await pixels(file.content);
    expect([bare.width, bare.height]).toEqual(onScreen);
    expect(bare.corner[3]).toBe(0);
    expect(bare.opaque).toBeGreaterThan(0.1);
    expect(bare.opaque).toBeLessThan(0.9);
    expect(bare.colours).toBeGreaterThan(200);
    await page.locator('[name=pixels]').selectOption('1280x720');
    await page.locator('[name=background]').selectOption('page');
    const framed = await pixels((await download(page, 'picture')).content);
    expect(framed).toMatchObject({ width: 1280, height: 720, opaque: 1 });
    expect(await page.locator('canvas').count()).toBe(1);
  }, 60_000);

  test('the history of its run, whose last line is the energy of the report', async () => {
    const { name, content } = await download(page, 'history');
    expect(name).toBe('two-3-bending-history.csv');
    const [head, ...lines] = content.toString().trimEnd().split('\r\n');
    expect(head).toBe('evaluation,level,energy,gradient_norm');
    const report = JSON.parse((await download(page, 'report')).content.toString());
    const energies = lines.map((line) => line.split(',').map(Number)).filter(([, level]) => level === 1);
    expect(Math.min(...energies.map(([, , energy]) => energy))).toBe(report.levels[1].energy);
  });
});

describe('the control', () => {
  test('shows the options of what is chosen, says what is wrong with them, and is reached with the keyboard', async () => {
    await page.locator('#downloads [name=what]').focus();
    await page.locator('#downloads [name=what]').selectOption('stl');
    const usual = await saidSize();
    await page.keyboard.press('Tab');
    await page.locator('[name=density]:focus').selectOption('1');
    expect(await saidSize()).toBeLessThan(usual / 20);
    await page.locator('#downloads [name=size]').selectOption('extent');
    await page.getByRole('textbox', { name: 'Longest side' }).fill('none');
    expect(await page.locator('#downloads .problem').innerText()).toMatch(/above 0/);
    expect(await page.locator('#downloads [name=save]').getAttribute('aria-disabled')).toBe('true');
    await page.getByRole('textbox', { name: 'Longest side' }).fill('60');
    const { content } = await download(page, 'stl');
    const xs = Array.from({ length: content.readUInt32LE(80) }, (_, i) => content.readFloatLE(84 + 50 * i + 12 + 8));
    expect(Math.max(...xs.map(Math.abs))).toBeLessThanOrEqual(30);
    expect(content.length).toBe(84 + 50 * 2 * 96);
    await page.screenshot({ path: path.join(screenshots, 'downloads.png'), fullPage: true });
  });
});

/** @param {Buffer} png */
function pixels(png) {
  return page.evaluate(async (encoded) => {
    const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.drawImage(bitmap, 0, 0);
    const { data, width, height } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set();
    let opaque = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] > 128) opaque++;
      colours.add((data[i] >> 2) * 4096 + (data[i + 1] >> 2) * 64 + (data[i + 2] >> 2));
    }
    return {
      width,
      height,
      corner: [...data.subarray(0, 4)],
      opaque: opaque / (width * height),
      colours: colours.size,
    };
  }, png.toString('base64'));
}
