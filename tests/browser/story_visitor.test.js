// SPDX-License-Identifier: MIT
/**
 * @file The story of a visitor with a phone: from the catalog by touch to a surface in the studio, and its link to a friend.
 */
import { expect, test } from '@jest/globals';
import { drawn, measured, status } from './page.js';
import { servedPage } from './served.js';
import { begin, copiedLink, photograph } from './story.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const phone = {
  viewport: { width: 390, height: 844 },
  isMobile: true,
  hasTouch: true,
  permissions: ['clipboard-read', 'clipboard-write'],
};
const widths = [390];

/** How much of the page is beside the screen, in CSS pixels. @param {Page} page */
const beside = (page) => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

/** Touches the surface and draws the finger to the side. @param {Page} page */
async function swipe(page) {
  await page.locator('#surface canvas').scrollIntoViewIfNeeded();
  const box = await page.locator('#surface canvas').boundingBox();
  if (!box) throw new Error('there is no picture');
  const { x, y } = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const touching = await page.context().newCDPSession(page);
  /** @param {'touchStart' | 'touchMove' | 'touchEnd'} type @param {Array<{x: number, y: number}>} touchPoints */
  const touch = (type, touchPoints) => touching.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', [{ x, y }]);
  for (let step = 1; step <= 5; step++) await touch('touchMove', [{ x: x + 14 * step, y: y + 4 * step }]);
  // The finger rests before it leaves. After a quick one the browser takes the next touch for the end of its glide.
  await page.waitForTimeout(300);
  await touch('touchMove', [{ x: x + 70, y: y + 20 }]);
  await touch('touchEnd', []);
}

test('a visitor with a phone finds a surface in the catalog, turns it, and sends its link', async () => {
  const { page, errors } = await begin(served.browser, served.url, phone);
  const card = page.locator('tr[data-shape=torus]');
  await card.waitFor();
  expect(await beside(page)).toBeLessThanOrEqual(0);
  const { x, width } = (await card.boundingBox()) ?? { x: -1, width: Infinity };
  expect(x).toBeGreaterThanOrEqual(0);
  expect(x + width).toBeLessThanOrEqual(390);
  await page.waitForLoadState('networkidle');
  await photograph(page, 'visitor-catalog', { widths, surface: false });

  await card.locator('a.open').first().tap();
  await page.waitForURL((url) => url.pathname.endsWith('studio.html'));
  await status(page, /^The catalog’s minimizer: [\d.]+/);
  await measured(page);
  await drawn(page);
  expect(await beside(page)).toBeLessThanOrEqual(0);
  await photograph(page, 'visitor-studio', { widths });

  await swipe(page);
  await page.waitForURL((url) => url.searchParams.has('camera'));
  const { search } = new URL(page.url());
  const link = await copiedLink(page, 'tap');
  expect(link).toBe(`${served.url}studio.html${search}`);

  const friend = await begin(served.browser, link, phone);
  await status(friend.page, /^The catalog’s minimizer: [\d.]+/);
  const energy = (/** @type {Page} */ of) => of.locator('#entry strong').innerText();
  expect(await energy(friend.page)).toBe(await energy(page));
  expect(new URL(friend.page.url()).search).toBe(search);
  expect([...errors, ...friend.errors]).toEqual([]);
  await Promise.all([page.context().close(), friend.page.context().close()]);
}, 120_000);
