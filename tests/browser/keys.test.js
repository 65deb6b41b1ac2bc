// SPDX-License-Identifier: MIT
/**
 * @file With the keyboard alone, every page is entered past its header and lists its keys, and the keys do what the list says.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { measured, openAddress, screenshots } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** What has the focus. @param {Page} page */
const focused = (page) =>
  page.evaluate(() => {
    const { activeElement: active } = document;
    return active?.id || active?.getAttribute('aria-label') || active?.textContent || active?.tagName;
  });

const dialogOf = (/** @type {Page} */ page) => page.getByRole('dialog', { name: 'Keys' });

/** The keys of the list, and what each does. @param {Page} page */
const listed = async (page) =>
  Object.fromEntries(
    await dialogOf(page)
      .locator('dl > div')
      .evaluateAll((rows) => rows.map((row) => [...row.children].map(({ textContent }) => textContent))),
  );

describe.each([
  ['index.html', { '?': 'This list' }],
  ['compare.html?entries=two-3.bending', { F: 'Fit to the view' }],
  ['methods.html', { '?': 'This list' }],
  ['torus.html', { '← →': 'Read the next ratio of radii' }],
  ['studio.html', { 'Ctrl+S': 'Save the project', '+ −': 'Zoom in and out', 'Shift+Ctrl+Z Ctrl+Y': 'Redo' }],
])('%s', (address, some) => {
  test('is entered past its header, and lists its keys', async () => {
    const { page, errors } = await openAddress(served.browser, served.url + address, {
      viewport: { width: 390, height: 700 },
    });
    await page.locator('main').waitFor();
    await page.keyboard.press('Tab');
    expect(await focused(page)).toBe('Skip to the content');
    const shown = await page.locator('.skip').evaluate((link) => getComputedStyle(link).clipPath);
    expect(shown).toBe('none');
    await page.keyboard.press('Enter');
    expect(await page.evaluate(() => document.activeElement?.tagName)).toBe('MAIN');
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement?.closest('main') !== null)).toBe(true);
    expect(page.url()).not.toContain('#');

    await page.locator('.brand').focus();
    const here = await focused(page);
    await page.keyboard.press('?');
    await dialogOf(page).waitFor();
    expect(await focused(page)).toBe('Close');
    expect(await listed(page)).toMatchObject(some);
    const box = await dialogOf(page).boundingBox();
    expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 0) <= 390).toBe(true);
    await page.keyboard.press('Escape');
    expect([await dialogOf(page).count(), await focused(page)]).toEqual([0, here]);
    await page.getByRole('button', { name: 'Keys' }).click();
    await page.getByRole('button', { name: 'Close', exact: true }).click();
    expect(await dialogOf(page).count()).toBe(0);
    // Every picture that takes keys has a name, and says which.
    for (const canvas of await page.locator('canvas').all()) {
      expect(await canvas.getAttribute('aria-label')).toMatch(/\w/);
      const id = await canvas.getAttribute('aria-describedby');
      expect(await page.locator(`[id="${id}"]`).textContent()).toMatch(/Arrow keys turn/);
    }
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);
});

describe('in the studio', () => {
  test('a question mark that is typed into a field is a letter, and listed keys do what they say', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html`);
    await measured(page);
    await page.locator('[name=within]').focus();
    await page.keyboard.press('?');
    expect(await page.locator('[name=within]').inputValue()).toBe('?');
    expect(await dialogOf(page).count()).toBe(0);
    await page.locator('[name=within]').fill('');

    await page.locator('canvas').focus();
    await page.keyboard.press('ArrowLeft');
    await page.waitForFunction(() => location.search.includes('camera='));
    await page.locator('[name=functional]').selectOption('bending');
    await page.keyboard.press('Control+z');
    expect(await page.locator('[name=functional]').inputValue()).toBe('mvs_cross');
    await page.keyboard.press('Shift+Control+z');
    expect(await page.locator('[name=functional]').inputValue()).toBe('bending');
    await Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]);
    await page.keyboard.press('?');
    await dialogOf(page).waitFor();
    await page.screenshot({ path: path.join(screenshots, 'keys.png') });
    await page.context().close();
  }, 60_000);
});
