// SPDX-License-Identifier: MIT
/**
 * @file `npm run bench`: builds the benchmark natively and for WebAssembly, runs the given subjects (`npm run bench --
 * shapes metrics`; by default all that take few minutes), prints their tables and writes build/bench.json and
 * build/limits.json. `npm run bench -- readme` copies the last results into tests/bench/README.md and
 * tests/bench/known_limits.md.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import * as caps from './bench/caps.js';
import * as evolver from './bench/beside_evolver.js';
import * as estimates from './bench/estimates.js';
import * as factorization from './bench/factorization.js';
import * as limits from './bench/limits.js';
import * as metrics from './bench/metrics.js';
import * as overhead from './bench/overhead.js';
import * as quadrature from './bench/quadrature.js';
import * as scaling from './bench/scaling.js';
import * as shapes from './bench/shapes.js';
import * as shares from './bench/shares.js';
import { markdownTable, plainTable, replaceBetween } from './bench/tables.js';
import * as threads from './bench/threads.js';
import * as throughput from './bench/throughput.js';
import * as unsymmetric from './bench/unsymmetric.js';
import * as wasmThreads from './bench/wasm_threads.js';
import { build } from './build.js';
import { installPackages, installTools } from './install.js';
import { root } from './process.js';

/** @typedef {import('./bench/tables.js').Table} Table */
/**
 * @typedef {object} Subject
 * @property {() => any} measure
 * @property {(results: any) => Table[]} tables
 * @property {(results: any) => Table[]} summary for its README
 */

/** In the order of the tables. @type {Record<string, Subject>} */
const subjects = {
  throughput,
  shares,
  shapes,
  unsymmetric,
  metrics,
  overhead,
  scaling,
  threads,
  'wasm-threads': wasmThreads,
  estimates,
  factorization,
  evolver,
  quadrature,
  caps,
  limits,
};
/** Those that show what was chosen, or take long. */
const onRequest = ['unsymmetric', 'factorization', 'quadrature', 'caps', 'limits'];
const byDefault = Object.keys(subjects).filter((name) => !onRequest.includes(name));
const readme = path.join(root, 'tests/bench/README.md');

/** Where a table of its own stands. */
const limitsPage = path.join(root, 'tests/bench/known_limits.md');

/** @param {string} subject @returns {string} the file of its results */
const resultsOf = (subject) => path.join(root, 'build', subject === 'limits' ? 'limits.json' : 'bench.json');

/** @param {string} file @returns {Record<string, any>} the results of all runs so far, by subject */
const lastResults = (file) => (existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {});

/** @returns {string} the summaries of all subjects that were measured and are in the benchmark's README */
function summaries() {
  const all = lastResults(resultsOf('throughput'));
  return Object.entries(subjects)
    .filter(([name]) => name in all)
    .flatMap(([name, subject]) => subject.summary(all[name]))
    .map(markdownTable)
    .join('\n');
}

const wanted = process.argv.slice(2);
/** Replaces what a page says between its marks. @param {string} file @param {string} mark @param {string} text */
function rewrite(file, mark, text) {
  const before = readFileSync(file, 'utf8');
  writeFileSync(file, replaceBetween(before, `<!-- ${mark}: begin -->`, `<!-- ${mark}: end -->`, `\n${text}`));
}

if (wanted.join() === 'readme') {
  const known = lastResults(resultsOf('limits')).limits;
  if (summaries()) rewrite(readme, 'bench', summaries());
  if (known) rewrite(limitsPage, 'limits', limits.summary(known).map(markdownTable).join('\n'));
  process.exit();
}
const unknown = wanted.find((name) => !(name in subjects));
if (unknown) {
  console.error(`${unknown} is none of ${Object.keys(subjects).join(', ')}, readme`);
  process.exit(2);
}
const programs = wanted.join() !== 'limits';
/** @type {import('./install.js').Need[]} */
const needs = ['native'];
const targets = ['umbilic'];
if (programs) {
  needs.push('wasm');
  targets.push('umbilic_bench');
}
if (wanted.includes('factorization')) {
  needs.push('factorization');
  targets.push('umbilic_bench_factorization');
}
if (!(await installTools(...needs)) || !(await installPackages())) process.exit(1);
if (!(await build('native', ...targets))) process.exit(1);
if (programs && !(await build('wasm', 'umbilic_bench', 'umbilic-core', 'umbilic-core-threads'))) process.exit(1);
for (const name of wanted.length ? wanted : byDefault) {
  const start = performance.now();
  const measured = await subjects[name].measure();
  for (const table of subjects[name].tables(measured)) console.log(plainTable(table));
  const results = resultsOf(name);
  writeFileSync(results, JSON.stringify({ ...lastResults(results), [name]: measured }));
  console.error(`Results: ${path.relative(process.cwd(), results)}`);
  console.error(`${name}: measured in ${((performance.now() - start) / 1000).toFixed(0)} s`);
}
if (programs) console.log(`For tests/bench/README.md (\`npm run bench -- readme\` puts it there):\n\n${summaries()}`);
