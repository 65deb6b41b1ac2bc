// SPDX-License-Identifier: MIT
/**
 * @file Cages that are not centred at the origin: during the whole run their surface is in the middle of every picture
 * (checked on the pixels), and looks like that of the centred cage.
 */
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { Cage, load } from '../../wasm/umbilic.js';
import { recordFrames, recordedFrames } from './frames.js';
import { drawn, dropFile, minimized, openPage, screenshots, status } from './page.js';
import { difference, pictureOf } from './pictures.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('./frames.js').Covered} Covered */

const served = servedPage();
let frame = '';

beforeAll(async () => {
  await load();
  const cage = Cage.generate('two-3');
  frame = cage.obj();
  cage.dispose();
});

/** @param {string} obj @param {number[]} offset */
function moved(obj, offset) {
  return obj.replace(/^v (.*)$/gm, (_, point) => {
    const numbers = point
      .split(' ')
      .map((/** @type {string} */ text, /** @type {number} */ i) => Number(text) + offset[i]);
    return `v ${numbers.join(' ')}`;
  });
}

/** Expects a surface that fits the picture: large, nowhere cut off, and in the middle. @param {Covered} covered */
function expectInTheMiddle({ filled, left, right, top, bottom }) {
  expect(filled).toBeGreaterThan(0.08);
  for (const part of [left, top, 1 - right, 1 - bottom]) expect(part).toBeGreaterThan(0.01);
  expect(Math.max(right - left, bottom - top)).toBeGreaterThan(0.5);
  expect(Math.abs((left + right) / 2 - 0.5)).toBeLessThan(0.1);
  expect(Math.abs((top + bottom) / 2 - 0.5)).toBeLessThan(0.1);
}

/**
 * Drops the moved frame on the page, minimizes its MVS_cross, and takes pictures at rest, at the end, and at the end
 * with the control cage.
 * @param {number[]} offset
 */
async function minimize(offset) {
  const { page, errors } = await openPage(served.browser, served.url, { reducedMotion: 'reduce' }, recordFrames);
  await dropFile(page, 'frame.obj', moved(frame, offset));
  await page.locator('.facts').filter({ hasText: 'frame.obj' }).waitFor();
  await page.locator('[name=last]').selectOption('3'); // for more pictures on the way
  await page.locator('[name=shading]').selectOption('plain');
  const surface = page.locator('#surface');
  const pictures = [await pictureOf(page, surface)];
  await page.locator('#primary').click();
  await status(page, minimized, 60_000);
  await page.locator('#downloads [name=save]:not([aria-disabled=true])').waitFor();
  await drawn(page);
  const frames = await recordedFrames(page);
  pictures.push(await pictureOf(page, surface));
  await page.screenshot({ path: path.join(screenshots, `off-centre-${offset.join('_')}.png`) });
  await page.locator('#show summary').click();
  await page.getByLabel('Control cage').check();
  await page.keyboard.press('Escape');
  pictures.push(await pictureOf(page, surface));
  const { search } = new URL(page.url());
  await page.context().close();
  return { frames, pictures, search, errors };
}

describe('a cage', () => {
  /** @type {Awaited<ReturnType<typeof minimize>>} */
  let centred;
  /** @type {Page} that compares pictures */
  let arithmetic;
  beforeAll(async () => {
    centred = await minimize([0, 0, 0]);
    arithmetic = await served.browser.newPage();
  }, 120_000);
  afterAll(() => arithmetic.close());

  test.each([[[50, -30, 20]], [[1e6, 0, 0]], [[0, 0, -1e6]]])(
    'moved by %j is in the middle of every picture from Start to the end, and looks as it does about the origin',
    async (offset) => {
      const { frames, pictures, search, errors } = await minimize(offset);
      expect(frames.length).toBeGreaterThan(3);
      frames.forEach(expectInTheMiddle);
      for (const [i, picture] of pictures.entries()) {
        expect(await difference(arithmetic, picture, centred.pictures[i])).toBeLessThan(0.005);
      }
      expect(search).not.toContain('camera');
      expect(errors).toEqual([]);
    },
    120_000,
  );

  test('about the origin is in the middle as well', () => {
    expect(centred.frames.length).toBeGreaterThan(3);
    centred.frames.forEach(expectInTheMiddle);
  });
});
