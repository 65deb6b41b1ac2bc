// SPDX-License-Identifier: MIT
/**
 * @file The glossary: every page has it, by a button and by a key; and every term of the studio opens it where it is
 * explained, by the keyboard and by touch.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { glossary, termWords } from '../../web/words/glossary.js';
import { measured, minimized, openAddress, openAdvanced, openDetails, screenshots, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const dialogOf = (/** @type {Page} */ page) => page.getByRole('dialog', { name: 'What the terms mean' });

test.each(['index.html', 'compare.html?entries=two-3.bending', 'torus.html', 'methods.html', 'studio.html'])(
  '%s has it, by a button and by a key, with all its terms',
  async (address) => {
    const { page, errors } = await openAddress(served.browser, served.url + address, {
      viewport: { width: 390, height: 700 },
    });
    await page.locator('main').waitFor();
    await page.locator('.brand').focus();
    await page.keyboard.press('g');
    await dialogOf(page).waitFor();
    expect(await dialogOf(page).locator('dt').allTextContents()).toEqual(glossary.map(({ name }) => name));
    const box = await dialogOf(page).boundingBox();
    expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 0) <= 390).toBe(true);
    await page.keyboard.press('Escape');
    expect(await dialogOf(page).count()).toBe(0);
    await page.getByRole('button', { name: 'Terms', exact: true }).click();
    await dialogOf(page).getByRole('button', { name: 'Close' }).click();
    expect(await dialogOf(page).count()).toBe(0);
    expect(errors).toEqual([]);
    await page.context().close();
  },
  60_000,
);

describe('a term', () => {
  test('opens it where it is explained, and gets the focus back', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html`);
    await measured(page);
    const genus = page.getByRole('button', { name: 'Genus' });
    await genus.focus();
    await page.keyboard.press('Enter');
    await dialogOf(page).waitFor();
    const focused = () => page.evaluate(() => document.activeElement?.textContent ?? '');
    expect(await focused()).toContain(termWords('genus').words);
    await page.screenshot({ path: path.join(screenshots, 'glossary.png') });
    await page.keyboard.press('Escape');
    expect(await focused()).toBe('Genus');
    // A letter that is pressed in a menu chooses there.
    await page.locator('[name=functional]').focus();
    await page.keyboard.press('g');
    expect(await dialogOf(page).count()).toBe(0);
    await page.context().close();
  }, 60_000);

  test('on the page of a result, open in all its details, is in the glossary, and within reach of a touch', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html`, {
      viewport: { width: 390, height: 844 },
      hasTouch: true,
    });
    await measured(page);
    await page.locator('#primary').click();
    await status(page, minimized, 60_000);
    await openAdvanced(page);
    await openDetails(page);
    const terms = await page.locator('main [data-term]').all();
    const ids = await Promise.all(terms.map((term) => term.getAttribute('data-term')));
    for (const id of [
      'cap',
      'family',
      'genus',
      'gradient',
      'hessian',
      'level',
      'metric',
      'symmetry',
      'tau',
      'tolerance',
    ])
      expect(ids).toContain(id);
    for (const [i, term] of terms.entries()) {
      expect(termWords(String(ids[i])).words.length).toBeGreaterThan(20);
      if (!(await term.isVisible())) continue;
      await term.tap();
      await dialogOf(page).locator('.meant').waitFor();
      expect(await dialogOf(page).locator('.meant').getAttribute('id')).toBe(`term-${ids[i]}`);
      await page.keyboard.press('Escape');
    }
    await page.context().close();
  }, 120_000);
});
