// SPDX-License-Identifier: MIT
/**
 * @file What comes from elsewhere and goes there: a link that holds a problem, pasted text, and several files at once.
 */
import { describe, expect, test } from '@jest/globals';
import { fish } from './fish.js';
import { dropFile, dropFiles, energies, measured, openAddress, openPage, settled } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const permissions = ['clipboard-read', 'clipboard-write'];
const tetrahedron = 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n';

/** The names of the documents, in the order of their tabs. @param {Page} page */
const tabs = (page) => page.locator('#documents li button:first-child').allInnerTexts();

/** Pastes a text where the focus is. @param {Page} page @param {string} text */
async function paste(page, text) {
  await page.evaluate((written) => navigator.clipboard.writeText(written), text);
  await page.keyboard.press('Control+v');
}

/** @param {Page} page @param {string} words */
const alerted = (page, words) => page.locator('#alert').filter({ hasText: words }).waitFor();

describe('a link', () => {
  test('opens the problem of another page with its energies; one that is broken or too long is told', async () => {
    const { page, errors } = await openPage(served.browser, served.url, { permissions });
    await dropFile(page, 'fish.obj', fish());
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    await page.locator('[name=functional]').selectOption('bending');
    await page.getByRole('checkbox', { name: /^head/ }).check();
    await settled(page);
    await page.getByRole('button', { name: 'Copy link' }).click();
    await page.getByRole('button', { name: 'Copied' }).waitFor();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    expect(link.split('#')[1]).toMatch(/^p=[\w-]+$/);
    expect(page.url()).toBe(`${served.url}studio.html`);

    const other = await openAddress(served.browser, link);
    await measured(other.page);
    expect(await tabs(other.page)).toEqual(['fish.obj']);
    expect(await other.page.getByRole('checkbox', { name: /^head/ }).isChecked()).toBe(true);
    expect(await energies(other.page)).toEqual(await energies(page));
    expect(other.page.url()).toBe(`${served.url}studio.html`);

    // Followed from the page itself, as a paste into the address bar does.
    await other.page.evaluate((hash) => (location.hash = hash), link.slice(link.indexOf('#'), -3));
    await alerted(other.page, 'The link was not opened');
    await other.page.evaluate((hash) => (location.hash = hash), link.slice(link.indexOf('#')));
    await other.page.locator('#documents').filter({ hasText: 'fish.obj (2)' }).waitFor();

    const noise = Array.from({ length: 3000 }, (_, i) => `# ${Math.sin(i)}`).join('\n');
    await dropFile(page, 'long.obj', `${tetrahedron}${noise}`);
    await page.locator('.facts').filter({ hasText: 'long.obj' }).waitFor();
    await page.getByRole('button', { name: 'Copy link' }).click();
    await alerted(page, 'Save the project as a file instead');
    const [project] = await Promise.all([
      page.waitForEvent('download'),
      page.locator('#alert').getByRole('button', { name: 'Save project' }).click(),
    ]);
    expect(project.suggestedFilename()).toBe('long.umbilic.json');
    expect([...errors, ...other.errors]).toEqual([]);
    await other.page.context().close();
    await page.context().close();
  }, 60_000);
});

describe('pasted text and several files', () => {
  test('open as files do, and a broken one is told by its line; text fields keep what is pasted into them', async () => {
    const { page, errors } = await openPage(served.browser, served.url, { permissions });
    await paste(page, tetrahedron);
    await page.locator('.facts').filter({ hasText: 'pasted.obj' }).waitFor();
    await paste(page, `${tetrahedron}f 1 2 9\n`);
    await alerted(page, 'pasted.obj was not opened');
    expect(await page.locator('#alert').innerText()).toMatch(/line 9/);
    await page.locator('[name=within]').focus();
    await paste(page, '0.25');
    expect(await page.locator('[name=within]').inputValue()).toBe('0.25');

    await dropFiles(page, [
      ['first.obj', tetrahedron],
      ['second.obj', tetrahedron],
    ]);
    await page.locator('.facts').filter({ hasText: 'second.obj' }).waitFor();
    expect(await tabs(page)).toEqual(['pasted.obj', 'first.obj', 'second.obj']);
    const [chooser] = await Promise.all([
      page.waitForEvent('filechooser'),
      page.getByRole('button', { name: 'Choose file …' }).click(),
    ]);
    expect(chooser.isMultiple()).toBe(true);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);
});
