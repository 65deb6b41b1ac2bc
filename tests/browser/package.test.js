// SPDX-License-Identifier: MIT
/**
 * @file Pages of others that use the package as wasm/README.md says, without a bundler and built by Vite. Each minimizes in a
 * worker and shows the energy.
 */
import path from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { example, guide, installedPackage, output, root } from '../wasm/packed.js';
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
  /** Bytes of each file. @type {Map<string, number>} */
  const loaded = new Map();
  /** @type {Array<Promise<void>>} */
  const sizes = [];
  const { page, errors } = await openAddress(browser, address, {}, async (opened) => {
    opened.on('console', (message) => said.push(message.text()));
    opened.context().on('response', (response) => {
      sizes.push(response.body().then((body) => void loaded.set(response.url(), body.length)));
    });
  });
  await page.locator('body').filter({ hasText: /\d/ }).waitFor();
  expect(await page.locator('body').textContent()).toBe(energy);
  expect(errors).toEqual([]);
  await Promise.all(sizes);
  await page.context().close();
  const bytes = [...loaded.values()].reduce((sum, size) => sum + size, 0);
  console.log(`${path.basename(address)}: ${loaded.size} files, ${Math.round(bytes / 1000)} kB`);
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
  // The same once more, with the worker of which the guide speaks.
  const [worker] = /new Worker\(new URL\('umbilic\/worker', import\.meta\.url\).*?\)/.exec(guide) ?? [];
  const again = `minimize(problem, { createWorker: () => ${worker} })`;
  const main = example('js', "from 'umbilic/client';");
  project.write(
    'main.js',
    main.replace('document', `console.log('own', (await ${again}).energies.bending);\ndocument`),
  );
  output(process.execPath, [vite, 'build', '--base', './'], project.folder);
  const site = await serve(path.join(project.folder, 'dist'));
  try {
    expect(await expectEnergy(`${site.url}index.html`)).toContain(`own ${energy}`);
  } finally {
    await site.close();
  }
});
