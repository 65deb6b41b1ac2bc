// SPDX-License-Identifier: MIT
/**
 * @file A user says what holds an open surface at its boundaries, fills a hole and takes that back, says how far the
 * surface may move, and sees how far it has moved and what pulls: all on the real core.
 */
import path from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';
import { fish } from './fish.js';
import { allPixels, downloadedText, dropFile, energies, look, openPage, screenshots, settled, status } from './page.js';
import { plate } from './plate.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../wasm/types.js').Problem} Problem */

const served = servedPage();

beforeAll(() => load());

/**
 * Opens the studio with a problem at level 0.
 * @param {string} name of the cage
 * @param {string} text
 * @param {Partial<Problem>} [more]
 */
async function openCage(name, text, more = {}) {
  const opened = await openPage(served.browser, served.url, { reducedMotion: 'reduce', ...allPixels });
  const { page } = opened;
  const problem = { umbilic: 'problem', version: 1, cage: { name, text }, terms: { bending: 1 }, ...more };
  problem.options = { levels: [0, 0], ...more.options };
  await dropFile(page, 'problem.json', JSON.stringify(problem));
  await page.locator('.facts').filter({ hasText: name }).waitFor();
  await settled(page);
  return opened;
}

/** @param {Page} page */
async function minimize(page) {
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, /^(Minimized|The energy|Stopped after)/, 60_000);
}

/** The energies at the end of a problem's run in this process. @param {Problem} problem */
function solved(problem) {
  const minimizer = new Minimizer(problem);
  while (!minimizer.step(20));
  const found = minimizer.energies;
  minimizer.dispose();
  return found;
}

/** The value of a row of the energies whose name matches. @param {Page} page @param {RegExp} name */
async function shown(page, name) {
  const row = Object.entries(await energies(page)).find(([words]) => name.test(words));
  return Number(row?.[1].split(' ±')[0]);
}

