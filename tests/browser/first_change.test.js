// SPDX-License-Identifier: MIT
/**
 * @file The first visible change after Start: a surface that has moved, before anything else that takes time. Prints how
 * long it took, which depends on the machine; asserts the order only.
 */
import { expect, test } from '@jest/globals';
import { drawn, openPage, recordEvents, recordedEvents, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('./page.js').PageEvent} PageEvent */

const served = servedPage();

test('Start draws the default cage’s first moved surface before it draws, saves or measures anything else', async () => {
  const { page } = await openPage(served.browser, served.url, {}, recordEvents);
  await drawn(page);
  await page.waitForTimeout(2000); // the worker warms up, as it does while a user looks at the page
  await page.locator('#primary').click();
  await status(page, /^Converged/, 60_000);
  const events = await recordedEvents(page);
  /** @param {string} name @param {number} [from] */
  const index = (name, from = 0) => events.findIndex((event, i) => i >= from && event.name === name);
  const surfaced = index('surfaced');
  const picture = index('drawn');
  // The first evaluation is that of the cage's own surface.
  expect(events[surfaced].evaluations).toBeGreaterThan(1);
  expect(events[surfaced].evaluations).toBeLessThan(5);
  expect(picture).toBeGreaterThan(surfaced); // the resting surface is not drawn once more
  for (const name of ['saved', 'measured', 'levelEnded', 'ended']) expect(index(name)).toBeGreaterThan(surfaced);
  expect(index('ended')).toBeGreaterThan(picture);
  const [sent, shown] = [surfaced, picture].map((i) => Math.round(events[i].time));
  console.log(`After Start the first surface that had moved was there after ${sent} ms and drawn after ${shown} ms`);
  await page.context().close();
}, 60_000);
