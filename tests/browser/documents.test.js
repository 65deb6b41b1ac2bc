// SPDX-License-Identifier: MIT
/**
 * @file Nothing is lost in the studio: undo and redo by key and by button, documents as tabs, and what comes back after a
 * reload, in the middle of a run, after a visit to another page, and with two pages on one store.
 */
import { describe, expect, test } from '@jest/globals';
import { objCube, plyCube } from '../wasm/ply_cube.js';
import { fish } from './fish.js';
import {
  downloadedText,
  drawn,
  dropFile,
  evaluated,
  measured,
  minimized,
  openPage as open,
  progress,
  status,
} from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** @type {typeof open} */
async function openPage(...asked) {
  const opened = await open(...asked);
  opened.page.setDefaultTimeout(60_000); // runs take what they take
  return opened;
}

/** @param {Page} page @param {string | RegExp} name */
const button = (page, name) => page.getByRole('button', { name, exact: true });
/** The names of the tabs, that of the document on the screen with a star. @param {Page} page */
const tabs = (page) =>
  page
    .locator('#documents li button:first-child')
    .evaluateAll((all) =>
      all.map((one) => `${one.querySelector('.name')?.textContent}${one.getAttribute('aria-current') ? ' *' : ''}`),
    );
/** @param {Page} page */
const facts = (page) => page.locator('.facts').innerText();

/** Waits until everything that was done is in the store. @param {Page} page */
const kept = (page) => page.waitForTimeout(1500);

/** Minimizes a small cage. @param {Page} page */
async function minimize(page) {
  await page.locator('[name=functional]').selectOption('bending');
  await button(page, 'Start').click();
  await status(page, minimized, 60_000);
  await page.locator('#downloads [name=save]:not([aria-disabled=true])').waitFor();
}

/** A run that takes long. @param {Page} page */
async function longRun(page) {
  await page.getByRole('switch', { name: 'Keep symmetry' }).click();
  await page.locator('[name=last]').selectOption('3');
  await status(page, /^Ready/);
  await measured(page);
  await button(page, 'Start').click();
  await evaluated(page, 20);
}

