// SPDX-License-Identifier: MIT
/**
 * @file Pages of others that use the package as the README says, without a bundler and built by Vite. Each minimizes in a
 * worker and shows the energy.
 */
import path from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { example, installedPackage, output, root } from '../wasm/packed.js';
import { launchBrowser } from './browser.js';
import { openAddress } from './page.js';
import { serve } from './site.js';

const html = (/** @type {string} */ scripts) =>
  `<!doctype html><html lang="en"><head><title>A page</title><link rel="icon" href="data:," />${scripts}</head><body></body></html>`;

/** @type {ReturnType<typeof installedPackage>} */
let project;
/** @type {import('playwright-core').Browser} */
let browser;
let energy = '';

beforeAll(async () => {
  project = installedPackage();
  project.write('package.json', '{ "type": "module" }');
  project.write('main.js', example('js', "from 'umbilic/client';"));
  project.write('index.html', html('<script type="module" src="./main.js"></script>'));
  project.write('plain.html', html(example('html', 'importmap')));
  energy = project.node('node.js', example('js', "from 'umbilic';")).trim();
  browser = await launchBrowser();
});
afterAll(async () => {
  await browser?.close();
  project?.dispose();
});

// Vite's own program: its native parts do not work in Jest's contexts.
const vite = path.join(root, 'node_modules/vite/bin/vite.js');

/**
 * Opens a page, waits for its energy, and prints what it has loaded.
 * @param {string} address
 * @returns {Promise<string[]>} what the page said
 */
async function expectEnergy(address) {
  /** @type {string[]} */
  const said = [];
  let bytes = 0;
  /** @type {Array<Promise<void>>} */
  const sizes = [];
  const { page, errors, requests } = await openAddress(browser, address, {}, async (opened) => {
    opened.on('console', (message) => said.push(message.text()));
    opened.context().on('response', (response) => {
      sizes.push(response.body().then((body) => void (bytes += body.length)));
    });
  });
  await page.locator('body').filter({ hasText: /\d/ }).waitFor();
  expect(await page.locator('body').textContent()).toBe(energy);
  expect(errors).toEqual([]);
  await Promise.all(sizes);
  await page.context().close();
  console.log(`${path.basename(address)}: ${requests.length} files, ${Math.round(bytes / 1000)} kB`);
  return said;
}

test('a page without a bundler', async () => {
  const site = await serve(project.folder);
  try {
    const said = await expectEnergy(`${site.url}plain.html`);
    // Levels 0 and 1 with their energies, and surfaces.
    expect(said).toContainEqual(expect.stringMatching(/^1 \d+\.\d+$/));
    expect(said).toContainEqual(expect.stringMatching(/^\d+ vertices$/));
  } finally {
    await site.close();
  }
});

test('a page that Vite has built, under a path', async () => {
  output(process.execPath, [vite, 'build', '--base', './'], project.folder);
  const site = await serve(path.join(project.folder, 'dist'));
  try {
    await expectEnergy(`${site.url}index.html`);
  } finally {
    await site.close();
  }
});
