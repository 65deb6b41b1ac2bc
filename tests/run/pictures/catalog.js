// SPDX-License-Identifier: MIT
/**
 * @file The catalog's thumbnails: every minimizer, drawn by the page's renderer on a transparent background, as WebP
 * files in the catalog's folder.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { build } from 'vite';
import { serve } from '../../browser/site.js';
import { root } from '../process.js';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../../web/files/catalog.js').Catalog} Catalog */

const catalogFolder = path.join(root, 'web/catalog');
const folder = path.join(catalogFolder, 'pictures');
const source = path.join(root, 'tests/run/pictures');
const outDir = path.join(root, 'build/pictures');

/** Quality of the WebP encoder; a picture has about 6 kB. */
const QUALITY = 0.82;

/** The canvas with its transparency as WebP. @param {Page} page @returns {Promise<Buffer>} */
async function webp(page) {
  await page.locator('canvas[data-picture=fine]').waitFor();
  const png = (await page.locator('canvas').screenshot({ omitBackground: true })).toString('base64');
  const encoded = await page.evaluate(
    async ([text, quality]) => {
      const picture = await fetch(`data:image/png;base64,${text}`);
      const bitmap = await createImageBitmap(await picture.blob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d')).drawImage(bitmap, 0, 0);
      const blob = await canvas.convertToBlob({ type: 'image/webp', quality: Number(quality) });
      return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
    },
    [png, QUALITY],
  );
  return Buffer.from(encoded, 'base64');
}

/**
 * @param {Browser} browser
 * @param {string[]} wanted names of shapes; all if empty
 */
export async function catalogPictures(browser, wanted) {
  if (!existsSync(path.join(catalogFolder, 'catalog.json'))) return;
  /** @param {string} name */
  const read = (name) => JSON.parse(readFileSync(path.join(catalogFolder, name), 'utf8'));
  /** @type {Catalog} */
  const { shapes, entries } = read('catalog.json');
  mkdirSync(folder, { recursive: true });
  const input = path.join(source, 'thumbnails.html');
  await build({
    configFile: false,
    root: source,
    base: './',
    logLevel: 'warn',
    build: { outDir, emptyOutDir: true, chunkSizeWarningLimit: 1500, rolldownOptions: { input } },
  });
  const site = await serve(outDir);
  const page = await browser.newPage({ viewport: { width: 240, height: 180 }, deviceScaleFactor: 2 });
  page.on('pageerror', (error) => console.error(error.message));
  await page.goto(`${site.url}thumbnails.html`);
  await page.waitForFunction(() => 'thumbnails' in window);
  for (const { name } of shapes.filter((shape) => !wanted.length || wanted.includes(shape.name))) {
    const row = entries.filter(({ shape, minimizer }) => shape === name && minimizer);
    await page.evaluate(({ shape, reports }) => /** @type {any} */ (window).thumbnails.open(shape, reports), {
      shape: name,
      reports: row.map(({ minimizer }) => read(String(minimizer))),
    });
    for (const [i, { functional }] of row.entries()) {
      await page.evaluate((index) => /** @type {any} */ (window).thumbnails.show(index), i);
      writeFileSync(path.join(folder, `${name}.${functional}.webp`), await webp(page));
    }
    console.log(`${name}: ${row.length} pictures`);
  }
  await page.close();
  await site.close();
}
