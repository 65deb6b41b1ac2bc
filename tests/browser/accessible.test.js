// SPDX-License-Identifier: MIT
/**
 * @file Everyone can read and use the pages, in light and in dark: the contrast of every text, axe-core's rules for
 * WCAG 2.2 at level AA, and notices that cover no button.
 */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { readTexts } from './contrast.js';
import { fish } from './fish.js';
import {
  allPixels,
  drawn,
  dropFile,
  measured,
  minimized,
  openAddress,
  openAdvanced,
  openDetails,
  screenshots,
  status,
} from './page.js';
import { plate } from './plate.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const broken = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n';

/** Opens a broken file in the studio, so that its notice appears. @param {Page} page */
async function breakFile(page) {
  await measured(page);
  await drawn(page);
  await dropFile(page, 'broken.obj', broken);
  await page.locator('#alert').waitFor();
}

/** @param {Page} page */
async function minimize(page) {
  await measured(page);
  await page.locator('[name=functional]').selectOption('bending');
  await page.locator('#primary').click();
  await status(page, minimized, 60_000);
  await page.locator('#downloads [name=save]:not([aria-disabled=true])').waitFor();
}

/** A blend that weighs something at no corner of its triangle, whose point has the focus. @param {Page} page */
async function blend(page) {
  await measured(page);
  await page.locator('[name=functional]').selectOption('blend');
  await page.getByRole('slider', { name: 'Point of the blend' }).focus();
  await drawn(page);
}

/** @param {Page} page */
async function details(page) {
  await minimize(page);
  await openAdvanced(page);
  await openDetails(page);
  await page.locator('#next').click(); // the check
  await page.locator('#certificate summary').click();
}

/** Holds a group and the faces around it, and pins a vertex. @param {Page} page */
async function hold(page) {
  await measured(page);
  await dropFile(page, 'fish.obj', fish());
  await page.getByRole('checkbox', { name: /^head/ }).check();
  await page.getByRole('radio', { name: 'Paint', exact: true }).check();
  await page.getByRole('button', { name: 'Grow', exact: true }).click();
  await page.getByRole('radio', { name: 'Pin', exact: true }).check();
  await page.getByRole('spinbutton', { name: 'Vertex' }).fill('1');
  await page.getByRole('button', { name: 'Pin it' }).click();
  await page.locator('#show summary').click();
  await status(page, /^Ready/);
  await drawn(page);
}

/** Selects a part of a cage, and asks for an edit that is refused. @param {Page} page */
async function edit(page) {
  await measured(page);
  await dropFile(page, 'fish.obj', fish());
  await page.getByRole('radio', { name: 'Edit', exact: true }).check();
  await page
    .locator('#cage-edited')
    .filter({ hasText: /^Nothing is selected/ })
    .waitFor();
  await page.locator('#cage-editing [name=faces]').fill('1-3');
  await page.getByRole('button', { name: 'Bridge', exact: true }).click();
  await page.locator('#cage-edited.problem').waitFor();
  await drawn(page);
}

/** Opens a cage with two boundaries, of which one is filled and the other has a condition that is refused. @param {Page} page */
async function fillAndRefuse(page) {
  await measured(page);
  await dropFile(page, 'plate.obj', plate());
  await page.getByRole('button', { name: 'Fill boundary 2' }).click();
  await page.locator('#held-count').filter({ hasText: '20 of 36 faces held' }).waitFor();
  // Held faces beside it would tell the curvature at a boundary.
  await page.getByRole('radio', { name: 'Paint', exact: true }).check();
  await page.getByRole('button', { name: 'Invert', exact: true }).click();
  await page.getByRole('combobox', { name: 'What is held at boundary 1' }).selectOption('curvature');
  await page.locator('#boundaries .problem').filter({ hasText: 'curvature' }).waitFor();
  await page.locator('[name=shading]').selectOption('deviation');
  await page.locator('#legend summary').click();
  await page.locator('#camera summary').click();
  await drawn(page);
}

/** @param {Page} page */
async function notice(page) {
  await page.locator('#notices').waitFor();
}

/** @param {Page} page */
const catalogShown = (page) => page.locator('#table .entry').first().waitFor();
const phone = { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true };

/**
 * Pages, what is done on each before it is checked, and where it is shown if not on a wide screen.
 * @type {Array<[name: string, address: string, prepare: (page: Page) => Promise<unknown>, device?: typeof phone]>}
 */
