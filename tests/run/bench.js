// SPDX-License-Identifier: MIT
/**
 * @file `npm run bench`: builds the benchmark natively and for WebAssembly, runs the given subjects (`npm run bench --
 * shapes metrics`; by default all but the quadrature rules and the caps), prints their tables and writes build/bench.json. `npm run
 * bench -- readme` copies the last results into tests/bench/README.md.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import * as caps from './bench/caps.js';
import * as evolver from './bench/beside_evolver.js';
import * as metrics from './bench/metrics.js';
import * as overhead from './bench/overhead.js';
import * as quadrature from './bench/quadrature.js';
import * as scaling from './bench/scaling.js';
import * as shapes from './bench/shapes.js';
import { markdownTable, plainTable, replaceBetween } from './bench/tables.js';
import * as threads from './bench/threads.js';
import * as throughput from './bench/throughput.js';
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
const subjects = { throughput, shapes, metrics, overhead, scaling, threads, evolver, quadrature, caps };
const byDefault = Object.keys(subjects).filter((name) => name !== 'quadrature' && name !== 'caps');
const results = path.join(root, 'build/bench.json');
const readme = path.join(root, 'tests/bench/README.md');

/** @returns {Record<string, any>} the results of all runs so far, by subject */
const lastResults = () => (existsSync(results) ? JSON.parse(readFileSync(results, 'utf8')) : {});

/** @returns {string} the summaries of all subjects that were measured */
function summaries() {
  const all = lastResults();
  return Object.entries(subjects)
    .filter(([name]) => name in all)
    .flatMap(([name, subject]) => subject.summary(all[name]))
    .map(markdownTable)
    .join('\n');
}

const wanted = process.argv.slice(2);
if (wanted.join() === 'readme') {
  const text = readFileSync(readme, 'utf8');
  writeFileSync(readme, replaceBetween(text, '<!-- bench: begin -->', '<!-- bench: end -->', `\n${summaries()}`));
  process.exit();
}
const unknown = wanted.find((name) => !(name in subjects));
if (unknown) {
  console.error(`${unknown} is none of ${Object.keys(subjects).join(', ')}, readme`);
  process.exit(2);
}
if (!(await installTools('native', 'wasm')) || !(await installPackages())) process.exit(1);
if (!(await build('native', 'umbilic', 'umbilic_bench')) || !(await build('wasm', 'umbilic_bench'))) process.exit(1);
for (const name of wanted.length ? wanted : byDefault) {
  const start = performance.now();
  const measured = await subjects[name].measure();
  for (const table of subjects[name].tables(measured)) console.log(plainTable(table));
  writeFileSync(results, JSON.stringify({ ...lastResults(), [name]: measured }));
  console.error(`${name}: measured in ${((performance.now() - start) / 1000).toFixed(0)} s`);
}
console.log(`For tests/bench/README.md (\`npm run bench -- readme\` puts it there):\n\n${summaries()}`);
console.error(`All results: ${path.relative(process.cwd(), results)}`);
