// SPDX-License-Identifier: MIT
/**
 * @file `npm run faults [-- --short]`: builds the native program and what lets it fail (tests/faults), then lets memory,
 * writes and clocks fail at many positions, and prints what happened. Linux with glibc.
 */
import { pathToFileURL } from 'node:url';
import { build, parts } from './build.js';
import { failAllocations } from './faults/allocations.js';
import { jumpClocks } from './faults/clocks.js';
import { line } from './faults/row.js';
import { failWrites } from './faults/writes.js';
import { installPackages, installTools } from './install.js';

/** How many positions of each fault; 0 is all of them. */
const WHOLE = { first: 0, later: 200, bytes: 64 };
export const SHORT = { first: 4, later: 4, bytes: 4 };

/**
 * @param {typeof WHOLE} amount
 * @param {(row: import('./faults/row.js').Row) => void} tell called with each row once it is there
 */
export async function injectFaults({ first, later, bytes }, tell) {
  jumpClocks().forEach(tell);
  failWrites(bytes).forEach(tell);
  (await failAllocations(first, later)).forEach(tell);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const args = process.argv.slice(2);
  if (args.some((arg) => arg !== '--short')) {
    console.error('Usage: npm run faults [-- --short]');
    process.exit(2);
  }
  if (!(await installTools(...parts.native)) || !(await installPackages())) process.exit(1);
  if (!(await build('native', 'umbilic', 'umbilic_faults', 'umbilic_fault_shim'))) process.exit(1);
  console.log(`${'fault'.padEnd(76)}positions   outcomes`);
  await injectFaults(args.length ? SHORT : WHOLE, (row) => {
    console.log(line(row));
    if (row.wrong.length) process.exitCode = 1;
  });
}
