// SPDX-License-Identifier: MIT
/**
 * @file The first visible change after Start is a surface that has moved, and it comes before all other work. Prints
 * how long it took, which depends on the machine; asserts only the order.
 */
import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { drawn, dropFile, measured, openAddress, recordEvents, recordedEvents } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('./page.js').PageEvent} PageEvent */

const served = servedPage();
const openings = 2;
const text = readFileSync(new URL('../core/reference/g2.obj', import.meta.url), 'utf8');

/** @param {Page} page */
async function dropCage(page) {
  await dropFile(page, 'cage.obj', text);
  await page.locator('#cage').filter({ hasText: 'cage.obj' }).waitFor();
}

/** When the first moved surface arrived, and when it was drawn, after a button was pressed. @param {Page} page @param {string} button */
async function firstChange(page, button) {
  await drawn(page);
  await page.waitForTimeout(1000); // the worker prepares, as it does while a user looks at the page
  await page.locator(button).click();
  await page.waitForFunction(
    () => /** @type {any} */ (window).recordedEvents().some((/** @type {PageEvent} */ event) => event.name === 'drawn'),
    undefined,
    { polling: 50 },
  );
  const events = await recordedEvents(page);
  const picture = events.findIndex(({ name }) => name === 'drawn');
  const before = events.slice(0, picture);
  const surfaced = before.findIndex(({ name }) => name === 'surfaced');
  expect(surfaced).toBeGreaterThanOrEqual(0); // the resting surface is not drawn once more
  // The first evaluation is at the surface of the cage.
  expect(before[surfaced].evaluations).toBeGreaterThan(1);
  expect(before[surfaced].evaluations).toBeLessThan(5);
  const earlier = before.slice(0, surfaced).map(({ name }) => name);
  // The energies of a cage are known while it rests; those of a catalog entry's cage are sent only when the run begins.
  const late = ['saved', 'levelEnded', 'ended', ...(button === '#primary' ? ['measured'] : [])];
  for (const name of late) expect(earlier).not.toContain(name);
  expect(before.map(({ name }) => name)).not.toContain('ended');
  return [before[surfaced].time, events[picture].time];
}

test.each([
  ['the default cage', 'studio.html', '#primary', async () => {}],
  ['a dropped cage', 'studio.html', '#primary', dropCage],
  ['an entry of the catalog', 'studio.html?shape=octahedron-frame&functional=bending', '#entry button', async () => {}],
])(
  'the first moved surface of %s is drawn before anything else is drawn or saved',
  async (name, address, button, prepare) => {
    /** @type {number[][]} */
    const times = [];
    for (let i = 0; i < openings; i++) {
      const { page } = await openAddress(served.browser, `${served.url}${address}`, {}, recordEvents);
      await measured(page);
      await prepare(page);
      times.push(await firstChange(page, button));
      await page.context().close();
    }
    const [sent, shown] = [0, 1].map((i) => Math.round(Math.max(...times.map((pair) => pair[i]))));
    console.log(
      `After Start the first surface of ${name} that had moved was there after ${sent} ms and drawn after ${shown} ms (the slower of ${openings} openings)`,
    );
  },
  180_000,
);
