// SPDX-License-Identifier: MIT
/**
 * @file The story of a researcher: a surface of genus 2 without symmetry, between two functionals whose weights move, read,
 * saved, certified and passed on.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { Cage, load } from '../../wasm/umbilic.js';
import {
  downloadedText,
  drawn,
  dropFile,
  evaluated,
  measured,
  minimized,
  recordEvents,
  recordedEvents,
  settled,
  status,
} from './page.js';
import { servedPage } from './served.js';
import { apart, begin, button, copiedLink, photograph, reportOf } from './story.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** A cage of genus 2 whose points have been moved, each elsewhere. */
let cage = '';

beforeAll(async () => {
  await load();
  const frame = Cage.generate('two-3');
  let count = 0;
  cage = frame.obj().replace(/^v (.*)$/gm, (_, point) => {
    const at = point.split(' ').map((/** @type {string} */ x) => Number(x) + 0.06 * Math.sin(++count * count));
    return `v ${at.map((/** @type {number} */ x) => x.toFixed(5)).join(' ')}`;
  });
  frame.dispose();
});

/** The numbers of a reading by their names. @param {string} words */
const numbers = (words) =>
  Object.fromEntries(
    [...words.matchAll(/(κ₁|κ₂|H|K)\s(−?[\d.]+)/g)].map(([, name, value]) => [name, Number(value.replace('−', '-'))]),
  );

test('a researcher moves between two functionals, reads the surface, and passes all of it on', async () => {
  const permissions = ['clipboard-read', 'clipboard-write'];
  const { page, errors } = await begin(served.browser, `${served.url}studio.html`, { permissions }, recordEvents);
  await measured(page);
  await dropFile(page, 'mine.obj', cage);
  await page.locator('.facts').filter({ hasText: 'mine.obj' }).waitFor();
  expect(await page.locator('.facts').innerText()).toMatch(/Genus\s*2/);
  await page.locator('[name=functional]').selectOption('blend');
  for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('0');
  await settled(page);

  await button(page, 'Start').click();
  await evaluated(page, 3);
  const known = (await recordedEvents(page)).length;
  const slider = page.locator('#weights [name=slide-mvs_cross]');
  for (const weight of ['0.3', '0.2', '0.1']) await slider.fill(weight);
  expect(await page.locator('[name=weight-mvs_cross]').inputValue()).toBe('0.1');
  await page.waitForFunction((first) => {
    const names = /** @type {any} */ (window).recordedEvents().slice(first);
    const words = names.map((/** @type {any} */ { name }) => name);
    return words.includes('retargeted') && words.lastIndexOf('surfaced') > words.indexOf('retargeted');
  }, known);
  await status(page, minimized);

  await page.locator('[name=shading]').selectOption('gaussian');
  await drawn(page);
  const box = await page.locator('#surface canvas').boundingBox();
  if (!box) throw new Error('there is no picture');
  await page.mouse.move(box.x + 0.26 * box.width, box.y + 0.5 * box.height);
  await page.locator('#reading').waitFor();
  const { 'κ₁': large, 'κ₂': small, H, K } = numbers(await page.locator('#reading').innerText());
  expect(large).toBeGreaterThanOrEqual(small);
  expect(Math.abs(H - (large + small) / 2)).toBeLessThan(1e-3 * (Math.abs(large) + Math.abs(small)));
  expect(Math.abs(K - large * small)).toBeLessThan(1e-3 * (large * large + small * small));
  await photograph(page, 'researcher-read');

  const report = await reportOf(page);
  expect(report.problem.terms).toEqual({ bending: 0.5, mvs_cross: 0.1 });
  const [head, ...lines] = (await downloadedText(page, 'history')).trimEnd().split('\r\n');
  expect(head).toBe('evaluation,level,energy,gradient_norm');
  const samples = lines.map((line) => line.split(',').map(Number));
  expect(samples.map(([evaluation]) => evaluation)).toEqual(samples.map((_, i) => i + 1));
  expect(samples.flat().every(Number.isFinite)).toBe(true);
  const [level] = report.levels;
  // A level that goes on with a finer quadrature rule has higher energies from there on, so the last need not be the least.
  expect(samples.slice(-10).map(([, , energy]) => energy)).toContain(level.energy);
  const blended = 0.5 * report.energies.bending + 0.1 * report.energies.mvs_cross;
  expect(Math.abs(blended / level.energy_reported - 1)).toBeLessThan(1e-12);

  await page.locator('#certificate .row button').click();
  const answer = page.locator('#certificate [role=status]');
  await answer.filter({ hasText: /^(Yes|No): / }).waitFor();
  expect((await reportOf(page)).certificate).toMatchObject({ level: 0, unknowns: expect.any(Number) });
  await photograph(page, 'researcher-certified');

  // A link holds what is asked; the surface that it begins with is the cage's.
  await button(page, 'Reset').click();
  await settled(page);
  const asked = await reportOf(page);
  const link = await copiedLink(page);
  const other = await begin(served.browser, link);
  await measured(other.page);
  await settled(other.page);
  const received = await reportOf(other.page);
  expect(received.problem.terms).toEqual(asked.problem.terms);
  expect(apart(asked, received)).toBeLessThan(1e-12);
  expect([...errors, ...other.errors]).toEqual([]);
  await Promise.all([page.context().close(), other.page.context().close()]);
}, 240_000);
