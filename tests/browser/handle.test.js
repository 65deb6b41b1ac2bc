// SPDX-License-Identifier: MIT
/**
 * @file A pin is dragged in the picture: by mouse, before and during a run, which follows while the hand still moves. Prints
 * how soon.
 */
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { fish } from './fish.js';
import {
  allPixels,
  drawn,
  dropFile,
  evaluated,
  openAddress,
  measured,
  minimized,
  recordEvents,
  recordedEvents,
  screenshots,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** Pixels of one movement of the mouse, and how many there are. */
const [STEP, MOVES] = [3, 10];

/** The middle of the picture, in pixels of the page. @param {Page} page */
async function middle(page) {
  const box = await page.locator('#surface canvas').boundingBox();
  if (!box) throw new Error('no canvas');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Moves the mouse outwards from a place until it is over the handle. @param {Page} page @param {{x: number, y: number}} from */
async function overHandle(page, { x, y }) {
  const isOver = () => page.locator('#surface canvas').evaluate((canvas) => getComputedStyle(canvas).cursor === 'move');
  for (let i = 0; i < 1200; i++) {
    const [radius, angle] = [2.5 * Math.sqrt(i), 2.4 * i];
    const place = { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) };
    await page.mouse.move(place.x, place.y);
    if (await isOver()) return place;
  }
  throw new Error('no handle');
}

/** Where the pin lies, as its fields say. @param {Page} page */
const place = (page) =>
  page
    .locator('#pins .places')
    .first()
    .locator('input')
    .evaluateAll((inputs) => inputs.map((input) => Number(/** @type {any} */ (input).value)));

/** @param {number[]} one @param {number[]} other */
const distance = (one, other) => Math.hypot(...one.map((x, i) => x - other[i]));

test('a pin is dragged by its handle; the surface follows while the hand moves, and one undo takes the drag back', async () => {
  const options = { reducedMotion: /** @type {const} */ ('reduce'), ...allPixels };
  const { page, errors } = await openAddress(served.browser, `${served.url}studio.html`, options, recordEvents);
  await measured(page);
  await dropFile(page, 'fish.obj', fish());
  await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
  await page.locator('[name=functional]').selectOption('bending');
  for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('1');
  await page.getByRole('checkbox', { name: /^body/ }).check();
  await page.getByRole('radio', { name: 'Pin', exact: true }).check();
  await settled(page);
  await drawn(page);

  // A vertex of the head, which is free: the right part of the fish.
  const centre = await middle(page);
  const { width } = /** @type {{width: number}} */ (await page.locator('#surface canvas').boundingBox());
  const start = { x: centre.x + 0.25 * width, y: centre.y };
  await page.mouse.click(start.x, start.y);
  await page.locator('#pins li').waitFor();
  await settled(page);
  await drawn(page);
  const grip = await overHandle(page, start);
  await page.screenshot({ path: path.join(screenshots, 'handle.png') });

  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await evaluated(page, 3);
  await page.locator('#pins .places').first().locator('input').first().waitFor();
  const before = await place(page);
  const handle = await overHandle(page, grip);
  await page.mouse.down();
  const asked = (await recordedEvents(page)).length;
  /** @type {number[]} */
  const times = [];
  for (let i = 1; i <= MOVES; i++) {
    const known = (await recordedEvents(page)).length;
    const began = performance.now();
    await page.mouse.move(handle.x + STEP * i, handle.y - STEP * i);
    await page.waitForFunction(
      (first) => {
        const names = /** @type {any} */ (window)
          .recordedEvents()
          .slice(first)
          .map((/** @type {any} */ { name }) => name);
        return names.lastIndexOf('surfaced') > names.indexOf('retargeted') && names.includes('retargeted');
      },
      known,
      { polling: 1 },
    );
    times.push(performance.now() - began);
  }
  expect(
    (await recordedEvents(page)).slice(asked).filter(({ name }) => name === 'retargeted').length,
  ).toBeGreaterThanOrEqual(MOVES);
  await page.mouse.up();
  await page.screenshot({ path: path.join(screenshots, 'handle-dragged.png') });
  const sorted = times.map(Math.round).sort((a, b) => a - b);
  console.log(
    `New geometry after a move of a pin: ${sorted[MOVES / 2]} ms (median of ${MOVES}), ${sorted.at(-1)} ms at most`,
  );

  await status(page, minimized);
  const dragged = await place(page);
  expect(distance(dragged, before)).toBeGreaterThan(0.02);
  // Before the drag the pin held the surface where the run found it, which only a new run knows.
  await page.locator('#undo').click();
  await page.locator('#pins .places').first().waitFor({ state: 'hidden' });
  await page.locator('#redo').click();
  await page.locator('#pins .places').first().waitFor();
  expect(await place(page)).toEqual(dragged);
  await page.getByRole('radio', { name: 'Turn', exact: true }).check();
  await page.mouse.move(handle.x + 1, handle.y);
  expect(await page.locator('#surface canvas').evaluate((canvas) => getComputedStyle(canvas).cursor)).not.toBe('move');
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);

/** Moves the mouse inwards to a place until it is over the outermost part of the handle. @param {Page} page @param {{x: number, y: number}} to */
async function overRing(page, to) {
  const isOver = () => page.locator('#surface canvas').evaluate((canvas) => getComputedStyle(canvas).cursor === 'move');
  for (let radius = 130; radius > 30; radius -= 4) {
    for (let angle = 0.2; angle < 2 * Math.PI; angle += Math.PI / 5) {
      const place = { x: to.x + radius * Math.cos(angle), y: to.y + radius * Math.sin(angle) };
      await page.mouse.move(place.x, place.y);
      if (await isOver()) return place;
    }
  }
  throw new Error('no ring');
}

test('the normal of a pin is held by a tick, turned by the rings of its handle and by its fields, and taken back', async () => {
  const options = { reducedMotion: /** @type {const} */ ('reduce'), ...allPixels };
  const { page, errors } = await openAddress(served.browser, `${served.url}studio.html?shape=torus`, options);
  await measured(page);
  await page.locator('[name=functional]').selectOption('bending');
  for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('0');
  await page.getByRole('radio', { name: 'Pin', exact: true }).check();
  await settled(page);
  const centre = await middle(page);
  const { width } = /** @type {{width: number}} */ (await page.locator('#surface canvas').boundingBox());
  const start = { x: centre.x + 0.22 * width, y: centre.y };
  await page.mouse.click(start.x, start.y);
  await page.locator('#pins li').waitFor();
  await page.getByRole('checkbox', { name: 'Hold the normal' }).check();
  await settled(page);
  const fields = page.getByRole('group', { name: /^The normal of Vertex/ }).locator('input');
  const normal = () => fields.evaluateAll((inputs) => inputs.map((input) => Number(/** @type {any} */ (input).value)));
  const own = await normal();
  expect(Math.hypot(...own)).toBeCloseTo(1, 2);

  const ring = await overRing(page, await overHandle(page, start));
  await page.screenshot({ path: path.join(screenshots, 'handle-normal.png') });
  await page.mouse.down();
  for (let i = 1; i <= 4; i++) await page.mouse.move(ring.x + 9 * i, ring.y + 9 * i);
  await page.mouse.up();
  await page.getByRole('button', { name: 'Undo turn a normal' }).waitFor();
  const turned = await normal();
  expect(Math.hypot(...turned)).toBeCloseTo(1, 2);
  expect(distance(own, turned)).toBeGreaterThan(0.02);
  await settled(page);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, minimized);
  await drawn(page);
  await page.screenshot({ path: path.join(screenshots, 'handle-normal-turned.png') });

  await fields.nth(2).fill('0.3');
  await fields.nth(2).press('Tab');
  await status(page, minimized);
  await page.getByRole('button', { name: 'Undo turn a normal' }).click();
  await status(page, minimized);
  expect(await normal()).toEqual(turned);
  expect(errors).toEqual([]);
  await page.context().close();
}, 120_000);
