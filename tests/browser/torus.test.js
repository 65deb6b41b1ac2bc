// SPDX-License-Identifier: MIT
/**
 * @file The torus page: the slider changes the torus, and the printed numbers agree with the closed forms.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { openAddress, screenshots, status } from './page.js';
import { difference, pictureOf } from './pictures.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** @param {string} [search] @param {import('playwright-core').BrowserContextOptions} [options] @param {(page: Page) => Promise<void>} [prepare] */
async function open(search = '', options = {}, prepare) {
  const address = `${served.url}torus.html${search}`;
  const permissions = ['clipboard-read', 'clipboard-write'];
  const watched = await openAddress(
    served.browser,
    address,
    { permissions, reducedMotion: 'reduce', ...options },
    prepare,
  );
  await watched.page.locator('.ratio:not(:empty)').waitFor();
  return watched;
}

/** @param {string} text as the page prints numbers */
const number = (text) => Number(text.replaceAll('\u202f', '').replaceAll('−', '-'));

/** The printed ratio and energies. @param {Page} page */
async function numbers(page) {
  /** @param {string} selector */
  const read = async (selector) => number(await page.locator(selector).innerText());
  return {
    ratio: await read('#numbers .ratio'),
    energy: await read('#numbers .energy'),
    bending: await read('[data-functional=bending] .here'),
    cross: await read('[data-functional=mvs_cross] .here'),
  };
}

/** @param {number} a */
const bendingOf = (a) => (4 * Math.PI ** 2) / (a * Math.sqrt(1 - a * a));
/** @param {number} a */
const crossOf = (a) => 8 * Math.PI ** 4 * (1 - a * a) ** -1.5;

/**
 * Seven digits are printed, so the relative rounding error is at most 5e-7; in powers of the ratio up to the fourth it
 * is at most four times that.
 * @param {number} value
 * @param {number} expected
 */
function expectPrinted(value, expected) {
  expect(Math.abs(value / expected - 1)).toBeLessThan(2e-6);
}

