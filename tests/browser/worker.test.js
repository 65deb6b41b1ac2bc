// SPDX-License-Identifier: MIT
/**
 * @file The worker that computes, as a user meets it: it answers Cancel soon, and is replaced where it hangs.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Cage, load } from '../../wasm/umbilic.js';
import {
  downloadedText,
  evaluated,
  look,
  measured,
  openDetails,
  openPage,
  parseProgress,
  progress,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
beforeAll(() => load());

/** @param {Page} page @param {string} name */
const button = (page, name) => page.getByRole('button', { name, exact: true });

/** The workers that compute; another one keeps the documents. @param {Page} page */
const computing = (page) => page.workers().filter((worker) => !worker.url().includes('store'));

describe('the worker', () => {
  test('answers Cancel within a few evaluations on a cage of more than 2000 patches, and prints how fast', async () => {
    const { page } = await openPage(served.browser, served.url);
    await page.locator('[name=shape]').selectOption('hexagonal-prism-frame');
    await page
      .locator('.facts')
      .filter({ hasText: /Genus\s*7/ })
      .waitFor();
    await page.getByRole('switch', { name: 'Keep symmetry' }).uncheck(); // or the run would be over too soon
    await page.locator('[name=functional]').selectOption('bending'); // whose metric is soon there
    for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('2');
    await measured(page);
    /** @type {number[]} */
    const times = [];
    for (let i = 0; i < 3; i++) {
      await button(page, 'Start').click();
      await status(page, /^Minimizing/);
      await evaluated(page, 4 + 3 * i);
      // Reads both progress lines in the task of the click, so that evaluations during a slow reading do not count.
      const { time, before, after } = await page.evaluate(
        () =>
          new Promise((/** @type {(told: {time: number, before: string, after: string}) => void} */ resolve) => {
            const line = /** @type {Element} */ (document.querySelector('#status'));
            const progress = /** @type {Element} */ (document.querySelector('#progress'));
            const before = progress.textContent ?? '';
            const start = performance.now();
            new MutationObserver(() => {
              if (!line.textContent?.startsWith('Stopped')) return;
              resolve({ time: performance.now() - start, before, after: progress.textContent ?? '' });
            }).observe(line, { childList: true, characterData: true, subtree: true });
            /** @type {HTMLElement} */ (document.querySelector('#cancel')).click();
          }),
      );
      times.push(time);
      expect(parseProgress(after).evaluations - parseProgress(before).evaluations).toBeLessThan(20);
    }
    await openDetails(page);
    const patches = await page.locator('#levels tbody td').nth(1).innerText();
    console.log(`Cancel answered on ${patches} patches after ${times.map(Math.round).join(', ')} ms`);
    expect(Number(patches.replace(/\D/g, ''))).toBeGreaterThan(2000);
    await page.context().close();
  }, 120_000);

  test('that hangs is replaced; the surface is kept, can be saved, and is gone on from', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await page.locator('[name=last]').selectOption('4');
    await page.locator('[name=first]').selectOption('2');
    await page.getByRole('switch', { name: 'Keep symmetry' }).uncheck(); // or the run would be over too soon
    await button(page, 'Start').click();
    await evaluated(page, 10);
    await page.waitForTimeout(2500); // a copy of the surface is made every second
    const { evaluations } = await progress(page);
    const picture = await look(page, true);
    const [worker] = computing(page);
    const ended = worker.waitForEvent('close', { timeout: 60_000 });
    await worker.evaluate(() => {
      setTimeout(() => {
        for (;;);
      });
    });
    await button(page, 'Pause').click();
    await page
      .locator('#alert')
      .filter({ hasText: 'stopped answering and was restarted' })
      .waitFor({ timeout: 15_000 });
    await status(page, /^Broken off/);
    await ended;
    expect(computing(page)).toHaveLength(1);
    expect((await look(page)).coloured).toBeGreaterThan(0.5 * picture.coloured);

    const cage = Cage.read(await downloadedText(page, 'control'));
    expect(cage.counts.genus).toBe(2);
    expect((await progress(page)).evaluations).toBeGreaterThanOrEqual(evaluations);

    await measured(page);
    expect(await page.getByLabel('This surface').isChecked()).toBe(true);
    const before = await progress(page);
    await button(page, 'Start').click();
    await page.waitForFunction((count) => {
      const text = document.querySelector('#progress')?.textContent ?? '';
      return Number(/(\d+) evaluation/.exec(text)?.[1]) < count;
    }, before.evaluations);
    await evaluated(page, 2);
    const resumed = await progress(page);
    expect(resumed.level).toBeGreaterThanOrEqual(before.level);
    // The run continues from the copy, which was about a second old, not from the cage.
    expect(resumed.energy).toBeLessThan(1.5 * before.energy);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);
});
