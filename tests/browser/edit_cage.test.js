// SPDX-License-Identifier: MIT
/** @file The control cage is edited in the studio: by clicks in the picture, and by the fields alone. */
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { formatObj } from '../../web/cage/obj.js';
import { box, faceAt, pointAt } from '../web/cage/cages.js';
import {
  allPixels,
  downloadedText,
  drawn,
  dropFile,
  measured,
  minimized,
  openAddress,
  screenshots,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const cube = box(3);
const text = formatObj(cube);

/** The studio with a cube of 3 × 3 squares on each side, which the pointer edits. @param {import('playwright-core').BrowserContextOptions} [options] */
async function openCube(options = {}) {
  const opened = await openAddress(served.browser, `${served.url}studio.html`, {
    reducedMotion: 'reduce',
    ...allPixels,
    ...options,
  });
  const { page } = opened;
  await measured(page);
  await dropFile(page, 'cube.obj', text);
  await page.locator('.facts').filter({ hasText: 'cube.obj' }).waitFor();
  await settled(page);
  await page.getByRole('radio', { name: 'Edit', exact: true }).check();
  await said(page, /^Nothing is selected of 54 faces, 56 vertices\.$/);
  await drawn(page);
  return opened;
}

/** What the panel says. @param {Page} page @param {RegExp} pattern */
const said = (page, pattern) => page.locator('#cage-edited').filter({ hasText: pattern }).waitFor();

/** @param {Page} page @param {string} name */
const field = (page, name) => page.locator(`#cage-editing [name=${name}]`);

/** Types into a field as a hand would. @param {Page} page @param {string} name @param {string} value */
async function type(page, name, value) {
  await field(page, name).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Backspace');
  await page.keyboard.type(value);
  await page.keyboard.press('Enter');
}

/** One of the facts of the cage. @param {Page} page @param {string} name */
const fact = (page, name) =>
  page.locator('.facts').evaluate((list, wanted) => {
    const term = [...list.querySelectorAll('dt')].find((one) => one.textContent === wanted);
    return term?.nextElementSibling?.textContent ?? null;
  }, name);

/** Waits for a fact. @param {Page} page @param {string} name @param {string} value */
async function known(page, name, value) {
  await page.waitForFunction(
    ([wanted, words]) =>
      [...document.querySelectorAll('.facts dt')].some(
        (term) => term.textContent === wanted && term.nextElementSibling?.textContent === words,
      ),
    [name, value],
  );
}

/** The text of the cage that is open. @param {Page} page */
async function cageText(page) {
  return JSON.parse(await downloadedText(page, 'problem')).cage.text;
}

/** @typedef {{x: number, y: number}} Place in pixels of the page */

/** Places around one, each a little further out. @param {Place} from @param {number} step in pixels @returns {Generator<Place>} */
function* around({ x, y }, step) {
  for (let i = 0; i < 400; i++) {
    const [radius, angle] = [step * Math.sqrt(i), 2.4 * i];
    yield { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) };
  }
}

/** The canvas in the page. @param {Page} page */
async function canvasBox(page) {
  const at = await page.locator('#surface canvas').boundingBox();
  if (!at) throw new Error('no canvas');
  return { ...at, middle: { x: at.x + at.width / 2, y: at.y + at.height / 2 } };
}

/**
 * Where a click selects one face or vertex alone; a face amid three such places, so not on its edge, where one pixel decides.
 * @param {Page} page @param {'faces' | 'points'} name @param {number} wanted from 1 @returns {Promise<Place>}
 */
async function placeOf(page, name, wanted) {
  const { middle } = await canvasBox(page);
  /** @type {Place[]} */
  const found = [];
  for (const place of around(middle, 14)) {
    await page.mouse.click(place.x, place.y);
    if ((await field(page, name).inputValue()) === String(wanted)) found.push(place);
    await page.keyboard.press('Escape'); // without the handle, which may be under the next place
    if (found.length < (name === 'faces' ? 3 : 1)) continue;
    const mean = (/** @type {'x' | 'y'} */ axis) => found.reduce((sum, one) => sum + one[axis], 0) / found.length;
    const amid = { x: mean('x'), y: mean('y') };
    await page.mouse.click(amid.x, amid.y);
    expect(await field(page, name).inputValue()).toBe(String(wanted));
    return amid;
  }
  throw new Error(`nothing selects ${wanted}`);
}

