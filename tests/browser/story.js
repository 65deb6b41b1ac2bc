// SPDX-License-Identifier: MIT
/**
 * @file What the stories share: each is one person's way through the pages, from the first look to what is taken home. With
 * STORY_PICTURES=1 they draw all pixels, and take pictures at three widths, in light and in dark, into build/screenshots.
 */
import path from 'node:path';
import { allPixels, downloadedText, drawn, openAddress, screenshots } from './page.js';

/** @typedef {import('playwright-core').Page} Page */

const withPictures = Boolean(process.env.STORY_PICTURES);
const WIDTHS = [1440, 1024, 390];

/**
 * Opens a page as someone whose motion is reduced, so that pictures are at rest.
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {import('playwright-core').BrowserContextOptions} [options]
 * @param {(page: Page) => Promise<void>} [prepare]
 */
export async function begin(browser, address, options = {}, prepare = undefined) {
  const pixels = withPictures ? allPixels : {};
  const opened = await openAddress(browser, address, { reducedMotion: 'reduce', ...pixels, ...options }, prepare);
  opened.page.setDefaultTimeout(60_000); // runs take what they take
  return opened;
}

/**
 * Takes pictures of a page if they are asked for.
 * @param {Page} page
 * @param {string} name
 * @param {object} [how]
 * @param {number[]} [how.widths]
 * @param {boolean} [how.surface] whether the page draws one
 */
export async function photograph(page, name, { widths = WIDTHS, surface = true } = {}) {
  if (!withPictures) return;
  const before = page.viewportSize();
  for (const width of widths) {
    await page.setViewportSize({ width, height: width < 500 ? 844 : 900 });
    await page.evaluate(() => scrollTo(0, 0));
    for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
      await page.emulateMedia({ colorScheme });
      if (surface) await drawn(page);
      const file = `story-${name}-${width}-${colorScheme}.png`;
      await page.screenshot({ path: path.join(screenshots, file), fullPage: surface });
    }
  }
  await page.emulateMedia({ colorScheme: null });
  if (before) await page.setViewportSize(before);
  if (surface) await drawn(page);
}

/** @param {Page} page @param {string | RegExp} name */
export const button = (page, name) => page.getByRole('button', { name, exact: true });

/** The report of the surface on the screen, whose energies have all digits. @param {Page} page */
export const reportOf = async (page) => JSON.parse(await downloadedText(page, 'report'));

/** The largest relative difference of the energies of two reports. @param {any} one @param {any} other */
export function apart(one, other) {
  const names = Object.keys(one.energies).filter((name) => Number.isFinite(one.energies[name]));
  if (names.length < 5) throw new Error(`only ${names.length} energies`);
  return Math.max(...names.map((name) => Math.abs(other.energies[name] / one.energies[name] - 1)));
}

/** Copies the link to what is on the screen. @param {Page} page @param {'click' | 'tap'} [how] */
export async function copiedLink(page, how = 'click') {
  await Promise.all([button(page, 'Copied').waitFor(), button(page, 'Copy link')[how]()]);
  return page.evaluate(() => navigator.clipboard.readText());
}
