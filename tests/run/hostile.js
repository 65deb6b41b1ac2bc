// SPDX-License-Identifier: MIT
/**
 * @file `npm run hostile [-- FAMILY …]`: builds, runs the tables of hostile inputs (tests/hostile) natively and in WebAssembly,
 * and prints each row with how it ended and how long that took. `npm test` runs the same rows.
 */
import { tmpdir } from 'node:os';
import { families } from '../hostile/rows.js';
import { faults, printable } from '../hostile/verdict.js';
import { build, parts } from './build.js';
import { installPackages, installTools } from './install.js';

/** @typedef {import('../hostile/row.js').Row} Row */
/** @typedef {import('../hostile/verdict.js').Ended} Ended */

const asked = process.argv.slice(2);
const unknown = asked.filter((name) => !families.some(([family]) => family === name));
if (unknown.length) {
  console.error(`Usage: npm run hostile [-- ${families.map(([family]) => family).join(' | ')} …]`);
  process.exit(2);
}
if (!(await installTools(...parts.native, ...parts.wasm)) || !(await installPackages())) process.exit(1);
if (!(await build('native', 'umbilic')) || !(await build('wasm'))) process.exit(1);

// These need what was built.
const { runNatively } = await import('../hostile/native.js');
const { runInWebAssembly } = await import('../hostile/web_assembly.js');
const { load } = await import('../../wasm/umbilic.js');
await load();

/** @type {Record<string, number>} */
const counts = {};
const before = process.memoryUsage.rss();

/** @param {Row} row @param {Ended | undefined} ended @returns {string} */
function cell(row, ended) {
  if (!ended) return ''.padStart(10);
  const found = faults(row, ended);
  for (const fault of found) console.log(`WRONG: ${row.name}: ${fault}`);
  if (found.length) process.exitCode = 1;
  return `${(1000 * ended.seconds).toFixed(0)} ms`.padStart(10);
}

console.log(`${'family'.padEnd(10)}${'native'.padStart(10)}${'wasm'.padStart(10)}  outcome    input: what is said`);
for (const [family, rows] of families) {
  if (asked.length && !asked.includes(family)) continue;
  for (const row of rows) {
    const native = cell(row, runNatively(row, tmpdir()));
    const wasm = cell(row, row.kind === 'command' ? undefined : runInWebAssembly(row));
    const name = printable(row.name);
    console.log(`${family.padEnd(10)}${native}${wasm}  ${row.outcome.padEnd(9)}  ${name}: ${row.says}`);
    counts[row.outcome] = (counts[row.outcome] ?? 0) + 1;
  }
}
const total = Object.values(counts).reduce((sum, count) => sum + count, 0);
const outcomes = Object.entries(counts).map(([outcome, count]) => `${count} ${outcome}`);
console.log(`\n${total} rows: ${outcomes.join(', ')}`);
console.log(`WebAssembly: ${((process.memoryUsage.rss() - before) / 2 ** 20).toFixed(0)} MB more for all of them`);
