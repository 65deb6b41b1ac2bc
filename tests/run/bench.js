// SPDX-License-Identifier: MIT
/**
 * @file `npm run bench`: builds the benchmark natively and for WebAssembly, runs both in turn and prints their tables;
 * `npm run bench -- quadrature` prints the errors of quadrature rules instead, `npm run bench -- evolver` times Surface Evolver.
 */
import { execFileSync } from 'node:child_process';
import { build } from './build.js';
import { evolverInstalled, evolverMissing, evolverTable, runEvolver } from './evolver.js';
import { installPackages, installTools } from './install.js';

/** @typedef {{instructionSet: string, flopsPerSecond: number}} Peak */
/** @typedef {{instructionSet: string, functional: string, cap: string, patches: number, samples: number, samplesPerSecond: number, flopsPerSample: number, tableBytes: number}} Throughput */
/** @typedef {{phase: string, seconds: number}} PhaseSeconds */
/** @typedef {{peaks: Peak[], throughput: Throughput[], phases: PhaseSeconds[]}} Speed */
/** @typedef {{functional: string, cap: string, regular: number, capped: number, grading: number, samples: number, error: number}} RuleError */

/** Rounds of both programs in turn; the best of each counts, because other work on the machine only slows them. */
const rounds = 3;

/** @param {string[]} head @param {(string | number)[][]} rows */
function printTable(head, rows) {
  const cells = [head, ...rows.map((row) => row.map(String))];
  const widths = head.map((_, i) => Math.max(...cells.map((row) => row[i].length)));
  for (const row of cells) {
    console.log(row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '));
  }
}

/** @param {string} program @param {...string} args */
function read(program, ...args) {
  return JSON.parse(execFileSync(program, args, { encoding: 'utf8', maxBuffer: 1 << 26 }));
}

/** @returns {Speed} */
const native = () => read('build/native/umbilic_bench');
/** @returns {Speed} */
const webAssembly = () => read(process.execPath, 'build/wasm/umbilic_bench.cjs');

/** The best of every figure. @param {Speed[]} runs @returns {Speed} */
function best(runs) {
  return {
    peaks: runs[0].peaks.map((row, i) => ({
      ...row,
      flopsPerSecond: Math.max(...runs.map((run) => run.peaks[i].flopsPerSecond)),
    })),
    throughput: runs[0].throughput.map((row, i) => ({
      ...row,
      samplesPerSecond: Math.max(...runs.map((run) => run.throughput[i].samplesPerSecond)),
    })),
    phases: runs[0].phases.map((row, i) => ({
      ...row,
      seconds: Math.min(...runs.map((run) => run.phases[i].seconds)),
    })),
  };
}

/** @param {Speed} speed @param {Peak} peak @returns {Throughput[]} what was measured with the peak's instruction set */
function throughputOf(speed, { instructionSet }) {
  return speed.throughput.filter((row) => row.instructionSet === instructionSet);
}

/** @param {number} fraction */
const percent = (fraction) => `${(100 * fraction).toFixed(0)} %`;

function printSpeed() {
  const runs = Array.from({ length: rounds }, () => ({ native: native(), wasm: webAssembly() }));
  const [n, w] = [best(runs.map((run) => run.native)), best(runs.map((run) => run.wasm))];
  const { patches } = n.throughput[0];
  const columns = [
    ...n.peaks.map((peak) => ({ name: peak.instructionSet, peak, rows: throughputOf(n, peak) })),
    ...w.peaks.map((peak) => ({ name: 'WebAssembly', peak, rows: throughputOf(w, peak) })),
  ];
  const [portable] = columns;
  console.log(`Energy and gradient, genus-2 flag frame, level 3, ${patches} patches, one core:`);
  console.log('million samples/s, all samples evaluated, capped patches included\n');
  printTable(
    ['functional', 'cap', 'samples', ...columns.map(({ name }) => name), 'WebAssembly/portable', 'tables MB'],
    portable.rows.map((row, i) => [
      row.functional,
      row.cap,
      row.samples,
      ...columns.map(({ rows }) => (rows[i].samplesPerSecond / 1e6).toFixed(2)),
      (columns[columns.length - 1].rows[i].samplesPerSecond / row.samplesPerSecond).toFixed(2),
      (row.tableBytes / 1e6).toFixed(2),
    ]),
  );
  console.log('\nThe same as a fraction of the measured peak of independent multiply-adds in registers\n');
  printTable(
    ['functional', 'cap', 'flops per sample', ...columns.map(({ name }) => name)],
    [
      ...portable.rows.map((row, i) => [
        row.functional,
        row.cap,
        Math.round(row.flopsPerSample),
        ...columns.map(({ peak, rows }) =>
          percent((rows[i].samplesPerSecond * row.flopsPerSample) / peak.flopsPerSecond),
        ),
      ]),
      ['peak, Gflop/s', '', '', ...columns.map(({ peak }) => (peak.flopsPerSecond / 1e9).toFixed(1))],
    ],
  );
  console.log('\nSeconds per phase, MVS_cross, the same level\n');
  printTable(
    ['phase', 'native', 'WebAssembly', 'ratio'],
    n.phases.map((row, i) => {
      const { seconds } = w.phases[i];
      return [row.phase, row.seconds.toFixed(5), seconds.toFixed(5), (row.seconds / seconds).toFixed(2)];
    }),
  );
}

function printQuadrature() {
  /** @type {RuleError[]} */
  const rows = read('build/native/umbilic_bench', 'quadrature').quadrature;
  console.log(
    'Relative errors of rules on genus-2 minimizers at level 2, which exploit the errors of the rule in use\n',
  );
  printTable(
    ['functional', 'cap', 'regular', 'capped', 'grading', 'samples', 'error'],
    rows.map((row) => [
      row.functional,
      row.cap,
      `${row.regular} x ${row.regular}`,
      `${row.capped} x ${row.capped}`,
      row.grading,
      row.samples,
      row.error.toExponential(1),
    ]),
  );
}

async function printEvolver() {
  if (!evolverInstalled()) {
    console.error(evolverMissing);
    process.exit(1);
  }
  const { head, cells } = evolverTable(await runEvolver({ log: console.error }));
  console.log('Surface Evolver on the genus-2 bending minimizer: 4 W + 8 pi = 112.7668; best of three, one core\n');
  printTable(head, cells);
  process.exit();
}

if (process.argv[2] === 'evolver') await printEvolver();
const quadrature = process.argv[2] === 'quadrature';
if (!(await installTools('native', 'wasm')) || !(await installPackages())) process.exit(1);
if (!(await build('native')) || !(quadrature || (await build('wasm')))) process.exit(1);
if (quadrature) printQuadrature();
else printSpeed();