/** Moves the mouse outwards from a place until it is over the handle. @param {Page} page @param {Place} from */
async function overHandle(page, from) {
  for (const place of around(from, 2.5)) {
    await page.mouse.move(place.x, place.y);
    const cursor = await page.locator('#surface canvas').evaluate((canvas) => getComputedStyle(canvas).cursor);
    if (cursor === 'move') return place;
  }
  throw new Error('no handle');
}

test('two faces that are clicked are bridged to a handle, and undo brings the same bytes back', async () => {
  const { page, errors } = await openCube();
  const [front, top] = [faceAt(cube, [1.5, 1.5, 3]) + 1, faceAt(cube, [1.5, 3, 1.5]) + 1];
  const onTop = await placeOf(page, 'faces', top);
  await page.keyboard.press('Escape');
  await placeOf(page, 'faces', front);
  await page.keyboard.down('Shift');
  await page.mouse.click(onTop.x, onTop.y);
  await page.keyboard.up('Shift');
  await said(page, /^2 faces selected\.$/);
  await drawn(page);
  await page.screenshot({ path: path.join(screenshots, 'edit-selected.png') });
  await page.getByRole('button', { name: 'Bridge', exact: true }).click();
  await known(page, 'Genus', '1');
  expect(await fact(page, 'Faces')).toBe('56');
  expect(await fact(page, 'File')).toBe('cube.obj');
  await settled(page);
  await page.screenshot({ path: path.join(screenshots, 'edit-bridged.png') });
  expect(await page.locator('#undo').getAttribute('aria-label')).toBe('Undo bridge');
  await page.locator('#undo').click();
  await known(page, 'Genus', '0');
  await settled(page);
  expect(await cageText(page)).toBe(text);
  await page.locator('#redo').click();
  await known(page, 'Genus', '1');
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);

test('a drag with Shift selects the vertices in a box, and the handle moves what is selected in one step', async () => {
  const { page, errors } = await openCube();
  const { x, y, width, height } = await canvasBox(page);
  await page.keyboard.down('Shift');
  await page.mouse.move(x + 2, y + 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.locator('#surface .box').waitFor();
  await page.mouse.move(x + width - 2, y + height - 2);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  expect(await field(page, 'points').inputValue()).toBe('1–56');
  await page.keyboard.press('Escape');

  const corner = pointAt(cube, [3, 3, 3]) + 1;
  const handle = await overHandle(page, await placeOf(page, 'points', corner));
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(handle.x + 4 * i, handle.y - 4 * i);
  await page.screenshot({ path: path.join(screenshots, 'edit-dragged.png') });
  await page.mouse.up();
  await page.locator('#undo[aria-label="Undo move a part of the cage"]').waitFor();
  await settled(page);
  const lines = String(await cageText(page)).split('\n');
  expect(lines.filter((line, i) => line !== text.split('\n')[i])).toEqual([lines[corner - 1]]);
  await page.locator('#undo').click();
  await settled(page);
  expect(await cageText(page)).toBe(text);
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);

test('by keyboard alone a vertex is moved to a place, a face is extruded, a strip is split, and a half is mirrored', async () => {
  const { page, errors } = await openCube();
  const corner = pointAt(cube, [3, 3, 3]) + 1;
  await type(page, 'points', String(corner));
  await said(page, /^1 vertex selected\.$/);
  await type(page, 'x', '3.25');
  await page.locator('#undo[aria-label="Undo move a part of the cage"]').waitFor();
  await settled(page);
  const moved = (await cageText(page)).split('\n')[corner - 1];
  expect(moved).toBe('v 3.25 3 3');
  expect(await field(page, 'x').inputValue()).toBe('3.25');

  await type(page, 'points', '');
  await type(page, 'faces', String(faceAt(cube, [1.5, 1.5, 3]) + 1));
  await type(page, 'by', '0.5');
  await known(page, 'Faces', '58');
  await settled(page);
  expect(await fact(page, 'Genus')).toBe('0');

  await type(page, 'faces', '');
  await type(page, 'points', '1, 99999');
  await said(page, /^1 vertex selected\.$/);
  await field(page, 'split').press('Enter');
  await said(page, /^Select two vertices/);
  const edge = [pointAt(cube, [0, 0, 0]), pointAt(cube, [1, 0, 0])].map((v) => v + 1).join();
  await type(page, 'points', edge);
  await field(page, 'split').press('Enter');
  await known(page, 'Faces', '70');
  await settled(page);
  await field(page, 'mirror').press('Enter');
  await known(page, 'Components', '1');
  await settled(page);
  await page.keyboard.press('Escape');
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);

test('a generated shape becomes a text of its own, what is held follows, and the faces of a run are left alone', async () => {
  const { page, errors } = await openAddress(served.browser, `${served.url}studio.html?shape=cube`, {
    reducedMotion: 'reduce',
    ...allPixels,
  });
  await settled(page);
  await page.locator('[name=functional]').selectOption('bending');
  await settled(page);
  await page.getByRole('radio', { name: 'Pin', exact: true }).check();
  await page.locator('#pin-vertex input').fill('1');
  await page.keyboard.press('Enter');
  await page.locator('#pins li').waitFor();
  await settled(page);
  await page.getByRole('radio', { name: 'Edit', exact: true }).check();
  await said(page, /^Nothing is selected of 6 faces/);
  await type(page, 'faces', '1, 6');
  await field(page, 'bridge').click();
  await said(page, /^An edge joins|^Both have/);
  await type(page, 'faces', '1');
  await field(page, 'remove').click();
  await known(page, 'File', 'Cube edited');
  expect(await fact(page, 'Boundaries')).toBe('1');
  expect(await page.locator('#pins li').count()).toBe(1);
  await settled(page);
  await page.getByRole('button', { name: 'Step', exact: true }).click();
  // Its points may be moved, since the surface depends on them; its faces stay.
  await said(page, /^Nothing is selected of 5 faces/);
  expect(await field(page, 'remove').isDisabled()).toBe(true);
  expect(await field(page, 'points').isDisabled()).toBe(false);
  await page.locator('#primary').click();
  await status(page, minimized, 60_000);
  await said(page, /^Nothing is selected of 5 faces/);
  await type(page, 'points', '2');
  await drawn(page);
  await page.screenshot({ path: path.join(screenshots, 'edit-after-run.png') });
  await type(page, 'y', '-0.75');
  await page.locator('#undo[aria-label="Undo move a part of the cage"]').waitFor();
  await status(page, minimized, 60_000);
  await page.locator('#undo').click();
  await status(page, minimized, 60_000);
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);

test.each([
  ['light', 1440, 900],
  ['dark', 1440, 900],
  ['light', 390, 844],
  ['dark', 390, 844],
])(
  'the panel fits a %s page of %i pixels',
  async (colorScheme, width, height) => {
    const { page, errors } = await openCube({
      colorScheme: /** @type {'light' | 'dark'} */ (colorScheme),
      viewport: { width, height },
    });
    await type(page, 'faces', String(faceAt(cube, [1.5, 1.5, 3]) + 1));
    await field(page, 'grow').click();
    await type(page, 'points', String(pointAt(cube, [3, 3, 3]) + 1));
    await settled(page);
    await page.screenshot({ path: path.join(screenshots, `edit-${colorScheme}-${width}.png`), fullPage: width < 1000 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    expect(errors).toEqual([]);
    await page.context().close();
  },
  120_000,
);
