// SPDX-License-Identifier: MIT
/**
 * @file How long a run takes, as the studio tells it: before Start, and while it goes on.
 */
import { expect, test } from '@jest/globals';
import { measured, minimized, openPage, status } from './page.js';
import { servedPage } from './served.js';

const served = servedPage();

test('what a run takes is said below Start and follows the settings; while it runs, a bar only moves forward', async () => {
  const { page, errors } = await openPage(served.browser, served.url);
  await measured(page);
  const line = page.locator('#progress');
  const words = /^Takes (a second|about (\d+ (s|min|h|days)|a minute|an hour))$/;
  await line.filter({ hasText: words }).waitFor();
  expect(await page.locator('#patience').isVisible()).toBe(false);
  expect(await page.locator('#done').isVisible()).toBe(false);

  await page.locator('[name=functional]').selectOption('mvs');
  await page.getByLabel('Keep symmetry').uncheck();
  await page.locator('[name=last]').selectOption('5');
  await page
    .locator('#patience')
    .filter({ hasText: /^This will take about \d+ (min|h), of which level \d takes/ })
    .waitFor();

  await page.getByLabel('Keep symmetry').check();
  await page.locator('[name=last]').selectOption('3');
  await measured(page);
  await line.filter({ hasText: words }).waitFor();
  expect(await page.locator('#patience').isVisible()).toBe(false);
  const seen = await page.evaluateHandle(() => {
    const bar = /** @type {HTMLProgressElement} */ (document.querySelector('#done'));
    const text = /** @type {Element} */ (document.querySelector('#progress'));
    /** @type {{share: number, text: string}[]} */
    const seen = [];
    new MutationObserver(() => !bar.hidden && seen.push({ share: bar.value, text: text.textContent ?? '' })).observe(
      text,
      {
        childList: true,
        subtree: true,
        characterData: true,
      },
    );
    return seen;
  });
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, minimized, 120_000);
  expect(await page.locator('#done').isVisible()).toBe(false);
  const told = await seen.jsonValue();
  const shares = told.map(({ share }) => share);
  expect(shares.length).toBeGreaterThan(3);
  expect(shares).toEqual(shares.toSorted((one, other) => one - other));
  expect(shares.at(-1)).toBeGreaterThan(0.2);
  expect(told.some(({ text }) => / left$/.test(text))).toBe(true);
  expect(errors).toEqual([]);
}, 180_000);
