// SPDX-License-Identifier: MIT
/**
 * @file The result of a run as a designer meets it: one sentence, said once, and one button that does what comes next, by mouse
 * and by keyboard; what a functional prefers, in pictures; and the way from the home page to a cage of one's own.
 */
import path from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { functionals } from '../../web/words/functionals.js';
import { Cage, load } from '../../wasm/umbilic.js';
import { dropFile, evaluated, measured, minimized, openAddress, openPage, screenshots, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
let frame = '';

beforeAll(async () => {
  await load();
  const cage = Cage.generate('tetrahedron-frame');
  frame = cage.obj();
  cage.dispose();
});

/** Records what the live region says from now on. @param {Page} page */
async function heard(page) {
  const texts = await page.evaluateHandle(() => {
    const line = /** @type {Element} */ (document.querySelector('#status'));
    /** @type {string[]} */
    const seen = [];
    new MutationObserver(() => seen.push(line.textContent ?? '')).observe(line, { childList: true });
    return seen;
  });
  return () => texts.jsonValue();
}

/** @param {Page} page */
const focused = (page) => page.evaluate(() => document.activeElement?.id);

describe('a run', () => {
  test('from start to end says what it does, and once what came out; one level finer gives its accuracy', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    const said = await heard(page);
    await page.locator('#primary').click();
    await status(page, minimized, 60_000);
    await page.locator('canvas[data-picture=fine]').waitFor();
    const first = await said();
    expect(first).toEqual(['Minimizing …', expect.stringMatching(/^The energy keeps falling .* an upper bound; /)]);
    const shown = await page.locator('main').innerText();
    expect(shown).not.toMatch(/±|converged|error bar/i);

    const next = page.locator('#next');
    expect(await next.innerText()).toBe('Go one level finer');
    await next.focus();
    await page.keyboard.press('Enter');
    await status(page, /^Minimizing/);
    expect(await focused(page)).toBe('primary'); // the focus is not lost with the button
    await status(page, /^Minimized: [\d.]+, within [\d.]+\u202f%\.$/, 60_000);
    expect(await next.innerText()).toBe('Check that it is a minimum');
    expect(await page.locator('button.primary:visible').allInnerTexts()).toEqual([await next.innerText()]);
    await page.screenshot({ path: path.join(screenshots, 'verdict.png') });
    await next.click();
    await status(page, /^A minimum: /, 60_000);
    expect(await next.isVisible()).toBe(false);
    expect(await page.locator('button.primary:visible').allInnerTexts()).toEqual(['Start']);
    await page.locator('#undo').click(); // the run before, of three levels
    await status(page, /^The energy keeps falling/);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 150_000);

  test('that was stopped goes on from its surface', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    await page.getByRole('switch', { name: 'Keep symmetry' }).uncheck(); // so that the run is not over too soon
    await page.locator('[name=last]').selectOption('4');
    await page.locator('[name=first]').selectOption('2');
    await measured(page);
    await page.locator('#primary').click();
    await evaluated(page, 12);
    await page.locator('#cancel').click();
    await status(page, /^Stopped at \S+; it was still falling\.$/);
    const energy = async () =>
      Number(/energy ([\d.]+)/.exec((await page.locator('#progress').innerText()).replaceAll('\u202f', ''))?.[1]);
    await measured(page);
    const before = await energy();
    await page.getByRole('button', { name: 'Go on' }).click();
    await status(page, /^Minimizing/);
    await evaluated(page, 5);
    await page.locator('#primary').click();
    await status(page, /^Paused at/);
    expect(await energy()).toBeLessThanOrEqual(before * 1.001);
    expect(await page.locator('#next').isVisible()).toBe(false); // Resume stands there
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);
});

test('what each functional prefers is said, and shown by pictures that lead to their entries of the catalog', async () => {
  const { page, errors } = await openPage(served.browser, served.url);
  const words = new Set();
  for (const { id, prefers, pictured } of functionals) {
    await page.locator('[name=functional]').selectOption(id);
    expect(await page.locator('#functional-words').innerText()).toBe(prefers);
    words.add(prefers);
    const pictures = page.locator('#examples img');
    if (pictured) await pictures.first().scrollIntoViewIfNeeded();
    await page.waitForFunction(() =>
      [...document.querySelectorAll('#examples img')].every(
        (one) => /** @type {HTMLImageElement} */ (one).naturalWidth > 0,
      ),
    );
    expect(await pictures.count()).toBe(pictured ? 3 : 0);
  }
  expect(words.size).toBe(functionals.length);
  await page.locator('[name=functional]').selectOption('blend');
  expect(await page.locator('#functional-words').innerText()).toMatch(/^A weighted sum/);
  await page.locator('[name=functional]').selectOption('mvs');
  await page.getByRole('link', { name: 'Tetrahedron frame' }).click();
  await page.locator('#details[open] h2').filter({ hasText: 'Tetrahedron frame' }).waitFor();
  expect(page.url()).toContain('entry=tetrahedron-frame.mvs');
  expect(errors).toEqual([]);
  await page.context().close();
}, 60_000);

describe('from the home page', () => {
  test('one button leads to the studio, which asks for a cage; a file that is dropped there closes the question', async () => {
    const { page, errors } = await openAddress(served.browser, `${served.url}index.html`);
    await page.getByRole('link', { name: 'Try it on your own cage' }).click();
    const invitation = page.getByRole('dialog', { name: 'Open a cage of your own' });
    await invitation.waitFor();
    await measured(page);
    await dropFile(page, 'my frame.obj', frame);
    await page.locator('.facts').filter({ hasText: 'my frame.obj' }).waitFor();
    expect(await invitation.count()).toBe(0);
    expect(page.url()).not.toContain('#');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('the file can be chosen by the keyboard, and the question be left', async () => {
    const { page } = await openAddress(served.browser, `${served.url}studio.html#open`);
    const invitation = page.getByRole('dialog', { name: 'Open a cage of your own' });
    await invitation.waitFor();
    const asked = page.waitForEvent('filechooser'); // which the browser must know of before the key is pressed
    await measured(page);
    await page.keyboard.press('Enter');
    const chooser = await asked;
    await chooser.setFiles({ name: 'mine.obj', mimeType: 'model/obj', buffer: Buffer.from(frame) });
    await page.locator('.facts').filter({ hasText: 'mine.obj' }).waitFor();
    await page.goto('about:blank');
    await page.goto(`${served.url}studio.html#open`);
    await invitation.waitFor();
    await page.keyboard.press('Escape');
    expect(await invitation.count()).toBe(0);
    await page.context().close();
  }, 60_000);
});
