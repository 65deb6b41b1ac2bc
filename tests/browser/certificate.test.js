// SPDX-License-Identifier: MIT
/**
 * @file What the page says about a result: the symmetry that the run kept, the limit with its error bar, and the
 * certificate; by mouse and by keyboard.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import {
  allPixels,
  downloadedText,
  measured,
  minimized,
  openAdvanced,
  openDetails,
  openPage,
  screenshots,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** @param {Page} page @param {string} shape @param {string} functional */
async function choose(page, shape, functional) {
  await page.locator('[name=shape]').selectOption(shape);
  await page.locator('[name=functional]').selectOption(functional);
  await page.locator('#energies .objective').waitFor();
}

/** @param {Page} page */
async function minimize(page) {
  await page.locator('#primary').click();
  await status(page, minimized, 60_000);
}

/** @param {Page} page */
const certify = (page) => page.locator('#certificate .row button');
/** @param {Page} page */
const answer = (page) => page.locator('#certificate [role=status]');

describe('symmetry', () => {
  test('is named, is kept unless it is switched off by the keyboard, and leaves fewer unknowns', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    const keep = page.getByRole('switch', { name: 'Keep symmetry' });
    const group = page.locator('#group');
    expect(await keep.isChecked()).toBe(true);
    expect(await group.textContent()).toBe('D3h, order 12');
    expect(await group.locator('sub').textContent()).toBe('3h');
    await choose(page, 'torus', 'bending');
    await group.filter({ hasText: 'D6h, order 24' }).waitFor();
    await page.locator('[name=last]').selectOption('0');
    await measured(page);

    const unknowns = [];
    for (const expected of [true, false]) {
      expect(await keep.isChecked()).toBe(expected);
      await minimize(page);
      await page.locator('#levels tbody tr').first().waitFor({ state: 'attached' });
      const title = await page.locator('#levels tbody tr').first().getAttribute('title');
      unknowns.push(Number(/(\d+) unknowns/.exec(title ?? '')?.[1]));
      await page.getByRole('button', { name: 'Reset' }).click();
      await status(page, /^Ready/);
      if (!expected) break;
      await keep.focus();
      await page.keyboard.press('Space');
      await page.locator('#group:empty').waitFor({ state: 'attached' });
      await measured(page);
    }
    expect(unknowns[1]).toBe(3 * 48);
    expect(unknowns[0]).toBeLessThan(unknowns[1] / 12);
    expect(await page.getByRole('switch', { name: 'Keep symmetry', disabled: true }).count()).toBe(0);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);
});

describe('the limit', () => {
  test('has an error bar where the levels converge, and the energies that they converge to within it', async () => {
    const { page } = await openPage(served.browser, served.url);
    await choose(page, 'torus', 'bending');
    await minimize(page);
    await openDetails(page);
    const text = await page.locator('#limit p').first().innerText();
    const [value, error] = text.match(/[\d.]+/g)?.map(Number) ?? [];
    // The bar ends at the energy of Clifford's torus, below which no torus is.
    expect(text).toMatch(
      /^Limit of the levels: \d+\.\d+ ± 0\.00\d+, observed order \d\.\d, but not below 78\.95683, as no surface is\.$/,
    );
    expect(Math.abs(value - 8 * Math.PI ** 2)).toBeLessThanOrEqual(error); // Clifford's torus
    const metrics = await page.locator('#levels tbody td:nth-child(5)').allInnerTexts();
    expect(metrics).toEqual(['Hessian', 'Hessian', 'Hessian']);
    await page.context().close();
  }, 60_000);

  test('asks for one more level where there are two', async () => {
    const { page } = await openPage(served.browser, served.url);
    await choose(page, 'torus', 'bending');
    await page.locator('[name=last]').selectOption('1');
    await measured(page);
    await minimize(page);
    expect(await page.locator('#status').innerText()).toMatch(/takes a finer mesh to tell\.$/);
    await page.getByRole('button', { name: 'Go one level finer' }).click();
    await status(page, /^Minimized: 78\.9\d*, within 0\.\d+\u202f%\.$/, 60_000);
    expect(await page.locator('[name=last]').inputValue()).toBe('2');
    await openDetails(page);
    expect(await page.locator('#levels tbody tr').count()).toBe(3);
    await page.context().close();
  }, 60_000);
});

