// SPDX-License-Identifier: MIT
/**
 * @file The surface of a held cage follows a vertex while the hand still moves it, in the same run, to where a run of the
 * moved cage ends.
 */
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { fish } from './fish.js';
import {
  allPixels,
  downloadedText,
  drawn,
  dropFile,
  measured,
  minimized,
  openAddress,
  recordEvents,
  recordedEvents,
  screenshots,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** Opens a fish whose body is held, and minimizes it on one level. @param {string} text */
async function minimizedFish(text) {
  const options = { reducedMotion: /** @type {const} */ ('reduce'), ...allPixels };
  const opened = await openAddress(served.browser, `${served.url}studio.html`, options, recordEvents);
  const { page } = opened;
  await measured(page);
  const problem = {
    umbilic: 'problem',
    version: 1,
    cage: { name: 'fish.obj', text },
    terms: { bending: 1 },
    constraints: { hold: { groups: ['body'] }, closeness: { weight: 100 } },
    options: { levels: [1, 1], tolerance: 1e-9 },
  };
  await dropFile(page, 'fish.json', JSON.stringify(problem));
  await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
  await settled(page);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, minimized, 60_000);
  return opened;
}

/** The energy of the last level. @param {Page} page @returns {Promise<number>} */
async function energy(page) {
  return JSON.parse(await downloadedText(page, 'report')).levels.at(-1).energy;
}

/** Where the handle is: outwards from the middle of the canvas. @param {Page} page */
async function handleOf(page) {
  const canvas = page.locator('#surface canvas');
  const box = await canvas.boundingBox();
  if (!box) throw new Error('no canvas');
  for (let i = 0; i < 12_000; i++) {
    const [radius, angle] = [3 * Math.sqrt(i), 2.4 * i];
    const [x, y] = [
      box.x + box.width / 2 + radius * Math.cos(angle),
      box.y + box.height / 2 + radius * Math.sin(angle),
    ];
    await page.mouse.move(x, y);
    if ((await canvas.evaluate((element) => getComputedStyle(element).cursor)) === 'move') return { x, y };
  }
  throw new Error('no handle');
}

test('a dragged vertex of a held body takes the surface along, in one step and without a new run', async () => {
  const { page, errors } = await minimizedFish(fish());
  const before = await energy(page);
  await page.getByRole('radio', { name: 'Edit', exact: true }).check();
  await page
    .locator('#cage-edited')
    .filter({ hasText: /^Nothing is selected/ })
    .waitFor();
  await page.locator('#cage-editing [name=points]').fill('60');
  await page.keyboard.press('Enter');
  await page
    .locator('#cage-edited')
    .filter({ hasText: /^1 vertex selected/ })
    .waitFor();
  await drawn(page);
  const { x, y } = await handleOf(page);
  const old = (await recordedEvents(page)).length;
  await page.mouse.down();
  for (let i = 1; i <= 6; i++) {
    await page.mouse.move(x + i, y - 2 * i);
    await page.waitForTimeout(60);
  }
  await page.waitForFunction(() => {
    const events = /** @type {import('./page.js').PageEvent[]} */ (/** @type {any} */ (window).recordedEvents());
    return events.filter(({ name }) => name === 'retargeted').length > 1;
  });
  await page.screenshot({ path: path.join(screenshots, 'follow-cage.png') });
  await page.mouse.up();
  await page.locator('#undo[aria-label="Undo move a part of the cage"]').waitFor();
  await status(page, minimized, 60_000);
  const names = (await recordedEvents(page)).slice(old).map(({ name }) => name);
  expect(names.indexOf('surfaced')).toBeGreaterThan(names.indexOf('retargeted'));
  expect(names).not.toContain('opened');

  const [after, { text }] = [await energy(page), JSON.parse(await downloadedText(page, 'problem')).cage];
  expect(Math.abs(after / before - 1)).toBeGreaterThan(1e-4);
  const fresh = await minimizedFish(text);
  expect(after / (await energy(fresh.page))).toBeCloseTo(1, 5);
  expect([...errors, ...fresh.errors]).toEqual([]);
  for (const opened of [page, fresh.page]) await opened.context().close();
}, 180_000);
