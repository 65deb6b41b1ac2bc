// SPDX-License-Identifier: MIT
/**
 * @file The story of a designer: a body with a bump is faired while its head stays, judged by reflection lines, left and found
 * again, passed on as a project, and printed.
 */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { solidOf } from '../web/solid.js';
import { fish } from './fish.js';
import { download, dropFile, energies, look, measured, minimized, settled, status } from './page.js';
import { servedPage } from './served.js';
import { apart, begin, button, photograph, reportOf } from './story.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** What the page says of held faces. @param {Page} page */
const held = async (page) => Number(/^\d+/.exec(await page.locator('#held-count').innerText())?.[0] ?? 0);

/** Paints a spiral around the middle of the surface, in one stroke. @param {Page} page @param {number} most its radius, in heights of the picture */
async function paintSpiral(page, most) {
  const box = await page.locator('#surface canvas').boundingBox();
  if (!box) throw new Error('there is no picture');
  // The surface is shown a little above the middle, over its legend.
  const [x, y] = [box.x + box.width / 2, box.y + 0.465 * box.height];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let turn = 0; turn <= 4; turn += 1 / 12) {
    const [radius, angle] = [(most * box.height * turn) / 4, 2 * Math.PI * turn];
    await page.mouse.move(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  await page.mouse.up();
}

test('a designer fairs a body whose head stays, and takes home a project and a solid', async () => {
  const { page, errors } = await begin(served.browser, `${served.url}studio.html`);
  await measured(page);
  await dropFile(page, 'fish.obj', fish());
  await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
  await page.locator('[name=functional]').selectOption('bending');
  await page.locator('[name=last]').selectOption('1');

  // From the right the head is in front. It is painted, and everything else is what is held.
  await page.locator('#camera summary').click();
  await page.getByRole('button', { name: 'Right', exact: true }).click();
  await page.keyboard.press('Escape');
  await settled(page);
  await page.getByRole('radio', { name: 'Paint', exact: true }).check();
  await paintSpiral(page, 0.15);
  await settled(page);
  const painted = await held(page);
  expect(painted).toBeGreaterThanOrEqual(16);
  await button(page, 'Invert').click();
  await settled(page);
  expect(await held(page)).toBe(96 - painted);
  expect(await page.getByRole('checkbox', { name: /^body/ }).isChecked()).toBe(true);
  await page.getByRole('radio', { name: 'Turn', exact: true }).check();
  await page.locator('#camera summary').click();
  await page.getByRole('button', { name: 'Front', exact: true }).click();
  await page.keyboard.press('Escape');
  await photograph(page, 'designer-held');

  const before = await reportOf(page);
  await button(page, 'Start').click();
  await status(page, minimized);
  const faired = await reportOf(page);
  expect(faired.energies.free.bending).toBeLessThan(0.95 * before.energies.free.bending);
  const coloured = await look(page);
  await page.locator('[name=shading]').selectOption('stripes');
  const striped = await look(page);
  expect(striped.colours).not.toBe(coloured.colours);
  await photograph(page, 'designer-stripes');

  await page.locator('canvas').focus();
  await page.keyboard.press('Control+z');
  await status(page, /^Ready/);
  await page.keyboard.press('Control+Shift+Z');
  await status(page, minimized);
  const words = await energies(page);
  await page.waitForTimeout(2000); // within which everything is kept
  await page.reload();
  await status(page, minimized);
  await measured(page);
  expect(await energies(page)).toEqual(words);
  expect(await held(page)).toBe(96 - painted);
  expect(await page.locator('[name=shading]').inputValue()).toBe('stripes');
  expect(await button(page, 'Undo minimize').count()).toBe(1);
  expect(apart(faired, await reportOf(page))).toBeLessThan(1e-12);

  const folder = mkdtempSync(path.join(tmpdir(), 'story-'));
  const [project] = await Promise.all([page.waitForEvent('download'), button(page, 'Save project').click()]);
  const file = path.join(folder, project.suggestedFilename());
  await project.saveAs(file);
  const other = await begin(served.browser, `${served.url}studio.html`);
  await measured(other.page);
  await other.page.locator('#file').setInputFiles(file);
  await status(other.page, minimized);
  rmSync(folder, { recursive: true });
  expect(apart(faired, await reportOf(other.page))).toBeLessThan(1e-12);

  const { content } = await download(other.page, 'stl');
  const solid = await solidOf(new Uint8Array(content).buffer);
  expect([solid.status(), solid.genus()]).toEqual(['NoError', 0]);
  // An ellipsoid with half axes of about 2.2, 0.8 and 1, a little within its cage.
  expect(solid.volume()).toBeGreaterThan(5);
  expect(solid.volume()).toBeLessThan((4 / 3) * Math.PI * 2.2 * 1.2 * 1.2);
  await photograph(other.page, 'designer-reopened');
  expect([...errors, ...other.errors]).toEqual([]);
  await Promise.all([page.context().close(), other.page.context().close()]);
}, 240_000);
