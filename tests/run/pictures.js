// SPDX-License-Identifier: MIT
/**
 * @file `npm run pictures`: makes the README's pictures and the catalog's thumbnails by drawing with the page itself.
 * `npm run pictures -- readme` or `-- catalog` makes only those, `-- catalog hole-3 hole-4` only of these shapes.
 */
import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { launchBrowser } from '../browser/browser.js';
import { allPixels, builtPage, minimized, openAdvanced, openPage, status } from '../browser/page.js';
import { serve } from '../browser/site.js';
import { build } from './build.js';
import { installPackages, installTools } from './install.js';
import { catalogPictures } from './pictures/catalog.js';
import { holdingPicture } from './pictures/holding.js';
import { root } from './process.js';

/** @typedef {import('playwright-core').Browser} Browser */

const folder = path.join(root, 'web/pictures');

/** A picture of the page with a minimizer. @param {Browser} browser @param {string} url */
async function pagePicture(browser, url) {
  const { page } = await openPage(browser, url, {
    colorScheme: 'light',
    viewport: { width: 1280, height: 940 },
    ...allPixels,
  });
  await page.locator('#primary').click();
  await status(page, minimized, 300_000);
  await page.locator('canvas[data-picture=fine]').waitFor();
  await page.screenshot({ path: path.join(folder, 'page.png') });
  await page.context().close();
}

/** A picture of the extraordinary vertices of the first cage with the three kinds of caps, side by side. @param {Browser} browser @param {string} url */
async function capsPicture(browser, url) {
  const { page } = await openPage(browser, url, { colorScheme: 'light', ...allPixels });
  await page.locator('[name=functional]').selectOption('bending');
  /** @type {string[]} */
  const figures = [];
  for (const cap of ['none', 'flat', 'smooth']) {
    await openAdvanced(page);
    await page.locator(`[name=cap][value=${cap}]`).check({ force: true });
    await page.waitForTimeout(1500);
    await page.locator('canvas[data-picture=fine]').waitFor();
    const picture = (await page.locator('#surface').screenshot()).toString('base64');
    figures.push(`<figure><img src="data:image/png;base64,${picture}"><figcaption>${cap}</figcaption></figure>`);
  }
  const sheet = await page.context().newPage();
  await sheet.setContent(
    `<style>body{margin:0}main{display:flex;gap:8px;background:#fff;color:#222;font:18px system-ui;width:1280px}
    figure{margin:0;text-align:center}img{width:421px}</style><main>${figures.join('')}</main>`,
  );
  await sheet.locator('main').screenshot({ path: path.join(folder, 'caps.png') });
  await page.context().close();
}

if (!(await installTools('native', 'wasm', 'browser')) || !(await installPackages())) process.exit(1);
if (!(await build('wasm')) || !(await build('web'))) process.exit(1);
mkdirSync(folder, { recursive: true });
const [site, browser] = await Promise.all([serve(builtPage), launchBrowser()]);
const wanted = process.argv.slice(2);
if (!wanted.length || wanted.includes('readme')) {
  await pagePicture(browser, site.url);
  await capsPicture(browser, site.url);
  await holdingPicture(browser, site.url, path.join(folder, 'holding.png'));
}
if (!wanted.length || wanted.includes('catalog')) {
  const [, ...shapes] = wanted.filter((name) => name !== 'readme');
  await catalogPictures(browser, shapes);
}
await browser.close();
await site.close();
