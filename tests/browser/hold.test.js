// SPDX-License-Identifier: MIT
/**
 * @file A user holds a part of a surface with the mouse or the keyboard and fairs the rest: groups of a file, painted
 * faces and pins; the run keeps them to the last bit, finds the core's energy, and the files restore them.
 */
import path from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';
import { fish } from './fish.js';
import {
  allPixels,
  downloadedText,
  dropFile,
  energies,
  look,
  minimized,
  openPage,
  screenshots,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../wasm/types.js').Problem} Problem */

const served = servedPage();
const text = fish();
/** The last level of the runs. */
const LEVEL = 1;

beforeAll(() => load());

/** Opens the studio with the fish. @param {import('playwright-core').BrowserContextOptions} [options] */
async function openFish(options = {}) {
  const opened = await openPage(served.browser, served.url, { reducedMotion: 'reduce', ...allPixels, ...options });
  const { page } = opened;
  await dropFile(page, 'fish.obj', text);
  await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
  await page.locator('[name=functional]').selectOption('bending');
  await page.locator('[name=last]').selectOption(String(LEVEL));
  await settled(page);
  return opened;
}

/** @param {Page} page @param {string} name */
const pointer = (page, name) => page.getByRole('radio', { name, exact: true }).check();

/** What the page says of held faces. @param {Page} page */
const heldCount = async (page) => Number(/^\d+/.exec(await page.locator('#held-count').innerText())?.[0] ?? 0);

/** Drags the mouse over the surface, at fractions of it. @param {Page} page @param {[number, number]} from @param {[number, number]} to */
async function drag(page, from, to) {
  const box = await page.locator('#surface canvas').boundingBox();
  if (!box) throw new Error('no canvas');
  const { x, y, width, height } = box;
  await page.mouse.move(x + from[0] * width, y + from[1] * height);
  await page.mouse.down();
  await page.mouse.move(x + to[0] * width, y + to[1] * height, { steps: 4 });
  await page.mouse.up();
}

/** @param {Page} page */
async function minimize(page) {
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, minimized, 90_000);
}

/** Runs a problem to its end in this process. @param {Problem} problem */
function solved(problem) {
  const minimizer = new Minimizer(problem);
  while (!minimizer.step(20));
  const { energies: found, group } = minimizer;
  minimizer.dispose();
  return { energies: found, group };
}

/**
 * Of the held faces: the control points at the level of an OBJ text, and of the cage's own subdivision.
 * @param {string} obj
 * @param {Problem} problem
 * @param {number} level
 */
function heldPoints(obj, problem, level) {
  const { groups: names = [], faces: listed = [] } = problem.constraints?.hold ?? {};
  const own = new Minimizer({ ...problem, constraints: {}, options: { symmetry: false, levels: [level, level] } });
  const held = new Set([
    ...own.groups.filter(({ name }) => names.includes(name)).flatMap(({ faces }) => faces),
    ...listed,
  ]);
  const { triangles, faces } = own.controlMesh();
  const points = (/** @type {string} */ from) => from.split('\n').filter((line) => line.startsWith('v '));
  const [there, here] = [points(own.controlObj()), points(obj)];
  own.dispose();
  const vertices = [...new Set([...triangles].filter((_, i) => held.has(faces[Math.floor(i / 3)] + 1)))];
  return {
    moved: vertices.filter((v) => there[v] !== here[v]),
    vertices,
    others: there.filter((p, v) => p !== here[v]),
  };
}

