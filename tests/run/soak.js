// SPDX-License-Identifier: MIT
/**
 * @file `npm run soak`: builds the page and uses the studio 200 times, with a document for each cage and with one for all.
 * Prints the memory that it has after the 10th time and at the end, and fails where that of the page or of its worker's module
 * has grown by more than 5 %. The browser's process keeps caches of its own, of which it gives back what it likes, so only half
 * as much again fails there.
 * `npm run soak -- 40` does so 40 times.
 */
import { launchBrowser } from '../browser/browser.js';
import { builtPage } from '../browser/page.js';
import { serve } from '../browser/site.js';
import { UNCOMPILED, cycles, soak } from '../browser/soak.js';
import { build } from './build.js';
import { installPackages, installTools } from './install.js';

/** When memory is measured first; caches are full by then. */
const FIRST = 10;

const last = Number(process.argv[2] ?? 200);
if (!(Number.isInteger(last) && last > FIRST)) {
  console.error(`The number of cycles must be a whole number above ${FIRST}.`);
  process.exit(2);
}
if (!(await installTools('wasm', 'browser')) || !(await installPackages())) process.exit(1);
if (!(await build('wasm')) || !(await build('web'))) process.exit(1);

/** What is measured, what it is called, and by how much it may grow. */
const measured = /** @type {const} */ ([
  ['heap', 'JavaScript heap', 0.05],
  ['buffers', 'JavaScript arrays', 0.05],
  ['module', 'WebAssembly memory', 0.05],
  ['renderer', 'process', 0.5],
]);
const megabytes = (/** @type {number} */ bytes) => `${(bytes / 1e6).toFixed(2)} MB`.padStart(12);
const [site, browser] = await Promise.all([serve(builtPage), launchBrowser(UNCOMPILED)]);
let grown = false;
console.log(`${''.padEnd(32)}${`cycle ${FIRST}`.padStart(12)}${`cycle ${last}`.padStart(12)}`);
for (const [name, cycle] of Object.entries(cycles)) {
  const found = await soak(browser, site.url, cycle, { first: FIRST, last });
  for (const [what, words, most] of measured) {
    const [before, after] = [found.first[what], found.last[what]];
    const growth = after / before - 1;
    grown ||= growth > most;
    const verdict = growth > most ? `   grown by ${(100 * growth).toFixed(1)} %` : '';
    console.log(`${`${name}, ${words}`.padEnd(32)}${megabytes(before)}${megabytes(after)}${verdict}`);
  }
  console.log(
    `${`${name}, workers`.padEnd(32)}${[found.first, found.last].map(({ workers }) => String(workers).padStart(12)).join('')}`,
  );
  grown ||= found.last.workers > found.first.workers;
}
await browser.close();
await site.close();
process.exitCode = grown ? 1 : 0;
