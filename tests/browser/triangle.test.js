// SPDX-License-Identifier: MIT
/**
 * @file The triangle of a blend in a browser: by mouse, by touch and by keys, on wide and narrow screens, and how a run
 * follows it; and the odd invariants in the table of energies.
 */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import {
  allPixels,
  energies,
  evaluated,
  measured,
  minimized,
  openAddress,
  recordEvents,
  screenshots,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const WIDE = { viewport: { width: 1440, height: 900 } };
const PHONE = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

/** @param {string} [search] @param {import('playwright-core').BrowserContextOptions} [options] @param {(page: Page) => Promise<void>} [prepare] */
async function open(search = '', options = WIDE, prepare) {
  const watched = await openAddress(served.browser, `${served.url}studio.html${search}`, options, prepare);
  await measured(watched.page);
  await watched.page.locator('[name=functional]').selectOption('blend');
  return watched;
}

/** @param {Page} page */
const plane = (page) => page.getByRole('slider', { name: 'Point of the blend' });

/** The weights in the fields, without those that are 0. @param {Page} page @returns {Promise<Record<string, number>>} */
async function weights(page) {
  const all = await page
    .locator('#weights input[type=number]')
    .evaluateAll((inputs) =>
      inputs.map((input) => [
        /** @type {HTMLInputElement} */ (input).name.replace('weight-', ''),
        /** @type {HTMLInputElement} */ (input).valueAsNumber,
      ]),
    );
  return Object.fromEntries(all.filter(([, weight]) => weight !== 0));
}

/** The shares that are written at the corners: top, left, right. @param {Page} page */
const shares = (page) => page.locator('#triangle .share').allInnerTexts();

/** Where shares of top and right lie on the screen. @param {Page} page @param {number} top @param {number} right */
async function placeOf(page, top, right) {
  await plane(page).scrollIntoViewIfNeeded();
  const box = await page.locator('#triangle polygon').boundingBox();
  if (!box) throw new Error('no triangle');
  return /** @type {const} */ ([box.x + box.width * (right + top / 2), box.y + box.height * (1 - top)]);
}

/** @param {Page} page */
const corners = (page) =>
  page
    .locator('#triangle select')
    .evaluateAll((all) => all.map((select) => /** @type {HTMLSelectElement} */ (select).value));

describe('the triangle of a blend', () => {
  test('has three functionals, and says what weighs beside them until its point is moved by the mouse, which is one step', async () => {
    const { page, errors } = await open();
    expect(await corners(page)).toEqual(['mean_curvature_variation', 'second_form_variation', 'bending']);
    expect(await page.locator('#triangle').innerText()).toContain('MVS cross also weighs');
    expect(await shares(page)).toEqual(['0\u202f%', '0\u202f%', '50\u202f%']);
    await page.mouse.move(...(await placeOf(page, 0.2, 0.2)));
    await page.mouse.down();
    await page.mouse.move(...(await placeOf(page, 0.5, 0.3)), { steps: 5 });
    // Outside, the nearest place on the foot is meant.
    await page.mouse.move(...(await placeOf(page, -0.2, 0.6)), { steps: 5 });
    await page.mouse.up();
    const moved = await weights(page);
    expect(Object.keys(moved).sort()).toEqual(['bending', 'second_form_variation']);
    expect(Math.abs(moved.bending - 0.5)).toBeLessThan(0.01);
    expect(moved.bending + moved.second_form_variation).toBeCloseTo(1, 12);
    expect(await page.locator('#triangle').innerText()).not.toContain('also weighs');
    await page.waitForFunction(() => location.search.includes('weights='));
    await settled(page);
    await page.locator('#undo').click();
    expect(await weights(page)).toEqual({ bending: 0.5, mvs_cross: 0.5 });
    await page.locator('#redo').click();
    expect(await weights(page)).toEqual(moved);
    // The address opens the same point.
    await settled(page);
    const again = await openAddress(served.browser, page.url(), WIDE);
    await measured(again.page);
    expect(await weights(again.page)).toEqual(moved);
    expect([...errors, ...again.errors]).toEqual([]);
    await page.context().close();
    await again.page.context().close();
  }, 60_000);

  test('is moved by keys, with a visible focus; a key that is held is one step', async () => {
    const { page, errors } = await open();
    await page.getByRole('combobox', { name: 'Functional at the top corner' }).focus();
    await page.keyboard.press('Tab');
    expect(await plane(page).evaluate((element) => element === document.activeElement)).toBe(true);
    expect(await plane(page).evaluate((element) => getComputedStyle(element).outlineStyle)).toBe('solid');
    for (const [key, expected] of /** @type {Array<[string, string[]]>} */ ([
      ['1', ['100', '0', '0']],
      ['2', ['0', '100', '0']],
      ['End', ['0', '0', '100']],
      ['Home', ['100', '0', '0']],
      ['0', ['33.3', '33.3', '33.4']],
      ['ArrowRight', ['33.3', '32.3', '34.4']],
      ['Shift+ArrowLeft', ['33.3', '42.3', '24.4']],
    ])) {
      await page.keyboard.press(key);
      expect(await shares(page)).toEqual(expected.map((share) => `${share}\u202f%`));
    }
    expect(await plane(page).getAttribute('aria-valuetext')).toBe(
      'Mean curvature 33.3\u202f%, Second form 42.3\u202f%, Bending 24.4\u202f%',
    );
    await settled(page);
    for (let i = 0; i < 8; i++) await page.keyboard.down('ArrowUp');
    await page.keyboard.up('ArrowUp');
    expect((await shares(page))[0]).toBe('41.3\u202f%');
    await settled(page);
    await page.locator('#undo').click();
    expect((await shares(page))[0]).toBe('33.3\u202f%');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('takes any functional at a corner; one that is at another changes places with it', async () => {
    const { page, errors } = await open();
    await plane(page).press('0');
    const top = page.getByRole('combobox', { name: 'Functional at the top corner' });
    expect(await top.locator('option').count()).toBe(8);
    await top.selectOption('curvedness_variation');
    expect(await weights(page)).toEqual({ bending: 0.334, second_form_variation: 0.333, curvedness_variation: 0.333 });
    await page.getByRole('combobox', { name: 'Functional at the left corner' }).selectOption('bending');
    expect(await corners(page)).toEqual(['curvedness_variation', 'bending', 'second_form_variation']);
    expect(await weights(page)).toEqual({ bending: 0.334, second_form_variation: 0.333, curvedness_variation: 0.333 });
    await page.locator('[name=functional]').selectOption('bending');
    expect(await page.locator('#triangle').isVisible()).toBe(false);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('leads a run, which goes on with each new point', async () => {
    const { page, errors } = await open('', WIDE, recordEvents);
    await plane(page).press('3');
    for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('2');
    await settled(page);
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await evaluated(page, 3);
    await plane(page).press('Shift+ArrowLeft');
    await page.waitForFunction(() =>
      /** @type {any} */ (window).recordedEvents().some((/** @type {any} */ { name }) => name === 'retargeted'),
    );
    expect(await weights(page)).toEqual({ bending: 0.9, second_form_variation: 0.1 });
    const objective = '0.9 × Bending energy + 0.1 × Variation of the second form';
    await page.locator(`#energies .objective th[title="${objective}"]`).waitFor();
    await status(page, minimized, 60_000);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);

  test('is moved by a finger on a phone, and fits the page there', async () => {
    const { page, errors } = await open('', PHONE);
    await page.touchscreen.tap(...(await placeOf(page, 0.5, 0.25)));
    const [top, left, right] = (await shares(page)).map(Number.parseFloat);
    expect(Math.abs(top - 50) + Math.abs(left - 25) + Math.abs(right - 25)).toBeLessThan(5);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test.each(/** @type {const} */ (['light', 'dark']))(
    'fits its panel on wide and narrow pages in %s',
    async (colorScheme) => {
      const { page } = await open('', { ...WIDE, colorScheme, ...allPixels });
      await plane(page).press('0');
      for (const width of [1440, 1024, 390]) {
        await page.setViewportSize({ width, height: 844 });
        const file = `triangle-${colorScheme}-${width}.png`;
        await page.locator('#triangle').screenshot({ path: path.join(screenshots, file) });
        const [panel, ...parts] = await page
          .locator('#objective, #triangle, #triangle > *:not(.hidden, [hidden])')
          .evaluateAll((all) =>
            all.map((one) => {
              const { left, right } = one.getBoundingClientRect();
              return { left, right };
            }),
          );
        expect(parts).toHaveLength(6);
        for (const { left, right } of parts) {
          expect(left).toBeGreaterThanOrEqual(panel.left - 0.5);
          expect(right).toBeLessThanOrEqual(panel.right + 0.5);
        }
      }
      await page.context().close();
    },
    60_000,
  );
});

test('the table of energies has the odd invariants below the functionals, with what they are; without caps it has none', async () => {
  const { page, errors } = await openAddress(served.browser, `${served.url}studio.html?shape=torus`, WIDE);
  await measured(page);
  const odd = page.locator('#energies .invariants');
  await odd.locator('tr').nth(3).waitFor();
  expect(await odd.innerText()).toMatch(/change sign when the normal flips, so they are evaluated and never minimized/);
  const rows = Object.entries(await energies(page)).filter(([name]) => /^J/.test(name));
  expect(rows.map(([name]) => name)).toEqual([
    'J₃ A3/2 ∫ II(2∇H, 2∇H) dA',
    'J₄ A3/2 ∫ IIijCiklCjkl dA',
    'J₆ A5/2 ∫ IIiaIIjbIIkcCijkCabc dA',
  ]);
  for (const [, value] of rows) expect(value).toMatch(/^\d/);
  await odd.getByRole('button', { name: 'Odd invariants' }).click();
  expect(await page.locator('dialog[open]').innerText()).toContain('Even invariants');
  await page.keyboard.press('Escape');

  const bare = await openAddress(
    served.browser,
    `${served.url}studio.html?shape=two-3&functional=bending&start=cage&cap=none`,
    WIDE,
  );
  await bare.page.locator('#energies').getByText('diverges').first().waitFor();
  expect(await bare.page.locator('#energies .invariants tr').count()).toBe(0);
  expect([...errors, ...bare.errors]).toEqual([]);
  await page.context().close();
  await bare.page.context().close();
}, 60_000);