describe('a group', () => {
  test('is held: its control points stay to the last bit, and the energy is the core’s', async () => {
    const { page, errors } = await openFish();
    expect(await page.locator('#groups').innerText()).toMatch(/head\s*32 faces\s*body\s*64 faces/);
    const before = await look(page);
    await page.getByRole('checkbox', { name: /^body/ }).check();
    await settled(page);
    expect(await page.locator('#held-count').innerText()).toBe('64 of 96 faces held');
    expect(await page.locator('#held-key').isVisible()).toBe(true);
    expect((await look(page)).coloured).toBeLessThan(0.9 * before.coloured);
    await minimize(page);
    const report = JSON.parse(await downloadedText(page, 'report'));
    expect(report.problem.constraints).toEqual({ hold: { groups: ['body'], faces: [] } });
    const { moved, vertices, others } = heldPoints(await downloadedText(page, 'control'), report.problem, LEVEL);
    expect(vertices.length).toBeGreaterThan(100);
    expect(moved).toEqual([]);
    expect(others.length).toBeGreaterThan(50);
    const core = solved(report.problem).energies;
    expect(report.energies.free.bending / (core.free?.bending ?? NaN)).toBeCloseTo(1, 5);
    const shown = await energies(page);
    const row = Object.keys(shown).find((name) => /over the free faces/.test(name)) ?? '';
    expect(Number(shown[row].split(' ±')[0])).toBeCloseTo(report.energies.free.bending, 2);
    expect(await page.locator('#energies').innerText()).toMatch(/over the free faces, \d+ % of the area/);
    await page.screenshot({ path: path.join(screenshots, 'held-group.png') });
    expect(errors).toEqual([]);

    // The report brings everything back on another page.
    const other = await openPage(served.browser, served.url);
    await dropFile(other.page, 'fish.json', JSON.stringify(report));
    await other.page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    expect(await other.page.getByRole('checkbox', { name: /^body/ }).isChecked()).toBe(true);
    expect(await other.page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(false);
    expect(await heldCount(other.page)).toBe(64);
    await other.page.context().close();
    await page.context().close();
  }, 180_000);
});

describe('the brush', () => {
  test('holds what it is dragged over, frees it with Shift, and does not turn the surface', async () => {
    const { page, errors } = await openFish();
    const address = page.url();
    await pointer(page, 'Paint');
    await drag(page, [0.4, 0.48], [0.7, 0.5]);
    await settled(page);
    const painted = await heldCount(page);
    expect(painted).toBeGreaterThanOrEqual(3);
    expect(painted).toBeLessThan(30);
    await page.keyboard.down('Shift');
    await drag(page, [0.4, 0.48], [0.45, 0.48]);
    await page.keyboard.up('Shift');
    await settled(page);
    const left = await heldCount(page);
    expect(left).toBeLessThan(painted);
    expect(left).toBeGreaterThan(0);
    expect(page.url()).toBe(address);
    await page.screenshot({ path: path.join(screenshots, 'painted.png') });

    // Beside the surface the same drag turns it; on it, too, when the pointer is to turn.
    await drag(page, [0.05, 0.3], [0.15, 0.3]);
    await page.waitForURL((url) => url.href !== address);
    await minimize(page);
    const report = JSON.parse(await downloadedText(page, 'report'));
    expect(report.problem.constraints.hold.faces).toHaveLength(left);
    const { moved, others } = heldPoints(await downloadedText(page, 'control'), report.problem, LEVEL);
    expect(moved).toEqual([]);
    expect(others.length).toBeGreaterThan(100);
    expect(report.energies.free.bending / (solved(report.problem).energies.free?.bending ?? NaN)).toBeCloseTo(1, 5);

    // A change after the run waits for the next Start, which it says, and loses nothing.
    const energy = (await energies(page))['Willmore energy'];
    await page.getByRole('button', { name: 'Invert', exact: true }).click();
    expect(await heldCount(page)).toBe(96 - left);
    expect(await page.locator('#hold-change').innerText()).toMatch(/next Start/);
    expect((await energies(page))['Willmore energy']).toBe(energy);
    await page.getByRole('button', { name: 'Invert', exact: true }).click();
    expect(await page.locator('#hold-change').innerText()).toBe('');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 180_000);

  test('has a substitute on the keyboard: modes by arrows, and changes of all faces by buttons', async () => {
    const { page } = await openFish();
    const box = page.getByRole('checkbox', { name: /^body/ });
    await page.getByRole('radio', { name: 'Turn', exact: true }).focus();
    await page.keyboard.press('ArrowRight');
    expect(await page.getByRole('radio', { name: 'Paint', exact: true }).isChecked()).toBe(true);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Space'); // the group “head”
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter'); // Invert
    expect(await box.isChecked()).toBe(true);
    expect(await heldCount(page)).toBe(64);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter'); // Grow
    expect(await heldCount(page)).toBeGreaterThan(64);
    expect(
      await page.getByRole('checkbox', { name: /^head/ }).evaluate((input) => /** @type {any} */ (input).indeterminate),
    ).toBe(true);
    await page.getByRole('button', { name: 'All', exact: true }).press('Enter');
    expect(await page.locator('#hold-problem').innerText()).toBe('Everything is held: free some faces.');
    expect(await page.getByRole('button', { name: 'Start', exact: true }).getAttribute('aria-disabled')).toBe('true');
    await page.getByRole('button', { name: 'Clear', exact: true }).press('Enter');
    expect(await page.locator('#held-count').innerText()).toBe('Nothing is held.');
    await page.context().close();
  }, 60_000);
});

describe('a pin', () => {
  test('holds the limit point of the vertex that is nearest to the click', async () => {
    const { page, errors } = await openFish();
    await pointer(page, 'Pin');
    await drag(page, [0.5, 0.5], [0.5, 0.5]);
    await drag(page, [0.35, 0.5], [0.35, 0.5]);
    // In the middle of the picture is vertex 98, which is not pinned a second time.
    expect(await page.locator('#pins .name').allInnerTexts()).toEqual(['Vertex 98', 'Vertex 94']);
    for (const vertex of ['98', '45']) {
      await page.getByRole('spinbutton', { name: 'Vertex' }).fill(vertex);
      await page.getByRole('button', { name: 'Pin it' }).click();
      const said = vertex === '98' ? 'Vertex 98 is pinned already.' : '';
      await page.waitForFunction((words) => document.querySelector('#hold-said')?.textContent === words, said);
    }
    await page.getByRole('button', { name: 'Remove the pin: Vertex 45' }).click();
    await settled(page);
    await page.screenshot({ path: path.join(screenshots, 'pinned.png') });
    const problem = JSON.parse(await downloadedText(page, 'problem'));
    expect(problem.constraints.pins).toHaveLength(2);
    await minimize(page);
    const report = JSON.parse(await downloadedText(page, 'report'));
    const own = new Minimizer({ ...problem, constraints: {} });
    const { centre, positions } = own.limitMesh(1);
    own.dispose();
    report.constraints.pins.forEach((/** @type {any} */ pin, /** @type {number} */ i) => {
      const v = problem.constraints.pins[i].vertex - 1;
      // The limit point of the bare surface; the page's mesh has that of the cap, and single precision.
      pin.position.forEach((/** @type {number} */ x, /** @type {number} */ k) =>
        expect(Math.abs(x - centre[k] - positions[3 * v + k])).toBeLessThan(0.02),
      );
      expect(pin.strength).toBeGreaterThan(0);
    });
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);

  test('is given by the number of its vertex, listed, removed, and part of the problem', async () => {
    const { page, errors } = await openFish();
    await pointer(page, 'Pin');
    for (const vertex of ['45', '98']) {
      await page.getByRole('spinbutton', { name: 'Vertex' }).fill(vertex);
      await page.getByRole('button', { name: 'Pin it' }).click();
    }
    await page.getByRole('button', { name: 'Remove the pin: Vertex 98' }).click();
    await page.getByRole('button', { name: 'Remove the pin: Vertex 98' }).waitFor({ state: 'hidden' });
    await settled(page);
    const problem = JSON.parse(await downloadedText(page, 'problem'));
    expect(problem.constraints.pins.map((/** @type {any} */ pin) => pin.vertex)).toEqual([45]);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);
});

describe('a problem that was saved', () => {
  test('is dropped on another page and holds the same', async () => {
    const { page } = await openFish();
    await page.getByRole('checkbox', { name: /^head/ }).check();
    await settled(page);
    const problem = await downloadedText(page, 'problem');
    await page.context().close();
    const other = await openPage(served.browser, served.url);
    await dropFile(other.page, 'problem.json', problem);
    await other.page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    expect(await other.page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(true);
    await other.page.locator('[name=shape]').selectOption('cube');
    await other.page.locator('#groups').waitFor({ state: 'hidden' });
    expect(await other.page.locator('#held-count').innerText()).toBe('Nothing is held.');
    await other.page.context().close();
  }, 60_000);
});
