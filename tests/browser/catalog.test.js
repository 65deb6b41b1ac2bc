// SPDX-License-Identifier: MIT
/**
 * @file A user works with the catalog by mouse and keyboard: it loads little, and can be sorted, filtered, read and
 * chosen from; its addresses restore what they show.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { builtPage, detailsCut, openAddress, screenshots } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */

const served = servedPage();
/** @returns {Catalog} */
const catalog = () => JSON.parse(readFileSync(path.join(builtPage, 'catalog/catalog.json'), 'utf8'));

/** @param {string} [search] @param {Parameters<typeof openAddress>[2]} [options] @param {Parameters<typeof openAddress>[3]} [prepare] */
async function openCatalog(search = '', options = {}, prepare = undefined) {
  const opened = await openAddress(served.browser, `${served.url}${search}`, options, prepare);
  await opened.page.locator('#table tbody tr').first().waitFor();
  return opened;
}

/** The shapes of the rows from top to bottom. @param {Page} page */
const rows = (page) =>
  page.locator('#table tbody tr').evaluateAll((all) => all.map((row) => row.getAttribute('data-shape')));
/** @param {Page} page */
const search = (page) => page.evaluate(() => location.search);
/** The genus column, which says of holes that they are open. @param {Page} page */
const genera = async (page) => (await page.locator('td.genus').allInnerTexts()).map((text) => parseInt(text, 10));
/** The cell of an entry. @param {Page} page @param {string} shape @param {string} functional */
function cell(page, shape, functional) {
  const column = catalog().functionals.findIndex(({ name }) => name === functional);
  return page.locator(`tr[data-shape="${shape}"] > td:not(.genus)`).nth(column);
}