describe('undo and redo', () => {
  test('by keys take back a file that was dropped on a minimized surface, and bring it again', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await minimize(page);
    const before = JSON.parse(await downloadedText(page, 'report'));
    await dropFile(page, 'fish.obj', fish());
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    await page.getByRole('checkbox', { name: /^head/ }).check();
    await page.locator('canvas').focus();
    await page.keyboard.press('Control+z');
    expect(await page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(false);
    expect(await page.locator('#edit [role=status]').textContent()).toBe('Undone: hold head.');
    await page.keyboard.press('Control+z');
    await status(page, minimized);
    expect(await facts(page)).not.toMatch(/fish/);
    await drawn(page);
    const after = JSON.parse(await downloadedText(page, 'report'));
    expect(after.energies.bending / before.energies.bending).toBeCloseTo(1, 12);
    const apart = after.surface.points.map((/** @type {number} */ x, /** @type {number} */ i) =>
      Math.abs(x - before.surface.points[i]),
    );
    expect(Math.max(...apart)).toBeLessThan(1e-14); // the core makes it symmetric again
    await page.keyboard.press('Control+Shift+Z');
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    await button(page, 'Redo hold head').click();
    expect(await page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(true);
    await button(page, 'Undo hold head').click();
    await button(page, 'Undo open fish.obj').click();
    await button(page, 'Undo minimize').click();
    await status(page, /^Ready/);
    await button(page, 'Undo minimize Bending energy').click();
    expect(await page.locator('[name=functional]').inputValue()).toBe('mvs_cross');
    expect(await page.locator('#undo').getAttribute('aria-disabled')).toBe('true');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 240_000);

  test('leave the keys to a field in which something is typed', async () => {
    const { page } = await openPage(served.browser, served.url);
    await page.locator('[name=last]').selectOption('1');
    await page.locator('[name=within]').fill('0.5');
    await page.keyboard.press('Control+z');
    expect(await page.locator('[name=last]').inputValue()).toBe('1');
    await page.context().close();
  });
});

describe('after a reload', () => {
  test('in the middle of a run, only the last moments are lost, and the run goes on from its surface', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await longRun(page);
    await evaluated(page, 30);
    const seen = await progress(page);
    await page.waitForTimeout(4000); // twice as long as it may take, since machines are noisy
    await page.reload();
    await status(page, /^(Minimizing|Bringing)/);
    await page.waitForFunction(() => /energy/.test(document.querySelector('#progress')?.textContent ?? ''));
    const first = await progress(page);
    expect(first.evaluations).toBeGreaterThanOrEqual(seen.evaluations);
    expect(first.energy).toBeLessThanOrEqual(seen.energy);
    await evaluated(page, first.evaluations + 10);
    const later = await progress(page);
    expect(later.energy).toBeLessThanOrEqual(first.energy);
    await button(page, 'Undo minimize').click();
    await status(page, /^Ready/);
    await button(page, 'Redo minimize').click();
    await status(page, /^Paused/);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 240_000);

  test('or a visit to another page, all documents are there, with what was done in them and to be undone', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await minimize(page);
    await button(page, 'New').click();
    await measured(page);
    await dropFile(page, 'fish.obj', fish());
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    await page.getByRole('checkbox', { name: /^head/ }).check();
    await status(page, /^Ready/);
    expect(await tabs(page)).toEqual(['Two junctions, 3 arms', 'fish.obj *']);
    await kept(page);
    await page.goto(`${served.url}torus.html`);
    await page.goto(`${served.url}studio.html`);
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    expect(await tabs(page)).toEqual(['Two junctions, 3 arms', 'fish.obj *']);
    expect(await page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(true);
    await measured(page);
    await button(page, 'Undo hold head').click();
    await button(page, 'Undo open fish.obj').click();
    await page.locator('.facts').filter({ hasText: 'Genus' }).waitFor();
    await page.locator('#documents li button').first().click();
    await status(page, minimized);
    await button(page, 'Undo minimize').click();
    await status(page, /^Ready/);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 240_000);
});

describe('a file of bytes that are no text', () => {
  test('is dropped, kept over a visit, passed on as text, and refused by the element that is wrong', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await dropFile(page, 'cube.ply', plyCube());
    await page.locator('.facts').filter({ hasText: 'cube.ply' }).waitFor();
    await measured(page);
    expect(await page.locator('.facts').innerText()).toMatch(/Vertices\s*8/);
    expect(JSON.parse(await downloadedText(page, 'problem')).cage).toEqual({ name: 'cube.ply', text: objCube() });
    await kept(page);
    await page.reload();
    await page.locator('.facts').filter({ hasText: 'cube.ply' }).waitFor();
    await measured(page);
    expect(JSON.parse(await downloadedText(page, 'problem')).cage).toEqual({ name: 'cube.ply', text: objCube() });
    await dropFile(page, 'broken.ply', plyCube(8));
    const notice = page.locator('#alert').filter({ hasText: 'broken.ply was not opened' });
    await notice.waitFor();
    expect(await notice.innerText()).toContain('index 8 does not exist: 8 vertices have the indices 0 to 7');
    expect(errors).toEqual([]);
    await page.context().close();
  });
});

describe('a document', () => {
  test('runs on while another one is on the screen', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await longRun(page);
    const before = await progress(page);
    await button(page, 'New').click();
    await measured(page);
    expect(await page.locator('#documents .runs').count()).toBe(1);
    await page.waitForTimeout(1000);
    await page.locator('#documents li button').first().click();
    await evaluated(page, before.evaluations + 5);
    await status(page, /^Minimizing/);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 240_000);

  test('that is closed can be opened again with its surface; the last one leaves a new one', async () => {
    const { page } = await openPage(served.browser, served.url);
    await minimize(page);
    await button(page, 'Close Two junctions, 3 arms').click();
    await status(page, /^Ready/);
    expect(await tabs(page)).toEqual(['Two junctions, 3 arms *']);
    await kept(page);
    await page.reload();
    await measured(page);
    await button(page, 'Reopen closed').click();
    await status(page, minimized);
    expect(await page.locator('#reopen').isHidden()).toBe(true);
    await page.context().close();
  }, 240_000);

  test('is opened by one of two pages only, which do not touch each other’s', async () => {
    const { page: first } = await openPage(served.browser, served.url);
    const another = async () => {
      const page = await first.context().newPage();
      await page.goto(`${served.url}studio.html`);
      await measured(page);
      return page;
    };
    await dropFile(first, 'one.obj', fish());
    await first.locator('.facts').filter({ hasText: 'one.obj' }).waitFor();
    await kept(first);
    const second = await another();
    expect(await tabs(second)).toEqual(['Two junctions, 3 arms *']);
    await dropFile(second, 'two.obj', fish());
    await second.locator('.facts').filter({ hasText: 'two.obj' }).waitFor();
    await first.getByRole('checkbox', { name: /^head/ }).check();
    await second.getByRole('checkbox', { name: /^body/ }).check();
    await Promise.all([kept(first), kept(second)]);
    await Promise.all([first.reload(), second.reload()]);
    for (const [page, name, group] of /** @type {const} */ ([
      [first, 'one.obj', /^head/],
      [second, 'two.obj', /^body/],
    ])) {
      await page.locator('.facts').filter({ hasText: name }).waitFor();
      expect(await tabs(page)).toEqual([`${name} *`]);
      expect(await page.getByRole('checkbox', { name: group }).isChecked()).toBe(true);
    }
    // What a page had that is gone can be opened in another, and is opened in the next new one.
    await second.close();
    await first.reload();
    await first.locator('.facts').filter({ hasText: 'one.obj' }).waitFor();
    await button(first, 'Reopen closed').click();
    await first.locator('.facts').filter({ hasText: 'two.obj' }).waitFor();
    expect(await tabs(first)).toEqual(['one.obj', 'two.obj *']);
    await first.context().close();
  }, 240_000);
});

test('a browser that keeps nothing says so, and asks before the page is left', async () => {
  const { page } = await openPage(served.browser, served.url, {}, async (fresh) => {
    await fresh.addInitScript(() => {
      Object.defineProperty(window, 'Worker', {
        value: class extends Worker {
          /** @param {string | URL} url @param {WorkerOptions} [options] */
          constructor(url, options) {
            super(/store/.test(String(url)) ? 'data:text/javascript,throw new Error("no room")' : url, options);
          }
        },
      });
    });
  });
  await page.locator('[name=last]').selectOption('1');
  await page.locator('#documents [role=status]').filter({ hasText: 'does not keep your work' }).waitFor();
  const asked = page.waitForEvent('dialog');
  void page.close({ runBeforeUnload: true });
  const dialog = await asked;
  expect(dialog.type()).toBe('beforeunload');
  await dialog.accept();
});
