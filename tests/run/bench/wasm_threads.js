// SPDX-License-Identifier: MIT
/**
 * @file The two modules of WebAssembly side by side: a run in that without threads, and in that with them on one and on all.
 */
import { execFileSync } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { root } from '../process.js';
import { digits } from './tables.js';

/** Seconds without threads, on one, and on all of them. @typedef {{functional: string, patches: number, threads: number, without: number, one: number, all: number}} WasmThreadsRow */

const LEVEL = 3;
const ITERATIONS = 30;
const ROUNDS = 3;

/**
 * The fastest of some runs, the first of which the engine compiles, in a process of their own.
 * @param {string} functional
 * @param {number | 'later'} threads
 * @returns {{seconds: number, patches: number}}
 */
function timed(functional, threads) {
  const options = { levels: [LEVEL, LEVEL], max_iterations: ITERATIONS, symmetry: false };
  const problem = { cage: { generator: 'two-3' }, terms: { [functional]: 1 }, options };
  const program = `
    import { Minimizer, load } from './wasm/umbilic.js';
    await load({ threads: ${JSON.stringify(threads)} });
    let seconds = Infinity, patches = 0;
    for (let round = 0; round < ${ROUNDS}; round++) {
      const minimizer = new Minimizer(${JSON.stringify(problem)});
      const start = performance.now();
      while (!minimizer.step(1));
      seconds = Math.min(seconds, (performance.now() - start) / 1000);
      patches = minimizer.levels[0].patches;
      minimizer.dispose();
    }
    console.log(JSON.stringify({ seconds, patches }));`;
  const args = ['--input-type=module', '-e', program];
  return JSON.parse(execFileSync(process.execPath, args, { cwd: root, encoding: 'utf8' }));
}

/** @returns {WasmThreadsRow[]} */
export function measure() {
  const threads = Math.min(availableParallelism(), 8);
  return ['bending', 'mvs_cross'].map((functional) => {
    const { seconds: without, patches } = timed(functional, 1);
    const [one, all] = /** @type {const} */ (['later', threads]).map((count) => timed(functional, count).seconds);
    return { functional, patches, threads, without, one, all };
  });
}

/** @param {WasmThreadsRow[]} rows @returns {import('./tables.js').Table[]} */
export const tables = (rows) => [
  {
    title: `A run of ${ITERATIONS} iterations in WebAssembly, the genus-2 frame without symmetry: the module without threads, and that with threads on one and on ${rows[0].threads} of them, seconds:`,
    head: ['functional', 'patches', 'without threads', 'one thread', `${rows[0].threads} threads`, 'faster by'],
    rows: rows.map(({ functional, patches, without, one, all }) => [
      ...[functional, patches, digits(without), digits(one), digits(all)],
      (without / all).toFixed(2),
    ]),
  },
];

export const summary = tables;
