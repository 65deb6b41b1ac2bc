// SPDX-License-Identifier: MIT
/**
 * @file Two tabs of one browser on one store: one that was duplicated leaves the documents to the first and says where they
 * are; where the browser cannot say whose a document is, both versions are kept. (documents.test.js has two that were opened
 * one after the other.)
 */
import { expect, test } from '@jest/globals';
import { fish } from './fish.js';
import { dropFile, measured, openPage, status } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();

/** Waits until everything that was done is in the store. @param {Page} page */
const kept = (page) => page.waitForTimeout(1500);
/** @param {Page} page */
const names = (page) => page.locator('#documents li .name').allInnerTexts();
/** @param {Page} page @param {string} name */
const group = (page, name) => page.getByRole('checkbox', { name: new RegExp(`^${name}`) });
/** @param {Page} page @param {string} name */
const opened = (page, name) => page.locator('.facts').filter({ hasText: name }).waitFor();

test('a tab that was duplicated begins a new document, says where the others are, and damages none', async () => {
  const { page: first, errors } = await openPage(served.browser, served.url);
  await dropFile(first, 'fish.obj', fish());
  await opened(first, 'fish.obj');
  await group(first, 'head').check();
  await kept(first);
  // A window that a page opens has a copy of what its tab remembers, as a duplicated tab has.
  const [second] = await Promise.all([
    first.waitForEvent('popup'),
    first.evaluate(() => void window.open(location.href)),
  ]);
  await measured(second);
  const told = second.locator('#documents [role=status]');
  await told.filter({ hasText: '1 document is open in another tab of the browser.' }).waitFor();
  expect(await names(second)).toEqual(['Two junctions, 3 arms']);
  await second.locator('[name=last]').selectOption('1');
  await group(first, 'body').check();
  await Promise.all([kept(first), kept(second)]);
  await second.getByRole('button', { name: 'New', exact: true }).click();
  await told.filter({ hasText: /^$/ }).waitFor({ state: 'attached' });

  await second.close();
  await first.reload();
  await opened(first, 'fish.obj');
  expect(await names(first)).toEqual(['fish.obj']);
  expect([await group(first, 'head').isChecked(), await group(first, 'body').isChecked()]).toEqual([true, true]);
  await first.getByRole('button', { name: 'Undo hold body' }).click();
  expect([await group(first, 'head').isChecked(), await group(first, 'body').isChecked()]).toEqual([true, false]);
  expect(errors).toEqual([]);
  await first.context().close();
}, 120_000);

test('where the browser has no locks, a document that two tabs change becomes two, and the later one says so', async () => {
  const { page: first, errors } = await openPage(served.browser, served.url, {}, async (fresh) => {
    await fresh
      .context()
      .addInitScript(() => Object.defineProperty(Navigator.prototype, 'locks', { value: undefined }));
  });
  await dropFile(first, 'fish.obj', fish());
  await opened(first, 'fish.obj');
  await kept(first);
  const second = await first.context().newPage();
  await second.goto(`${served.url}studio.html`);
  await opened(second, 'fish.obj');
  await group(second, 'body').check();
  await kept(second);
  await group(first, 'head').check();
  await first.locator('#alert').filter({ hasText: 'Another tab has changed this document' }).waitFor();
  await Promise.all([kept(first), kept(second)]);
  expect(await second.locator('#alert').isVisible()).toBe(false);
  await second.close();
  await first.close();

  const third = await first.context().newPage();
  await third.goto(`${served.url}studio.html`);
  await opened(third, 'fish.obj');
  expect(await names(third)).toEqual(['fish.obj', 'fish.obj (2)']);
  const found = [];
  for (const name of await names(third)) {
    await third.getByRole('button', { name, exact: true }).click();
    await status(third, /^Ready/);
    found.push([await group(third, 'head').isChecked(), await group(third, 'body').isChecked()]);
  }
  expect(found.sort()).toEqual([
    [false, true],
    [true, false],
  ]);
  expect(errors).toEqual([]);
  await third.context().close();
}, 120_000);