describe('a certificate', () => {
  test('is given by the keyboard, of a minimum and of what is one only within its symmetry, and is in the report', async () => {
    const { page, errors } = await openPage(served.browser, served.url, allPixels);
    expect(await certify(page).getAttribute('aria-disabled')).toBe('true');
    await page.locator('[name=last]').selectOption('1');
    await measured(page);
    await minimize(page);
    await certify(page).focus();
    await page.keyboard.press('Enter');
    await answer(page).filter({ hasText: 'lower' }).waitFor();
    expect(await answer(page).textContent()).toMatch(
      /^No: \d+ directions lower the energy, and break its symmetry \(D3h\)\.$/,
    );
    expect(await page.locator('#certificate .numbers').textContent()).toMatch(/^282 unknowns, τ\s=\s0\.001$/);
    expect(await page.locator('#status').innerText()).toMatch(/^Not a minimum: .*; \d+ directions lower the energy\.$/);
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Descend');
    expect(await page.locator('#next').innerText()).toBe('Descend');
    await page.screenshot({ path: path.join(screenshots, 'certified.png'), fullPage: true });

    const report = JSON.parse(await downloadedText(page, 'report'));
    expect(report).toMatchObject({
      group: { name: 'D3h', order: 12 },
      limit: { status: 'too_few_levels', order: null, error: null },
      certificate: { level: 1, unknowns: 282, gauge: 7, tau: 0.001 },
      levels: [{ metric: 'hessian' }, { metric: 'hessian' }],
    });
    expect(report.certificate.negative).toBeGreaterThan(0);

    await page.locator('#next').press('Enter');
    await status(page, /^Minimizing/);
    await page.locator('#group').filter({ hasNotText: 'D3h' }).waitFor();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await status(page, /^Stopped/);
    await page.locator('[name=last]').selectOption('1');

    await choose(page, 'cube', 'bending');
    await page.locator('#certificate [role=status]:empty').waitFor({ state: 'attached' });
    await minimize(page);
    await certify(page).click();
    await answer(page).filter({ hasText: 'Yes: on this mesh no surface near it has less energy.' }).waitFor();
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('is cancelled while it is made; the surface stays as it is', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await page.locator('[name=functional]').selectOption('bending');
    await page.locator('[name=last]').selectOption('4');
    await measured(page);
    await minimize(page);
    const [told, table] = [await page.locator('#status').innerText(), await page.locator('#energies').innerText()];
    await certify(page).click();
    await page.getByRole('progressbar', { name: 'Looking for surfaces' }).waitFor();
    expect(await page.locator('#downloads [name=save]').getAttribute('aria-disabled')).toBe('true');
    await page.keyboard.press('Enter'); // the button that was clicked, now Cancel
    await certify(page).filter({ hasText: 'Check' }).waitFor();
    expect(await page.getByRole('progressbar', { name: 'Looking for surfaces' }).count()).toBe(0);
    expect(await answer(page).textContent()).toBe('');
    await page.locator('#certificate .row button:not([aria-disabled=true])').waitFor();
    expect(await page.locator('#status').innerText()).toBe(told);
    expect(await page.locator('#energies').innerText()).toBe(table);
    expect(await page.locator('#alert').isVisible()).toBe(false);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('that cannot be given says why', async () => {
    const { page } = await openPage(served.browser, served.url);
    await choose(page, 'cube', 'bending');
    await openAdvanced(page);
    await page.getByLabel('Flat').check();
    await page.locator('[name=last]').selectOption('1');
    await measured(page);
    await page.locator('#primary').click();
    await status(page, /^(Minimized|The energy|Stopped|Ended)/, 60_000);
    await certify(page).click();
    await page.locator('#alert').filter({ hasText: 'Whether it is a minimum cannot be told' }).waitFor();
    expect(await page.locator('#alert').innerText()).toMatch(/cap flat/);
    await page.context().close();
  }, 60_000);
});
