// SPDX-License-Identifier: MIT
/**
 * @file What the studio says and does where something breaks: files that do not load, a worker that dies in the middle of a
 * run, a graphics context that is taken away; and a project's file that is opened in another browser.
 */
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { fish } from './fish.js';
import {
  downloadedText,
  drawn,
  dropFile,
  evaluated,
  measured,
  openAddress,
  openPage,
  progress,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** @param {Page} page @param {string} name */
const button = (page, name) => page.getByRole('button', { name, exact: true });

/** The energies of the surface on the screen, by the core. @param {Page} page @returns {Promise<Record<string, number>>} */
const energies = async (page) => JSON.parse(await downloadedText(page, 'report')).energies;

describe('what does not load is said, with another try:', () => {
  test('the core', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html?shape=cube`, {}, async (fresh) => {
      await fresh.route('**/*.wasm', (route) => route.abort());
    });
    await page.locator('#alert').filter({ hasText: 'The computation could not be loaded' }).waitFor();
    await status(page, /not available/);
    await page.unroute('**/*.wasm');
    await button(page, 'Try again').click();
    await status(page, /^Ready/);
    await measured(page);
    expect(await page.locator('#alert').isHidden()).toBe(true);
    expect(await page.locator('[name=shape]').inputValue()).toBe('cube');
    await page.context().close();
  });

  test('the catalog', async () => {
    const { page } = await openAddress(
      served.browser,
      `${served.url}studio.html?shape=two-3&functional=bending`,
      {},
      async (fresh) => {
        await fresh.route('**/catalog.json', (route) => route.abort());
      },
    );
    await page.locator('#alert').filter({ hasText: 'The catalog’s minimizer was not opened' }).waitFor();
    await status(page, /^Ready/);
    await page.unroute('**/catalog.json');
    await button(page, 'Try again').click();
    await status(page, /^The catalog’s /);
    await page.context().close();
  });

  test('the part that draws', async () => {
    let broken = true;
    const { page } = await openAddress(served.browser, `${served.url}studio.html`, {}, async (fresh) => {
      await fresh.route(/\/surface-[^/]*\.js$/, (route) => (broken ? route.abort() : route.continue()));
    });
    await page.getByText('The part of this page that draws was not loaded').waitFor();
    await measured(page);
    broken = false;
    await button(page, 'Load the page again').click();
    await drawn(page);
    await page.context().close();
  });
});

test('a worker that dies in the middle of a run leaves its last surface, from which the run goes on', async () => {
  const { page } = await openPage(served.browser, served.url, {}, async (fresh) => {
    await fresh.addInitScript(() => {
      /** @type {Worker[]} */
      const workers = [];
      Object.defineProperty(window, 'Worker', {
        value: class extends Worker {
          /** @param {string | URL} url @param {WorkerOptions} [options] */
          constructor(url, options) {
            super(url, options);
            if (!/store/.test(String(url))) workers.push(this);
          }
        },
      });
      Object.assign(window, {
        killWorker() {
          const worker = /** @type {Worker} */ (workers.at(-1));
          worker.terminate();
          worker.dispatchEvent(new ErrorEvent('error', { message: 'memory access out of bounds' }));
        },
      });
    });
  });
  await page.getByRole('switch', { name: 'Keep symmetry' }).click();
  await page.locator('[name=last]').selectOption('3');
  await status(page, /^Ready/);
  await measured(page);
  await button(page, 'Start').click();
  await evaluated(page, 60);
  await page.evaluate(() => /** @type {any} */ (window).killWorker());
  await page
    .locator('#alert')
    .filter({ hasText: /memory access out of bounds.* evaluations is kept/ })
    .waitFor();
  await status(page, /^Broken off/);
  const before = await progress(page);
  await button(page, 'Start').click();
  await status(page, /^Minimizing/);
  await evaluated(page, 3);
  const after = await progress(page);
  expect(after.energy).toBeLessThan(1.2 * before.energy);
  await page.context().close();
}, 240_000);

test('a graphics context that is taken away is said while it lasts', async () => {
  const { page, errors } = await openPage(served.browser, served.url);
  await drawn(page);
  await page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('#surface canvas'));
    const lose = canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    Object.assign(window, { restoreContext: () => lose?.restoreContext() });
    lose?.loseContext();
  });
  await page.getByText('The graphics card has taken the picture back').waitFor();
  await page.evaluate(() => /** @type {any} */ (window).restoreContext());
  await page.getByText('The graphics card has taken the picture back').waitFor({ state: 'hidden' });
  await drawn(page);
  expect(errors).toEqual([]);
  await page.context().close();
});

test('a project that is saved and opened in another browser has the same energies to 1e-12, and its history', async () => {
  const { page } = await openPage(served.browser, served.url);
  await dropFile(page, 'fish.obj', fish());
  await page.getByRole('checkbox', { name: /^head/ }).check();
  await page.locator('[name=functional]').selectOption('bending');
  await page.locator('[name=last]').selectOption('0');
  await status(page, /^Ready/);
  await button(page, 'Start').click();
  const ended = /^(Minimized|The energy|Stopped)/; // a free body creeps
  await status(page, ended, 60_000);
  const before = await energies(page);
  await page.locator('canvas').focus();
  const [saved] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
  expect(saved.suggestedFilename()).toBe('fish.umbilic.json');
  const file = path.join(mkdtempSync(path.join(tmpdir(), 'project-')), 'fish.umbilic.json');
  writeFileSync(file, readFileSync(await saved.path()));
  await page.context().close();

  const { page: other, errors } = await openPage(served.browser, served.url);
  await other.locator('#file').setInputFiles(file);
  await status(other, ended);
  expect(await other.locator('#documents li').count()).toBe(1); // in the place of what nobody had touched
  const after = await energies(other);
  for (const name of ['bending', 'mvs_cross', 'area']) {
    expect(Math.abs(after[name] / before[name] - 1)).toBeLessThan(1e-12);
  }
  expect(await other.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(true);
  await button(other, 'Undo minimize').click();
  await status(other, /^Ready/);
  await dropFile(other, 'broken.json', '{"umbilic": "project", "version": 7}');
  await other.locator('#alert').filter({ hasText: 'It is of version 7; this page reads 1.' }).waitFor();
  expect(errors).toEqual([]);
  await other.context().close();
}, 240_000);
