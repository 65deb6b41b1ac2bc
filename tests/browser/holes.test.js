// SPDX-License-Identifier: MIT
/**
 * @file A user meets the catalog's holes: finds their rows, reads what is held, takes the cage, minimizes one again in the
 * studio, and compares two.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { energyWords } from '../../web/words/entries.js';
import { builtPage, detailsCut, minimized, openAddress, screenshots, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */

const served = servedPage();
/** @type {Catalog} */
const catalog = JSON.parse(readFileSync(path.join(builtPage, 'catalog/catalog.json'), 'utf8'));

/** @param {string} search @param {import('playwright-core').BrowserContextOptions} [options] */
const open = (search, options) => openAddress(served.browser, `${served.url}${search}`, options);

describe('a hole in the catalog', () => {
  test('has a row that says that it is open and what is held, and one entry', async () => {
    const { page, errors } = await open('?search=hole');
    const rows = page.locator('#table tbody tr');
    await rows.first().waitFor();
    expect(await rows.evaluateAll((all) => all.map((row) => row.getAttribute('data-shape')))).toEqual(
      [3, 4, 5, 6, 7, 8].map((sides) => `hole-${sides}`),
    );
    expect(await rows.nth(2).locator('th').innerText()).toMatch(/5-sided hole\s+curvature held\s+C5v, order 10/);
    expect(await rows.nth(2).locator('td.genus').innerText()).toMatch(/^0\s+open$/);
    expect(await rows.nth(2).locator('.entry').count()).toBe(1);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('has what was minimized, with the constant area, in its details beside the whole surface’s energies', async () => {
    const { page, errors } = await open('?entry=hole-8.mvs_cross');
    const details = page.getByRole('dialog', { name: '8-sided hole' });
    await details.waitFor();
    const entry = catalog.entries.find(({ shape }) => shape === 'hole-8');
    const objective = details.locator('table.energies .objective');
    expect(await objective.locator('th').innerText()).toMatch(/with the constant area A₀$/);
    expect(await objective.locator('td').innerText()).toBe(entry?.energies.free?.mvs_cross.toPrecision(8));
    expect((await details.locator('.note').allInnerTexts()).join(' ')).toMatch(/A is constant: A₀ = \d/);
    const facts = await details.locator('.facts').innerText();
    expect(facts).toMatch(/0, open/);
    expect(facts).toMatch(/curvature held, that of the cage’s own surface/);
    expect(await details.locator('pre').innerText()).toMatch(/--boundary curvature --holes hole/);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      details.getByRole('button', { name: 'Cage', exact: true }).click(),
    ]);
    expect(download.suggestedFilename()).toBe('hole-8.cage.obj');
    expect(readFileSync(await download.path(), 'utf8')).toMatch(/^g hole$/m);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('opens in the studio with its condition, is minimized again to the same energy, and is compared with another', async () => {
    const { page, errors } = await open('studio.html?shape=hole-5&functional=mvs_cross');
    const condition = page.getByRole('combobox', { name: 'What is held at boundary 1' });
    await condition.waitFor({ state: 'attached' });
    expect(await condition.inputValue()).toBe('curvature');
    const entry = catalog.entries.find(({ shape }) => shape === 'hole-5');
    if (!entry) throw new Error('the catalog has no hole of five sides');
    const { value, error } = energyWords(entry);
    await page.locator('#entry').getByText(`${value} ± ${error}`).waitFor();
    await page.screenshot({ path: path.join(screenshots, 'hole-studio.png') });
    const compare = await page.locator('#entry a').getAttribute('href');
    expect(compare).toBe('./compare.html?entries=hole-5.mvs_cross,hole-4.mvs_cross');
    await page.getByRole('button', { name: 'Minimize again from the cage' }).click();
    await status(page, minimized, 100_000);
    expect(await condition.inputValue()).toBe('curvature');
    expect(await page.locator('#energies tbody tr').first().innerText()).toContain(value.slice(0, -2));
    expect(await page.evaluate(() => location.search)).not.toContain('n-sided');
    expect(errors).toEqual([]);

    await page.goto(`${served.url}${String(compare).slice(2)}`);
    await page.locator('#energies tbody tr').first().waitFor();
    const functional = page.getByRole('combobox', { name: 'Functional 1' });
    expect(await functional.locator('option').count()).toBe(1);
    await page.getByRole('combobox', { name: 'Shape 2' }).selectOption('two-3');
    expect(await page.getByRole('combobox', { name: 'Functional 2' }).locator('option').count()).toBe(
      catalog.functionals.length,
    );
    await page.screenshot({ path: path.join(screenshots, 'hole-compare.png') });
    await page.context().close();
  }, 180_000);
});

describe('a picture', () => {
  test.each(
    /** @type {Array<[string, import('playwright-core').BrowserContextOptions]>} */ ([
      ['light', { colorScheme: 'light', viewport: { width: 1440, height: 900 } }],
      ['dark', { colorScheme: 'dark', viewport: { width: 1440, height: 900 } }],
      ['phone', { colorScheme: 'light', viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }],
      ['phone-dark', { colorScheme: 'dark', viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }],
    ]),
  )('is taken of the rows of holes and of details in %s; nothing is cut off', async (name, options) => {
    const { page, errors } = await open('', options);
    const row = page.locator('tr[data-shape="hole-3"]');
    await row.waitFor();
    await row.scrollIntoViewIfNeeded();
    await row.evaluate((element) => element.scrollIntoView({ block: 'start' }));
    await page.mouse.wheel(0, -150);
    await page.waitForLoadState('networkidle');
    await page.screenshot({ path: path.join(screenshots, `holes-${name}.png`) });
    const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    expect(await overflow()).toBeLessThanOrEqual(0);
    expect(await detailsCut(page, `${served.url}?entry=hole-5.mvs_cross`, `hole-details-${name}`)).toBeLessThanOrEqual(
      0,
    );
    expect(errors).toEqual([]);
    await page.context().close();
  });
});