describe('the torus of least energy', () => {
  test('moves with the slider; its ratio and energies are the closed forms’', async () => {
    const { page, errors } = await open();
    expect((await numbers(page)).ratio).toBeCloseTo(0.2413, 4);
    const slider = page.locator('[name=share]');
    let [last, picture] = [Infinity, await pictureOf(page, page.locator('#surface'))];
    for (const share of [0.05, 0.3, 0.9]) {
      await slider.fill(String(1000 * share));
      const weights = `${Number((1 - share).toFixed(3))},${share}`.split(',').map(Number);
      await page.waitForFunction(
        (words) => location.search.includes(words),
        `bending:${weights[0]},mvs_cross:${weights[1]}`,
      );
      await page.waitForTimeout(200);
      const { ratio: a, energy, bending, cross } = await numbers(page);
      expectPrinted(((1 - a ** 2) * (1 - 2 * a ** 2)) / (6 * Math.PI ** 2 * a ** 3), weights[1] / weights[0]);
      expectPrinted(bending, bendingOf(a));
      expectPrinted(cross, crossOf(a));
      expectPrinted(energy, weights[0] * bending + weights[1] * cross);
      expect(a).toBeLessThan(last);
      const next = await pictureOf(page, page.locator('#surface'));
      expect(await difference(page, picture, next)).toBeGreaterThan(0.01);
      [last, picture] = [a, next];
    }
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('is told beside the paper’s, Clifford’s, and the thin one that none attains', async () => {
    const { page } = await open();
    /** @param {string} name */
    const press = (name) => page.getByRole('button', { name, exact: true }).click();
    const remark = page.locator('.remark');
    await remark.filter({ hasText: 'The paper prints 0.23.' }).waitFor();
    await press('0.95 : 0.05');
    await remark.filter({ hasText: 'The paper prints 0.5.' }).waitFor();
    expect((await numbers(page)).ratio).toBeCloseTo(0.4966, 4);
    await press('1 : 0');
    await remark.filter({ hasText: 'Clifford' }).waitFor();
    expectPrinted((await numbers(page)).ratio, Math.SQRT1_2);
    expectPrinted((await numbers(page)).energy, 8 * Math.PI ** 2);
    await press('0 : 1');
    await remark.filter({ hasText: 'none has it' }).waitFor();
    expectPrinted(
      number((await page.locator('#numbers .energy').innerText()).replace('infimum ', '')),
      8 * Math.PI ** 4,
    );
    const plots = (await page.locator('.plot').allTextContents()).join(' ');
    for (const words of ['8π⁴ as a → 0', 'Clifford 1⁄√2', '0.2413, paper 0.23', '0.4966, paper 0.5']) {
      expect(plots).toContain(words);
    }
    await page.context().close();
  }, 60_000);

  test('is read off the plot by keyboard and pointer', async () => {
    const { page } = await open();
    const plot = page.locator('#energies-plot svg');
    const values = page.locator('#energies-values');
    await plot.focus();
    await page.keyboard.press('ArrowRight');
    const words = await values.innerText();
    const [a, bending, cross, blend] = (words.match(/[\d.\u202f]+/g) ?? []).map(number);
    expect(a).toBeGreaterThan(0.4);
    expect(bending / bendingOf(a)).toBeCloseTo(1, 4);
    expect(cross / crossOf(a)).toBeCloseTo(1, 4);
    expect(blend / (bending + cross)).toBeCloseTo(1, 4);
    await plot.hover();
    expect(await values.innerText()).not.toBe(words);
    await page.context().close();
  });

  test('of any pair has an address that opens it again, and a mesh in the studio', async () => {
    const { page, errors } = await open('?weights=willmore:3,mehlum_tarrou:1&shading=kappa2&camera=5,50,1.1');
    expect(await page.locator('[name=second]').inputValue()).toBe('mehlum_tarrou');
    const { ratio } = await numbers(page);
    // Willmore is a quarter of bending, Mehlum–Tarrou 9/16 of MVS_cross.
    expectPrinted(
      ((1 - ratio ** 2) * (1 - 2 * ratio ** 2)) / (6 * Math.PI ** 2 * ratio ** 3),
      ((9 / 16) * 1) / (3 / 4),
    );
    await page.getByRole('button', { name: 'Copy address' }).click();
    await page.getByRole('button', { name: 'Copied' }).waitFor();
    const { search } = new URL(await page.evaluate(() => navigator.clipboard.readText()));
    expect(search).toBe('?weights=willmore:3,mehlum_tarrou:1&shading=kappa2&camera=5,50,1.1');
    await page.getByRole('link', { name: 'Open as a mesh in the studio' }).click();
    await status(page, /^Ready/);
    expect(await page.locator('[name=shape]').inputValue()).toBe('torus');
    expect(await page.locator('[name=weight-willmore]').inputValue()).toBe('3');
    expect(await page.locator('[name=weight-mvs_cross]').inputValue()).toBe('0');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('of an address that means nothing is the first one, with a notice', async () => {
    const { page } = await open('?weights=bending:1,length:2');
    expect(await page.locator('#notices').innerText()).toMatch(/“weights=bending:1,length:2”/);
    expect((await numbers(page)).ratio).toBeCloseTo(0.2413, 4);
    await page.context().close();
  });

  test('is read without WebGL', async () => {
    const { page, errors } = await open('', {}, async (fresh) => {
      await fresh.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
      });
    });
    await page.locator('svg.section circle').first().waitFor();
    expect((await numbers(page)).ratio).toBeCloseTo(0.2413, 4);
    expect(await page.locator('#ratio-plot path.curve').getAttribute('d')).toMatch(/^M/);
    expect(errors).toEqual([]);
    await page.screenshot({ path: path.join(screenshots, 'torus-without-webgl.png'), fullPage: true });
    await page.context().close();
  });

  test.each(/** @type {const} */ (['light', 'dark']))(
    'fits a phone in %s',
    async (colorScheme) => {
      const { page, errors } = await open('', { colorScheme, viewport: { width: 390, height: 844 } });
      await pictureOf(page, page.locator('#surface'));
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
      await page.screenshot({ path: path.join(screenshots, `torus-phone-${colorScheme}.png`), fullPage: true });
      expect(errors).toEqual([]);
      await page.context().close();
    },
    60_000,
  );
});

test('any two functionals can be blended, and the invariants that are not minimized stand below them', async () => {
  const { page, errors } = await open();
  for (const name of ['first', 'second']) {
    const offered = await page
      .locator(`[name=${name}] option`)
      .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value));
    expect(offered).toEqual(
      expect.arrayContaining(['mean_curvature_variation', 'second_form_variation', 'curvedness_variation', 'bending']),
    );
  }
  const a = (await numbers(page)).ratio;
  /** @param {string} id */
  const odd = async (id) => number(await page.locator(`[data-invariant=${id}] .here`).innerText());
  const b = 1 - a * a;
  expectPrinted(await odd('gradient_form'), 16 * Math.PI ** 5 * a ** -0.5 * b ** -1.5);
  expectPrinted(await odd('variation_form'), 16 * Math.PI ** 5 * a ** -0.5 * (1 - 3 * a * a) * b ** -2.5);
  expectPrinted(await odd('triple_form'), 48 * Math.PI ** 7 * a ** 0.5 * (1 + 4 * a * a) * b ** -3.5);
  // A thin torus is only approached, so that there is none whose invariants could be printed.
  await page.locator('[name=first]').selectOption('mean_curvature_variation');
  await page.locator('[name=second]').selectOption('second_form_variation');
  await page.locator('.energy').filter({ hasText: 'infimum' }).waitFor();
  expect(await page.locator('[data-invariant=triple_form] .here').innerText()).toBe('–');
  expect(errors).toEqual([]);
  await page.context().close();
}, 60_000);