const states = [
  ['the catalog', 'index.html', catalogShown],
  ['the catalog on a phone', 'index.html', catalogShown, phone],
  ['the catalog with a notice', 'index.html?genus=nothing', notice],
  [
    'the catalog with an entry’s details',
    'index.html?entry=cube-frame.mvs',
    (page) => page.locator('#details[open] h2').first().waitFor(),
  ],
  [
    'the invitation to open a cage',
    'studio.html#open',
    async (page) => {
      await measured(page);
      await page.locator('#invitation').waitFor();
    },
  ],
  ['the studio with a notice', 'studio.html', breakFile],
  ['the studio with held parts', 'studio.html', hold],
  ['the studio that edits a cage', 'studio.html', edit],
  ['the studio with boundaries', 'studio.html', fillAndRefuse],
  ['the studio with a blend', 'studio.html', blend],
  ['the studio with a blend on a phone', 'studio.html', blend, phone],
  ['the studio after a run', 'studio.html', minimize],
  ['the studio with all details open', 'studio.html', details],
  [
    'the glossary at a term',
    'studio.html',
    async (page) => {
      await measured(page);
      await page.getByRole('button', { name: 'Genus' }).click();
    },
  ],
  [
    'the comparison with a notice',
    'compare.html?entries=two-3.bending,two-99.bending&shading=red',
    async (page) => {
      await notice(page);
      await page.locator('#energies td').first().waitFor();
      await page.getByText('Loading …').first().waitFor({ state: 'hidden' });
      await drawn(page);
    },
  ],
  ['the page of tori', 'torus.html', (page) => page.locator('#energies-plot svg').waitFor()],
  [
    'the page of methods',
    'methods.html',
    (page) =>
      page
        .locator('#theme')
        .filter({ hasText: /Dark|Light/ })
        .waitFor(),
  ],
  [
    'the list of keys',
    'torus.html',
    async (page) => {
      await page.locator('#energies-plot svg').waitFor();
      await page.keyboard.press('?');
    },
  ],
];

/** @param {Page} page */
async function expectLegible(page) {
  const texts = await readTexts(page);
  expect(texts.length).toBeGreaterThan(20);
  expect(texts.filter(({ contrast, least }) => contrast < least)).toEqual([]);
}

/** @param {Page} page @returns {Promise<string[]>} rules that are violated, and where */
async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
    const found = await /** @type {any} */ (window).axe.run(document, { runOnly: tags });
    return found.violations.map(
      (/** @type {any} */ { id, nodes }) =>
        `${id}: ${nodes.map((/** @type {any} */ node) => `${node.target} (${node.failureSummary})`).join('; ')}`,
    );
  });
}

describe.each(/** @type {const} */ (['light', 'dark']))('in %s', (colorScheme) => {
  test.each(states)(
    'the texts of %s have the contrast that WCAG asks for, and axe-core finds nothing to mend',
    async (name, address, prepare, device = undefined) => {
      const { page } = await openAddress(served.browser, served.url + address, {
        colorScheme,
        reducedMotion: 'reduce',
        ...allPixels,
        ...device,
      });
      await prepare(page);
      await page.screenshot({ path: path.join(screenshots, `${name.replaceAll(/\W+/g, '-')}-${colorScheme}.png`) });
      await expectLegible(page);
      expect(await violations(page)).toEqual([]);
      await page.context().close();
    },
    120_000,
  );

  test('every segment can be read while it is chosen', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html`, {
      colorScheme,
      reducedMotion: 'reduce',
    });
    await measured(page);
    await page.locator('[name=functional]').selectOption('bending'); // which can do without a cap
    await openAdvanced(page);
    const segments = page.locator('.segments label');
    const count = await segments.count();
    expect(count).toBeGreaterThanOrEqual(7); // families, caps, origins
    let seen = 0;
    for (let i = 0; i < count; i++) {
      const segment = segments.nth(i);
      if (!(await segment.isVisible())) continue;
      await segment.locator('input').check();
      await page.mouse.move(0, 0);
      const words = (await segment.innerText()).trim();
      const chosen = (await readTexts(page)).filter(({ text, place }) => text === words && place === 'span');
      expect(chosen).toHaveLength(1);
      expect(chosen[0].contrast).toBeGreaterThanOrEqual(4.5);
      seen++;
    }
    expect(seen).toBeGreaterThanOrEqual(5);
    await page.context().close();
  }, 60_000);
});

describe('the notice of a file that is broken', () => {
  test.each([
    ['desktop', 1280, 800],
    ['laptop', 1024, 700],
    ['phone', 390, 844],
  ])(
    'lies over no button, menu or field on a %s, nor off the page',
    async (name, width, height) => {
      const { page } = await openAddress(served.browser, `${served.url}studio.html`, { viewport: { width, height } });
      await breakFile(page);
      const { alert, covered, controls } = await page.evaluate(() => {
        const box = /** @type {Element} */ (document.querySelector('#alert'));
        const { left, right, top, bottom } = box.getBoundingClientRect();
        const all = [...document.querySelectorAll('button, select, input, a, canvas, summary')].filter(
          (element) => !box.contains(element) && element.checkVisibility() && !element.matches('.hidden'),
        );
        const under = all.filter((element) => {
          const other = element.getBoundingClientRect();
          return other.left < right && other.right > left && other.top < bottom && other.bottom > top;
        });
        return {
          alert: { left, right, height: bottom - top },
          covered: under.map((element) => element.id || element.getAttribute('name') || element.tagName),
          controls: all.length,
        };
      });
      expect(controls).toBeGreaterThan(20);
      expect(covered).toEqual([]);
      expect(alert.left).toBeGreaterThanOrEqual(0);
      expect(alert.right).toBeLessThanOrEqual(width);
      expect(alert.height).toBeGreaterThan(30);
      await page.screenshot({ path: path.join(screenshots, `notice-${name}.png`), fullPage: true });
      await page.locator('#fit').click({ timeout: 5000 });
      await page.getByRole('button', { name: 'Dismiss' }).click();
      expect(await page.locator('#alert').isVisible()).toBe(false);
      await page.context().close();
    },
    60_000,
  );
});
