// SPDX-License-Identifier: MIT
/**
 * @file A user's session: opening a file, choosing a functional, and watching, stopping and saving a run; mistakes;
 * and using the keyboard only.
 */
import path from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import {
  download as saved,
  dropFile,
  energies,
  evaluated,
  look,
  measured,
  minimized,
  openAdvanced,
  openDetails,
  openPage,
  progress,
  recordProgress,
  screenshots,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** A cage as a modelling program would write it: with texture coordinates, CRLF and a comment. */
let tetrahedronFrame = '';

beforeAll(async () => {
  await load();
  const cage = Cage.generate('tetrahedron-frame', { family: 'hub' });
  const faces = cage.obj().replace(/^f .*$/gm, (face) => face.replace(/(\d+)/g, '$1/1'));
  tetrahedronFrame = `# a frame\nvt 0 0\n${faces}`.replaceAll('\n', '\r\n');
  cage.dispose();
});

/** @param {Page} page @param {string} name */
const button = (page, name) => page.getByRole('button', { name, exact: true });

/** @param {Page} page @param {Parameters<typeof saved>[1]} what */
async function download(page, what) {
  const { name, content } = await saved(page, what);
  return { name, text: content.toString() };
}

describe('a report that was saved', () => {
  test('is dropped on another page and goes on where it was: cage, settings, surface and energies', async () => {
    const first = await openPage(served.browser, served.url);
    await dropFile(first.page, 'my frame.obj', tetrahedronFrame);
    await first.page.locator('.facts').filter({ hasText: 'my frame.obj' }).waitFor();
    await first.page.locator('[name=functional]').selectOption('bending');
    await first.page.locator('[name=last]').selectOption('2');
    await measured(first.page);
    await button(first.page, 'Start').click();
    await status(first.page, minimized, 60_000);
    await measured(first.page);
    const before = await energies(first.page);
    const report = await download(first.page, 'report');
    expect(first.errors).toEqual([]);
    await first.page.context().close();

    const { page, errors } = await openPage(served.browser, served.url);
    await dropFile(page, report.name, report.text);
    await page.locator('.facts').filter({ hasText: 'my frame.obj' }).waitFor();
    await measured(page);
    expect(await page.locator('[name=functional]').inputValue()).toBe('bending');
    expect((await energies(page))['Bending energy']).toBe(before['Bending energy']);
    expect(await page.locator('#levels tbody tr').count()).toBe(JSON.parse(report.text).levels.length);
    await page.locator('[name=last]').selectOption('3');
    await button(page, 'Start').click();
    await status(page, minimized, 60_000);
    const again = JSON.parse((await download(page, 'report')).text);
    // Levels before that of the report are not minimized again.
    expect(again.levels.map((/** @type {any} */ { level }) => level)).toEqual([2, 3]);
    expect(again.levels[0].energy_reported / JSON.parse(report.text).energies.bending).toBeCloseTo(1, 5);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);

  test('that is broken says where', async () => {
    const { page } = await openPage(served.browser, served.url);
    await dropFile(page, 'broken.json', '{"umbilic": "problem", "version": 1, "cage": {"generator": "two-3"}}');
    await page.locator('#alert').filter({ hasText: 'terms: missing' }).waitFor();
    await page.context().close();
  });
});

describe('a user', () => {
  test('drops a file, minimizes it, pauses, resumes, cancels, saves and resets', async () => {
    const { page, errors } = await openPage(served.browser, served.url);

    await dropFile(page, 'my frame.obj', tetrahedronFrame);
    await status(page, /^Ready/);
    await page.locator('.facts').filter({ hasText: 'my frame.obj' }).waitFor();
    expect(await page.locator('.facts').innerText()).toMatch(/Genus\s*3/);
    expect(await page.locator('#drop').isVisible()).toBe(false);
    expect((await look(page)).coloured).toBeGreaterThan(0.1);

    await page.locator('[name=functional]').selectOption('mvs_cross');
    // Makes the run take longer than the test.
    await page.locator('[name=symmetry]').uncheck();
    await page.locator('[name=last]').selectOption('4');
    await page.locator('[name=first]').selectOption('2');
    await measured(page);
    const before = await energies(page);
    const told = await recordProgress(page);
    await button(page, 'Start').click();
    await evaluated(page, 25);
    const seen = await told();
    expect(seen.length).toBeGreaterThan(3);
    for (let i = 1; i < seen.length; i++) {
      expect(seen[i].evaluations).toBeGreaterThan(seen[i - 1].evaluations);
      if (seen[i].level === seen[i - 1].level) expect(seen[i].energy).toBeLessThanOrEqual(seen[i - 1].energy);
    }
    expect(seen.at(-1)?.energy).toBeLessThan(0.9 * seen[0].energy);
    expect(await page.locator('#plot path').first().getAttribute('d')).toMatch(/^M[\d.]+ [\d.]+L/);
    expect(await page.locator('[name=functional]').isDisabled()).toBe(true);

    await button(page, 'Pause').click();
    await status(page, /^Paused/);
    const paused = await progress(page);
    await page.waitForTimeout(600);
    expect(await progress(page)).toEqual(paused);

    await button(page, 'Step').click();
    await evaluated(page, paused.evaluations + 1);
    await status(page, /^Paused at \d.*still falling\.$/);
    expect((await progress(page)).evaluations).toBe(paused.evaluations + 1);

    await button(page, 'Resume').click();
    await evaluated(page, paused.evaluations + 5);
    await button(page, 'Cancel').click();
    await status(page, /^Stopped at/);
    await openDetails(page);
    await page.locator('#levels tbody').filter({ hasText: 'cancelled' }).waitFor();
    const after = await energies(page);
    const number = (/** @type {string} */ text) => Number(text.split(' ±')[0].replaceAll('\u202f', ''));
    expect(number(after['MVS with cross terms'])).toBeLessThan(number(before['MVS with cross terms']));

    const control = await download(page, 'control');
    expect(control.name).toMatch(/^my-frame-mvs_cross-level\d\.obj$/);
    const cage = Cage.read(control.text);
    expect(cage.counts.genus).toBe(3);
    const minimizer = new Minimizer({
      cage: cage.input,
      terms: { mvs_cross: 1 },
      options: { levels: [0, 0], max_iterations: 0 },
    });
    while (!minimizer.step(10));
    // The saved surface is the one whose energies the table shows.
    expect(minimizer.energies.mvs_cross / number(after['MVS with cross terms']) - 1).toBeLessThan(1e-3);
    minimizer.dispose();

    const limit = await download(page, 'limit');
    expect(limit.name).toBe(control.name.replace('.obj', '-limit.obj'));
    const mesh = Cage.read(limit.text);
    expect(mesh.counts.genus).toBe(3);
    expect(mesh.counts.faces % cage.counts.faces).toBe(0);
    expect(mesh.counts.faces).toBeGreaterThan(7_500);

    const report = await download(page, 'report');
    expect(JSON.parse(report.text)).toMatchObject({
      umbilic: 'report',
      problem: { cage: { name: 'my frame.obj' }, terms: { mvs_cross: 1 }, options: { cap: 'smooth' } },
      cage: { genus: 3 },
      levels: [{ stop: 'cancelled' }],
    });

    await button(page, 'Reset').click();
    await status(page, /^Ready/);
    await page.locator('#energies .objective').filter({ hasText: before['MVS with cross terms'] }).waitFor();
    expect(await energies(page)).toEqual(before);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);

  test('chooses a generated shape, its family and thickness, and a file by the button', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await page.locator('[name=shape]').selectOption('two-4');
    await page
      .locator('.facts')
      .filter({ hasText: /Genus\s*3/ })
      .waitFor();
    const flag = await page.locator('.facts').innerText();
    await openAdvanced(page);
    await page.getByLabel('Hub').check();
    await page.waitForFunction((old) => document.querySelector('.facts')?.textContent !== old, flag);
    const thick = (await energies(page))['Bending energy'];
    await page.locator('[name=thickness]').fill('0.7');
    await page.waitForFunction(
      (old) => document.querySelector('#energies tbody td:last-child')?.textContent !== old,
      thick,
    );
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), button(page, 'Choose file …').click()]);
    await chooser.setFiles({ name: 'frame.obj', mimeType: 'model/obj', buffer: Buffer.from(tetrahedronFrame) });
    await page.locator('.facts').filter({ hasText: 'frame.obj' }).waitFor();
    expect(await page.locator('.frame-options').isVisible()).toBe(false);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('who drops a broken file reads the line at fault and keeps the surface', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    const [facts, table, picture] = [await page.locator('.facts').innerText(), await energies(page), await look(page)];
    await dropFile(page, 'broken.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n');
    const alert = page.locator('#alert');
    await alert.waitFor();
    expect(await alert.innerText()).toMatch(/broken\.obj was not opened\s+line 5/);
    await button(page, 'Dismiss').click();
    expect(await alert.isVisible()).toBe(false);
    expect(await page.locator('.facts').innerText()).toBe(facts);
    expect(await energies(page)).toEqual(table);
    expect(await look(page)).toEqual(picture);
    await button(page, 'Start').click();
    await evaluated(page, 2);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('who leaves the cap away sees what diverges', async () => {
    const { page } = await openPage(served.browser, served.url);
    await page.locator('[name=functional]').selectOption('bending');
    await openAdvanced(page);
    await page.getByLabel('None').check();
    await page.locator('#energies').getByText('diverges').first().waitFor();
    expect(await page.locator('#energies').getByText('diverges').count()).toBe(6);
    await page.context().close();
  });

  test('blends functionals, and is told when nothing is left of them', async () => {
    const { page } = await openPage(served.browser, served.url);
    await page.locator('[name=functional]').selectOption('blend');
    await page.locator('#energies .objective').filter({ hasText: 'Blend' }).waitFor();
    for (const name of ['bending', 'mvs_cross']) {
      await page.locator(`[name=weight-${name}]`).fill('0');
      await page.locator(`[name=weight-${name}]`).blur();
    }
    expect(await page.locator('#settings-problem').innerText()).toMatch(/weight/);
    expect(await button(page, 'Start').getAttribute('aria-disabled')).toBe('true');
    await page.context().close();
  });

  test('asks for an accuracy instead of levels, and reads what was reached', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await page.locator('[name=functional]').selectOption('bending');
    await page.locator('[name=last]').selectOption('within 0.01');
    await measured(page);
    await button(page, 'Start').click();
    await status(page, minimized, 60_000);
    const said = await page.locator('#status').innerText();
    const [, energy, percent] = /^Minimized: ([\d.]+), within ([\d.]+)\u202f%\.$/.exec(said) ?? [];
    await openDetails(page);
    expect(await page.locator('#limit').innerText()).toContain(`Limit of the levels: ${energy} ± `);
    expect(Number(percent)).toBeLessThanOrEqual(1);
    expect(Math.abs(Number(energy) / 112.7668 - 1)).toBeLessThan(Number(percent) / 100);
    expect(new URL(page.url()).searchParams.get('accuracy')).toBe('0.01');
    await page.screenshot({ path: path.join(screenshots, 'accuracy.png') });
    await page.locator('[name=last]').selectOption('2');
    await page.waitForFunction(() => !location.search.includes('accuracy'));
    expect(errors).toEqual([]);
    await page.context().close();
  }, 90_000);

  test('works with the keyboard alone: to Start by Tab, Enter, and Enter again to pause', async () => {
    const { page } = await openPage(served.browser, served.url);
    // Without symmetry, so that the run does not end too soon; set without moving the focus.
    await page.evaluate(() => {
      const keep = /** @type {HTMLInputElement} */ (document.querySelector('[name=symmetry]'));
      keep.checked = false;
      keep.dispatchEvent(new Event('change', { bubbles: true }));
    });
    const focused = () =>
      page.evaluate(() => document.activeElement?.id || document.activeElement?.getAttribute('name'));
    const seen = [];
    for (let i = 0; i < 60 && (await focused()) !== 'primary'; i++) {
      await page.keyboard.press('Tab');
      seen.push(await focused());
      const advanced = await page.evaluate(() => document.activeElement?.textContent === 'Advanced');
      if (advanced) await page.keyboard.press('Enter');
    }
    expect(seen).toEqual(
      expect.arrayContaining(['theme', 'shape', 'choose-file', 'family', 'functional', 'cap', 'shading', 'primary']),
    );
    const outline = await page.evaluate(
      () => getComputedStyle(/** @type {Element} */ (document.activeElement)).outlineStyle,
    );
    expect(outline).toBe('solid');
    await page.keyboard.press('Enter');
    await evaluated(page, 3);
    expect(await focused()).toBe('primary');
    await page.keyboard.press('Enter');
    await status(page, /^Paused/);
    await page.keyboard.press('Tab');
    expect(await focused()).toBe('step');
    const { evaluations } = await progress(page);
    await page.keyboard.press('Space');
    await evaluated(page, evaluations + 1);
    await status(page, /^Paused at/);
    await page.context().close();
  });
});
