// SPDX-License-Identifier: MIT
/**
 * @file Where the core has threads: under the headers that `npm start` sends, and from the second visit on where a host sends none.
 * Everywhere else, and wherever threads do not come, the studio works without, to the same energy.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { headers } from '../../web/headers.js';
import { launchBrowser } from './browser.js';
import { builtPage, downloadedText, measured, minimized, openPage, status } from './page.js';
import { serve } from './site.js';

/** @typedef {import('playwright-core').Page} Page */

/** @type {import('playwright-core').Browser} */
let browser;
beforeAll(async () => {
  browser = await launchBrowser();
});
afterAll(() => browser?.close());

/** Which parts of the core were loaded, without what tells versions apart. @param {string[]} requests */
const loaded = (requests) => {
  const names = requests.map((url) => /\/(?:umbilic-)?(core(?:-threads)?|thread)-[\w-]+\.(wasm|js)$/.exec(url));
  return [...new Set(names.map((name) => name && `${name[1]}.${name[2]}`))].filter(Boolean).sort();
};

/** Minimizes a cage with enough patches for all loops to be shared. @param {Page} page */
async function minimize(page) {
  await page.locator('[name=functional]').selectOption('bending');
  await page.getByRole('switch', { name: 'Keep symmetry' }).click();
  await page.locator('[name=last]').selectOption('2');
  await page.locator('#primary').click();
  await status(page, minimized, 60_000);
  const { energies, levels } = JSON.parse(await downloadedText(page, 'report'));
  return { energies, evaluations: levels.map((/** @type {any} */ level) => level.evaluations) };
}

/**
 * Minimizes on a site.
 * @param {Parameters<typeof serve>[1]} how the site is served
 * @param {(page: Page) => Promise<void>} [before] done first on the page, which has been opened
 */
async function visit(how, before = async () => {}) {
  const site = await serve(builtPage, how);
  try {
    /** @type {string[]} */
    const requests = [];
    const { page, errors } = await openPage(browser, site.url, {}, async (opened) => {
      opened.context().on('request', (request) => requests.push(request.url()));
    });
    await before(page);
    const isolated = await page.evaluate(() => crossOriginIsolated);
    const result = await minimize(page);
    await page.context().close();
    return { isolated, loaded: loaded(requests), errors, result };
  } finally {
    await site.close();
  }
}

describe('the studio', () => {
  /** @type {Awaited<ReturnType<typeof visit>>} */
  let alone;
  beforeAll(async () => {
    alone = await visit({});
  }, 60_000);

  test('has no threads where the host sends no headers', () =>
    expect(alone).toMatchObject({ isolated: false, loaded: ['core.wasm'], errors: [] }));

  test('has threads under the headers of npm start, and ends with the same energies', async () => {
    const shared = await visit({ headers });
    expect(shared).toMatchObject({ isolated: true, errors: [], result: alone.result });
    expect(shared.loaded).toEqual(expect.arrayContaining(['thread.js', 'core-threads.wasm']));
    expect(shared.loaded).not.toContain('core.wasm');
  }, 60_000);

  test.each([
    ['the module that has them', /core-threads-.*wasm/],
    ['what a thread runs in', /\/thread-/],
  ])(
    'works without threads where %s does not come',
    async (_, missing) => {
      const { isolated, result } = await visit({ headers, missing });
      expect({ isolated, result }).toEqual({ isolated: true, result: alone.result });
    },
    60_000,
  );

  test('has threads from the second visit on where its service worker adds the headers', async () => {
    const second = await visit({}, async (page) => {
      await page.evaluate(() => navigator.serviceWorker.ready);
      await page.reload();
      await measured(page);
    });
    expect(second).toMatchObject({ isolated: true, errors: [], result: alone.result });
    expect(second.loaded).toContain('core-threads.wasm');
  }, 60_000);
});