describe('the boundaries of an open cage', () => {
  test('are listed, marked and held as chosen; what the core refuses is said there', async () => {
    const { page, errors } = await openCage('plate.obj', plate(), {
      terms: { mvs_cross: 1 },
      options: { max_iterations: 20 },
    });
    const rows = page.locator('#boundaries li');
    expect(await rows.locator('.name').allInnerTexts()).toEqual(['All', expect.anything(), expect.anything()]);
    expect(await rows.nth(1).innerText()).toMatch(/^1\s*24 vertices/);
    expect(await rows.nth(2).innerText()).toMatch(/^2\s*8 vertices/);
    const condition = (/** @type {string} */ name) => page.getByRole('combobox', { name: `What is held at ${name}` });
    expect(await condition('all boundaries').inputValue()).toBe('tangent');

    // The boundary that has the focus is drawn in the accent's colour.
    await page.locator('[name=shading]').selectOption('plain');
    const before = await look(page);
    await condition('boundary 2').focus();
    const marked = await look(page);
    expect(marked.coloured - before.coloured).toBeGreaterThan(0.001);
    await page.screenshot({ path: path.join(screenshots, 'boundary-marked.png') });

    await condition('boundary 2').selectOption('free');
    expect(await condition('all boundaries').inputValue()).toBe('mixed');
    await condition('boundary 1').selectOption('curvature');
    const refusal = rows.nth(1).locator('.problem');
    await refusal.filter({ hasText: 'The cage says nothing of the curvature across its boundary' }).waitFor();
    expect(await rows.nth(2).locator('.problem').innerText()).toBe('');
    expect(await page.locator('#alert').isVisible()).toBe(false);
    expect(await page.locator('#primary').getAttribute('aria-disabled')).toBe('true');
    await page.screenshot({ path: path.join(screenshots, 'boundary-refused.png') });
    await condition('all boundaries').selectOption('position');
    await refusal.waitFor({ state: 'hidden' });
    await condition('all boundaries').selectOption('tangent');
    await condition('boundary 2').selectOption('position');
    await settled(page);
    await minimize(page);
    const report = JSON.parse(await downloadedText(page, 'report'));
    expect(report.problem.constraints.boundary).toEqual({
      condition: 'tangent',
      loops: [{ loop: 2, condition: 'position' }],
    });
    const pull = report.constraints.boundaries[1];
    const words = await rows.nth(2).locator('p').first().innerText();
    expect(parseFloat(words.replace(/^pulls with /, '')) / pull.strength).toBeCloseTo(1, 2);
    const core = solved(report.problem);
    expect((await shown(page, /^MVS with cross termswith the constant/)) / (core.free?.mvs_cross ?? NaN)).toBeCloseTo(
      1,
      3,
    );
    expect((await shown(page, /^MVS with cross terms$/)) / core.mvs_cross).toBeCloseTo(1, 5);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);

  test('are filled, alone or all where the core can, and opened again', async () => {
    const { page, errors } = await openCage('plate.obj', plate());
    const faces = () => page.locator('.facts div').filter({ hasText: 'Faces' }).locator('dd').innerText();
    await page.getByRole('button', { name: 'Fill all boundaries' }).click();
    await page.locator('#boundaries .problem').filter({ hasText: 'Every face of the cage touches' }).waitFor();
    expect(await faces()).toBe('32');
    await page.getByRole('button', { name: 'Fill boundary 2' }).press('Enter');
    await page.locator('#held-count').filter({ hasText: '20 of 36 faces held' }).waitFor();
    await settled(page);
    expect(await faces()).toBe('36');
    expect(await page.locator('#groups').innerText()).toMatch(/fill-2-rim\s*12 faces\s*fill-2\s*4 faces/);
    await page.screenshot({ path: path.join(screenshots, 'filled.png') });
    await minimize(page);
    const report = JSON.parse(await downloadedText(page, 'report'));
    expect(report.problem.fill).toEqual({ loops: [2] });
    const core = solved(report.problem);
    expect((await shown(page, /over the free faces/)) / (core.free?.bending ?? NaN)).toBeCloseTo(1, 4);
    const { deviation, regions } = report.constraints;
    expect((await shown(page, /^Largest deviation/)) / deviation).toBeCloseTo(1, 4);
    expect(await page.locator('#regions').innerText()).toMatch(/^20 faces, from face 1\s+[\d.]+ \/ length$/);
    expect(regions).toHaveLength(1);

    // The problem brings the fill back on another page; the boundary is opened again there.
    const other = await openPage(served.browser, served.url);
    await dropFile(other.page, 'problem.json', await downloadedText(page, 'problem'));
    await other.page.locator('#held-count').filter({ hasText: '20 of 36 faces held' }).waitFor();
    await other.page.getByRole('button', { name: 'Open boundary 2 again' }).click();
    await other.page.locator('#held-count').filter({ hasText: 'Nothing is held.' }).waitFor();
    await other.page.locator('#groups').waitFor({ state: 'hidden' });
    expect([...errors, ...other.errors]).toEqual([]);
    await other.page.context().close();
    await page.context().close();
  }, 120_000);
});

describe('a generated open cage', () => {
  test('is named though the menu does not offer it, and knows the curvature across its boundaries', async () => {
    const { page, errors } = await openPage(served.browser, served.url, { reducedMotion: 'reduce' });
    const cage = { generator: 'cylinder', segments: [16, 8] };
    const problem = { umbilic: 'problem', version: 1, cage, terms: { bending: 1 }, options: { levels: [0, 0] } };
    await dropFile(page, 'cylinder.json', JSON.stringify(problem));
    await page.locator('#boundaries').waitFor();
    expect(await page.locator('[name=shape]').inputValue()).toBe('cylinder');
    await page.getByRole('combobox', { name: 'What is held at all boundaries' }).selectOption('curvature');
    await settled(page);
    await page.getByRole('button', { name: 'Step', exact: true }).click();
    await status(page, /^Paused/);
    const saved = JSON.parse(await downloadedText(page, 'problem'));
    expect(saved.constraints.boundary).toMatchObject({ condition: 'curvature' });
    expect(await page.locator('#boundaries .problem').allInnerTexts()).toEqual(['', '', '']);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);
});

describe('how far the surface may move', () => {
  test('is a distance that it keeps, which table and colours show in the file’s units, beside what pulls', async () => {
    const { page, errors } = await openCage('fish.obj', fish());
    await page.getByRole('checkbox', { name: /^body/ }).check();
    await page.getByRole('radio', { name: 'Pin', exact: true }).check();
    await page.getByRole('spinbutton', { name: 'Vertex' }).fill('38');
    await page.getByRole('button', { name: 'Pin it' }).click();
    const within = page.getByRole('textbox', { name: 'Stay within' });
    await within.fill('a bit');
    await within.press('Enter');
    await page.locator('#closeness .problem').filter({ hasText: 'The distance is a number above 0.' }).waitFor();
    await within.fill('0.05');
    await within.press('Enter');
    await page.locator('#closeness .problem').waitFor({ state: 'hidden' });
    await page.locator('[name=shading]').selectOption('deviation');
    await settled(page);
    expect((await look(page)).coloured).toBeLessThan(0.01); // nothing has moved
    await minimize(page);
    await page.locator('#pull-words').waitFor();
    const { problem, constraints } = JSON.parse(await downloadedText(page, 'report'));
    expect(problem.constraints.closeness).toEqual({ within: 0.05 });
    const deviation = await shown(page, /^Largest deviation\|X − X₀\|, in the file’s units/);
    expect(deviation / constraints.deviation).toBeCloseTo(1, 4);
    expect(deviation).toBeLessThanOrEqual(0.05);
    expect(deviation).toBeGreaterThan(0.02);
    expect(await page.locator('#energies').innerText()).toMatch(/Pulled to the cage’s own surface with weight [\d.]+/);
    expect(await page.locator('#legend figcaption').innerText()).toMatch(/along the normal .* in the file’s units$/);
    const ticks = await page.locator('#legend .ticks span').allInnerTexts();
    const end = ticks[ticks.length - 1];
    expect(ticks.length).toBeGreaterThanOrEqual(3);
    expect(Number(end)).toBeLessThanOrEqual(0.06);
    expect(ticks[0]).toBe(`−${end}`);
    expect((await look(page)).coloured).toBeGreaterThan(0.01);
    const [pin] = constraints.pins;
    const pull = parseFloat(await page.locator('#pins .pull').innerText());
    expect(pull / pin.strength).toBeCloseTo(1, 3);
    expect(await page.locator('#regions').innerText()).toMatch(/^body/);
    await page.screenshot({ path: path.join(screenshots, 'deviation.png') });
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);
});
