// SPDX-License-Identifier: MIT
/**
 * @file What the page says of a cage that was repaired and of energies that no surface has, and only of these.
 */
import path from 'node:path';
import { beforeAll, expect, test } from '@jest/globals';
import { Cage, load } from '../../wasm/umbilic.js';
import { allPixels, dropFile, energies, measured, openDetails, openPage, screenshots, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
let tetrahedronFrame = '';

beforeAll(async () => {
  await load();
  const cage = Cage.generate('tetrahedron-frame');
  tetrahedronFrame = cage.obj();
  cage.dispose();
});

/** A box without height: the upper square lies on the lower one, so that the surface covers a square twice. */
const flatBox = [
  ...[-1, 1].flatMap(() => ['v -1 -1 0', 'v 1 -1 0', 'v 1 1 0', 'v -1 1 0']),
  ...['f 1 4 3 2', 'f 5 6 7 8', 'f 1 2 6 5', 'f 2 3 7 6', 'f 3 4 8 7', 'f 4 1 5 8'],
].join('\n');

/** @param {Page} page @param {string} name @param {string} text */
async function open(page, name, text) {
  await dropFile(page, name, text);
  await page.locator('.facts').filter({ hasText: name }).waitFor();
  await status(page, /^Ready/);
  await measured(page);
}

test('a file whose faces are turned inside out is said to be repaired', async () => {
  const { page, errors } = await openPage(served.browser, served.url);
  const repairs = page.locator('.repairs');
  await open(page, 'frame.obj', tetrahedronFrame);
  expect(await repairs.innerText()).toBe('');
  const facts = await page.locator('.facts').innerText();
  const table = await energies(page);
  const turned = tetrahedronFrame.replace(/^f (.*)$/gm, (_, corners) => `f ${corners.split(' ').reverse().join(' ')}`);
  await open(page, 'turned.obj', turned);
  expect(await repairs.innerText()).toMatch(/^Repaired: turned \d+ faces, so that .* outward\.$/);
  expect((await page.locator('.facts').innerText()).replace('turned', 'frame')).toBe(facts);
  expect(await energies(page)).toEqual(table);
  expect(errors).toEqual([]);
  await page.context().close();
});

test.each(/** @type {const} */ (['light', 'dark']))(
  'a flat double cover ends below the bound, with a warning (%s)',
  async (colorScheme) => {
    const { page, errors } = await openPage(served.browser, served.url, {
      colorScheme,
      reducedMotion: 'reduce',
      ...allPixels,
    });
    const warning = page.locator('#energies .problem');
    expect(await warning.count()).toBe(0);
    await open(page, 'flat.obj', flatBox);
    await page.locator('[name=functional]').selectOption('bending');
    await measured(page);
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await status(page, /^No minimum/, 60_000);
    expect(await warning.first().innerText()).toMatch(/^No closed surface of this genus has so little energy/);
    await openDetails(page);
    expect(await page.locator('#levels').innerText()).toMatch(/below the bound/);
    expect(await page.locator('#limit').innerText()).not.toContain('±');
    await page.screenshot({ path: path.join(screenshots, `flat-double-cover-${colorScheme}.png`) });
    expect(errors).toEqual([]);
    await page.context().close();
  },
  90_000,
);

test('a surface that its Willmore energy proves to be embedded is said to be so, and no other', async () => {
  const { page } = await openPage(served.browser, served.url);
  const said = page.locator('#energies small');
  expect(await said.count()).toBe(0); // two-3 before it is minimized: 4.5 × 4π
  await page.locator('[name=shape]').selectOption('cube'); // nearly a sphere's 4π
  await said.waitFor();
  expect(await said.innerText()).toBe('embedded, as below 8π');
  expect(await page.locator('#energies tr:has(small)').innerText()).toMatch(/^Willmore energy/);
  await page.context().close();
});
