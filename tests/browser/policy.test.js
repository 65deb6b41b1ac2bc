// SPDX-License-Identifier: MIT
/**
 * @file The content security policy: every built page has it, and keeps it while it draws, computes and saves.
 */
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { builtPage, download, dropFile, measured, minimized, openAddress, status } from './page.js';
import { fish } from './fish.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
const pages = readdirSync(builtPage).filter((name) => name.endsWith('.html'));

describe('the HTML of a built page', () => {
  test('is that of all pages', () =>
    expect(pages.sort()).toEqual(['compare.html', 'index.html', 'methods.html', 'studio.html', 'torus.html']));

  test.each(pages)('%s has the policy before all that it is about, and no code or style in itself', (name) => {
    const html = readFileSync(path.join(builtPage, name), 'utf8').replace(/<!--.*?-->/gs, '');
    const [meta] = /<meta http-equiv="Content-Security-Policy"[^>]*>/.exec(html) ?? [''];
    expect(meta).toContain("default-src 'self'; script-src 'self' 'wasm-unsafe-eval';");
    expect(meta).not.toMatch(/'unsafe-(inline|eval)'|https?:|\*/);
    expect(html.indexOf(meta)).toBeLessThan(html.search(/<(link|script|style|svg)\b/));
    expect(html).not.toMatch(/<style\b|\sstyle=|\son[a-z]+=|javascript:/i);
    for (const [script] of html.matchAll(/<script\b.*?<\/script>/gs)) {
      expect(script).toMatch(/^<script type="module"[^>]* src="\.\/assets\/[^"]+"><\/script>$/);
    }
  });
});

/** What is done on each page before it is asked. @type {Record<string, (page: Page) => Promise<unknown>>} */
const work = {
  'index.html?entry=two-3.bending': async (page) => {
    await page.getByRole('dialog').getByRole('button', { name: 'Control mesh', exact: true }).click();
    await page.waitForFunction(() => !document.querySelector('#details [aria-disabled=true]'));
  },
  'compare.html?entries=two-3.bending,two-3.mvs': async (page) => {
    await page.locator('#energies td').first().waitFor();
    await page.locator('.ticks span').first().waitFor();
  },
  'methods.html': (page) => page.locator('#theme').filter({ hasText: 'Dark' }).waitFor(),
  'torus.html': (page) => page.locator('#energies-plot svg').waitFor(),
  'studio.html': async (page) => {
    await measured(page);
    await dropFile(page, 'fish.obj', fish());
    await page.locator('.facts').filter({ hasText: 'fish.obj' }).waitFor();
    await page.locator('[name=functional]').selectOption('bending');
    await page.locator('[name=last]').selectOption('0');
    await page.locator('[name=shading]').selectOption('deviation');
    await page.locator('#primary').click();
    await status(page, minimized);
    await download(page, 'picture');
  },
};

describe('a page', () => {
  test.each(Object.keys(work))(
    '%s does its work, in light and in dark, and violates nothing',
    async (address) => {
      const begun = { colorScheme: /** @type {const} */ ('light') };
      const { page, errors } = await openAddress(served.browser, served.url + address, begun, async (opened) => {
        await opened.addInitScript(() => {
          const found = /** @type {string[]} */ ([]);
          addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI, sample }) =>
            found.push(`${violatedDirective} ${blockedURI} ${sample}`),
          );
          Object.assign(window, { violations: found });
        });
      });
      await work[address](page);
      await page.emulateMedia({ colorScheme: 'dark' });
      await page.waitForFunction(() => matchMedia('(prefers-color-scheme: dark)').matches);
      expect(await page.evaluate(() => /** @type {any} */ (window).violations)).toEqual([]);
      expect(errors).toEqual([]);
      // The policy holds: what it forbids is told.
      await page.evaluate(() => document.body.setAttribute('style', 'color: red'));
      await page.waitForFunction(() => /** @type {any} */ (window).violations.length === 1);
      await page.context().close();
    },
    60_000,
  );
});