describe('the home page', () => {
  test('is the catalog: a row for each shape, a column for each functional, a picture for each minimizer', async () => {
    const { page, errors, requests } = await openCatalog();
    const { shapes, functionals, entries } = catalog();
    expect(await rows(page)).toEqual(shapes.map(({ name }) => name));
    expect(await page.locator('#table thead th').count()).toBe(functionals.length + 2);
    const minimizers = entries.filter(({ minimizer }) => minimizer);
    expect(await page.locator('#table img').count()).toBe(minimizers.length);
    await page.locator('#table img').last().scrollIntoViewIfNeeded();
    await page.waitForFunction(() =>
      [...document.querySelectorAll('#table img')].every((image) => {
        const { complete, naturalWidth } = /** @type {HTMLImageElement} */ (image);
        return complete && naturalWidth > 0;
      }),
    );
    expect(errors).toEqual([]);
    for (const request of requests) expect(request.startsWith(served.url) || request.startsWith('data:')).toBe(true);
    await page.context().close();
  });

  test('loads less than 1.5 MB before a surface is opened, and nothing that draws or computes', async () => {
    /** @type {Array<Promise<[string, number]>>} */
    const sizes = [];
    const { page } = await openCatalog('', {}, async (fresh) => {
      fresh.on('response', (response) =>
        sizes.push(
          response.body().then(
            (body) => [response.url(), body.length],
            () => [response.url(), 0],
          ),
        ),
      );
    });
    const shown = Math.round(await page.evaluate(() => performance.now()));
    await page.locator('#table img').last().scrollIntoViewIfNeeded();
    await page.waitForLoadState('networkidle');
    const loaded = await Promise.all(sizes);
    const bytes = loaded.reduce((sum, [, size]) => sum + size, 0);
    expect(bytes).toBeGreaterThan(100_000);
    expect(bytes).toBeLessThan(1_500_000);
    for (const [url] of loaded) expect(url).not.toMatch(/three|wasm|umbilic-core/);
    console.log(
      `The catalog loads ${Math.round(bytes / 1000)} kB with all thumbnails; its table was there after ${shown} ms`,
    );
    await page.context().close();
  });

  test('is readable without WebGL', async () => {
    const { page, errors } = await openCatalog('', {}, async (fresh) => {
      await fresh.addInitScript(() => {
        HTMLCanvasElement.prototype.getContext = () => null;
      });
    });
    expect(await cell(page, 'two-3', 'bending').innerText()).toMatch(/112\.\d+[\s\S]*paper 113/);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('says so where the catalog cannot be loaded', async () => {
    const { page } = await openAddress(served.browser, served.url, {}, async (fresh) => {
      await fresh.route('**/catalog.json', (route) => route.abort());
    });
    await page.getByText('The catalog was not loaded').waitFor();
    await page.context().close();
  });

  test('leads to the other pages and back', async () => {
    const { page } = await openCatalog();
    const links = page.getByRole('navigation', { name: 'Pages' }).getByRole('link');
    expect(await links.allInnerTexts()).toEqual(['Catalog', 'Compare', 'Torus', 'Studio', 'Methods']);
    expect(await links.first().getAttribute('aria-current')).toBe('page');
    await links.nth(3).click();
    await page.waitForURL(`${served.url}studio.html*`);
    await page.getByRole('link', { name: 'umbilic' }).click();
    await page.locator('#table tbody tr').first().waitFor();
    await page.context().close();
  });
});

describe('the order of the rows', () => {
  test('is chosen by the heads, turned around by a second press, told to screen readers, and kept by the address', async () => {
    const { page } = await openCatalog();
    const head = page.getByRole('columnheader', { name: /^Genus/ });
    await head.getByRole('button').click();
    const upwards = await genera(page);
    expect(upwards).toEqual(upwards.toSorted((a, b) => a - b));
    expect(await head.getAttribute('aria-sort')).toBe('ascending');
    expect(await search(page)).toBe('?sort=genus');

    await head.getByRole('button').click();
    expect(await genera(page)).toEqual(upwards.toReversed());
    expect(await head.getAttribute('aria-sort')).toBe('descending');
    expect(await page.locator('[aria-sort]').count()).toBe(1);

    const shown = await rows(page);
    await page.reload();
    await page.locator('#table tbody tr').first().waitFor();
    expect(await rows(page)).toEqual(shown);
    await page.context().close();
  });

  test('by the energies of a column is chosen by the keyboard', async () => {
    const { page } = await openCatalog();
    const head = page.getByRole('columnheader', { name: /^MVS with cross terms/ });
    await head.getByRole('button').focus();
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => location.search === '?sort=mvs_cross');
    const energy = new Map(
      catalog()
        .entries.filter(({ functional }) => functional === 'mvs_cross')
        .map((entry) => [entry.shape, entry.energy ?? Infinity]),
    );
    const energies = (await rows(page)).map((name) => energy.get(String(name)) ?? Infinity);
    expect(energies).toEqual(energies.toSorted((a, b) => a - b));
    await page.context().close();
  });
});

describe('the rows', () => {
  test('are filtered by genus, arms, symmetry, status and words, and come back', async () => {
    const { page } = await openCatalog();
    const { shapes, entries } = catalog();
    const status = page.locator('#filters [role=status]');
    await page.getByLabel('Genus').selectOption('7');
    expect(await rows(page)).toEqual(shapes.filter(({ genus }) => genus === 7).map(({ name }) => name));
    await page.getByLabel('Arms').selectOption('3');
    expect(await rows(page)).toEqual(
      shapes.filter(({ genus, arms }) => genus === 7 && arms === 3).map(({ name }) => name),
    );
    expect(await status.innerText()).toMatch(/^\d+ of \d+ shapes$/);
    expect(await search(page)).toBe('?genus=7&arms=3');
    await page.getByRole('button', { name: 'Clear' }).click();
    expect(await rows(page)).toHaveLength(shapes.length);

    const { group } = entries.find(({ shape }) => shape === 'cube-frame') ?? entries[0];
    await page.getByLabel('Symmetry').selectOption(group.name);
    expect(await rows(page)).toContain('cube-frame');
    await page.getByLabel('Search shapes').fill('octahedron');
    expect(await rows(page)).toEqual(['octahedron-frame', 'cuboctahedron-frame']);
    await page.getByLabel('Search shapes').fill('no such shape');
    await page.getByText('No shape is like that.').waitFor();
    await page.getByRole('button', { name: 'Clear' }).click();
    expect(await search(page)).toBe('');
    await page.context().close();
  });

  test('with an entry of a status are shown, their other entries faintly', async () => {
    const { page } = await openCatalog('?status=upper_bound');
    const { shapes, entries } = catalog();
    const bounds = entries.filter(({ status }) => status === 'upper_bound');
    const wanted = new Set(bounds.map(({ shape }) => shape));
    expect(await rows(page)).toEqual(shapes.map(({ name }) => name).filter((name) => wanted.has(name)));
    expect(await page.locator('#table tbody .entry:not(.beside-the-point)').count()).toBe(bounds.length);
    await page.context().close();
  });

  test('of an address that is not understood are all of them, and a sentence says what it may be', async () => {
    const { page } = await openCatalog('?genus=many&sort=genus');
    expect(await rows(page)).toHaveLength(catalog().shapes.length);
    expect(await page.locator('#notices').innerText()).toMatch(/“genus=many”.*a whole number/s);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    expect(await page.locator('#notices').isVisible()).toBe(false);
    await page.context().close();
  });
});

describe('an entry', () => {
  test('opens in the studio', async () => {
    const { page, errors } = await openCatalog();
    await cell(page, 'two-3', 'mvs_cross').locator('a.open').click();
    await page.waitForURL((url) => url.pathname.endsWith('studio.html'));
    expect(await search(page)).toBe('?shape=two-3&functional=mvs_cross');
    await page.locator('#energies tbody tr').first().waitFor();
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('shows its details by the keyboard, under an address of its own, and gives the focus back', async () => {
    const { page, errors } = await openCatalog();
    const button = cell(page, 'two-3', 'bending').getByRole('button', { name: /^Details/ });
    await button.focus();
    await page.keyboard.press('Enter');
    const dialog = page.getByRole('dialog', { name: 'Two junctions, 3 arms' });
    await dialog.waitFor();
    expect(await search(page)).toBe('?entry=two-3.bending');
    const entry = catalog().entries.find(({ shape, functional }) => shape === 'two-3' && functional === 'bending');
    expect(await dialog.locator('table.energies tr').count()).toBe(9); // eight functionals and the Gaussian curvature
    expect(await dialog.locator('table.levels tbody tr').count()).toBe(entry?.levels.length);
    expect(await dialog.locator('table.energies .objective td').innerText()).toBe(
      entry?.energies.bending?.toPrecision(8),
    );
    expect(await dialog.locator('pre').innerText()).toMatch(
      /^umbilic cage two-3 .*\numbilic optimize .*--functional bending/,
    );
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await page.waitForFunction(() => location.search === '');
    expect(await button.evaluate((element) => element === document.activeElement)).toBe(true);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('says what another way of computing finds, once the entry has that, in the details and in the studio', async () => {
    const changed = catalog();
    for (const entry of changed.entries) delete entry.second_opinion; // as an earlier version wrote them
    Object.assign(changed.entries[0], { second_opinion: { energy: 112.76718, difference: -3.4e-8 } });
    const prepare = async (/** @type {Page} */ fresh) => {
      await fresh.route('**/catalog.json', (route) => route.fulfill({ json: changed }));
    };
    const words = 'Computed another way: 112.767 (difference 3\u202f×\u202f10⁻⁸)';
    const { page } = await openCatalog('?entry=two-3.bending', {}, prepare);
    expect(await page.locator('#details .note').allInnerTexts()).toContain(`${words}.`);
    await page.goto(`${served.url}?entry=two-4.bending`);
    await page.locator('#details .note').first().waitFor();
    expect((await page.locator('#details .note').allInnerTexts()).join()).not.toContain('another way');
    await page.goto(`${served.url}studio.html?shape=two-3&functional=bending`);
    await page.locator('#entry p.note').waitFor();
    expect(await page.locator('#entry p.note').innerText()).toBe(words);
    await page.screenshot({ path: path.join(screenshots, 'entry-opinion.png') });
    await page.goto(`${served.url}studio.html?shape=two-4&functional=bending`);
    await page.locator('#entry strong').waitFor();
    expect(await page.locator('#entry p.note').isVisible()).toBe(false);
    await page.context().close();
  });

  test('whose details an address names has them open, and the step back closes them', async () => {
    const { page } = await openCatalog('?entry=torus.bending');
    await page.getByRole('dialog', { name: 'Torus' }).waitFor();
    await page.getByRole('button', { name: 'Close' }).click();
    await page.waitForFunction(() => location.search === ''); // now the dialog has given the focus back
    const button = cell(page, 'cube-frame', 'bending').getByRole('button', { name: /^Details/ });
    await button.focus();
    await page.keyboard.press('Enter');
    await page.getByRole('dialog', { name: 'Cube frame' }).waitFor();
    await page.goBack();
    await page.getByRole('dialog').waitFor({ state: 'hidden' });
    await page.context().close();
  });

  test('is chosen with others, four at most, and all of them lead to their comparison', async () => {
    const { page } = await openCatalog();
    const names = ['bending', 'mvs_cross', 'mehlum_tarrou', 'bending_mvs_cross'];
    const boxes = names.map((name) => cell(page, 'two-3', name).getByRole('checkbox'));
    const bar = page.locator('#choice');
    expect(await bar.isVisible()).toBe(false);
    await boxes[0].focus();
    await page.keyboard.press('Space');
    expect(await bar.getByRole('link').isVisible()).toBe(false);
    for (const box of boxes.slice(1)) await box.check({ force: true });
    const entries = names.map((name) => `two-3.${name}`).join(',');
    expect(await bar.getByRole('link').getAttribute('href')).toBe(`./compare.html?entries=${entries}`);
    const another = cell(page, 'two-4', 'bending').getByRole('checkbox');
    expect(await another.isDisabled()).toBe(true);
    await bar
      .getByRole('button', { name: /^Remove/ })
      .first()
      .click();
    expect(await boxes[0].isChecked()).toBe(false);
    expect(await another.isDisabled()).toBe(false);
    await page.screenshot({ path: path.join(screenshots, 'catalog-chosen.png') });
    await bar.getByRole('button', { name: 'Clear' }).click();
    expect(await bar.isVisible()).toBe(false);
    await page.context().close();
  });
});

describe('a picture', () => {
  test.each(
    /** @type {Array<[string, import('playwright-core').BrowserContextOptions]>} */ ([
      ['light', { colorScheme: 'light' }],
      ['dark', { colorScheme: 'dark' }],
      ['wide', { colorScheme: 'light', viewport: { width: 1920, height: 1080 } }],
      ['phone', { colorScheme: 'light', viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }],
      ['phone-dark', { colorScheme: 'dark', viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }],
    ]),
  )('is taken of the catalog and of details in %s; nothing is cut off', async (name, options) => {
    const { page, errors } = await openCatalog('', options);
    await page.waitForLoadState('networkidle');
    await page.screenshot({ path: path.join(screenshots, `catalog-${name}.png`) });
    const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    expect(await overflow()).toBeLessThanOrEqual(0);
    const background = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
    expect(Number(/\d+/.exec(background)?.[0]) < 128).toBe(options.colorScheme === 'dark');
    if (options.hasTouch) expect(await page.getByRole('checkbox').first().isVisible()).toBe(true);

    const details = `${served.url}?entry=two-3.bending`;
    expect(await detailsCut(page, details, `catalog-details-${name}`)).toBeLessThanOrEqual(0);
    expect(await overflow()).toBeLessThanOrEqual(0);
    expect(errors).toEqual([]);
    await page.context().close();
  });
});
