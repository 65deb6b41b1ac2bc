// SPDX-License-Identifier: MIT
/**
 * @file Serves the built page to a browser while a test file runs.
 */
import { mkdirSync } from 'node:fs';
import { afterAll, beforeAll } from '@jest/globals';
import { launchBrowser } from './browser.js';
import { builtPage, screenshots } from './page.js';
import { serve } from './site.js';

/**
 * @typedef {object} Served set before the first test
 * @property {import('playwright-core').Browser} browser
 * @property {string} url
 */

/** @returns {Served} */
export function servedPage() {
  const served = /** @type {Served} */ ({});
  /** @type {{url: string, close: () => Promise<void>} | undefined} */
  let site;
  beforeAll(async () => {
    mkdirSync(screenshots, { recursive: true });
    [site, served.browser] = await Promise.all([serve(builtPage), launchBrowser()]);
    served.url = site.url;
  });
  afterAll(async () => {
    await served.browser?.close();
    await site?.close();
  });
  return served;
}
