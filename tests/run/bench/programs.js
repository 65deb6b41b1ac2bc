// SPDX-License-Identifier: MIT
/**
 * @file Runs the benchmark programs and the command line, one process per measurement, and keeps the fastest of several
 * rounds, because other work on the machine can only slow them down.
 */
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { root } from '../process.js';

/** @typedef {'native' | 'wasm'} Platform */
/**
 * @typedef {object} LevelRow
 * @property {number} level
 * @property {number} patches
 * @property {number} unknowns
 * @property {number} energy by the minimizing rule
 * @property {number} energyReported
 * @property {number} iterations
 * @property {number} evaluations
 * @property {string} metric
 * @property {number} metrics how often a metric was assembled
 * @property {number} seconds
 * @property {string} stop
 */
/** @typedef {{ level: number, unknowns: number, evaluations: number, seconds: number }} EstimateRow what was expected of a level */
/** @typedef {{ seconds: number, cpuSeconds: number, group: string, order: number, levels: LevelRow[], estimate: EstimateRow[], steps: import('./tables.js').Step[] }} RunRow */
/** @typedef {{ cage: string, functional: string, lastLevel: number, metric: string, symmetry: 'symmetric' | 'unsymmetric' }} RunChoice */

const native = path.join(root, 'build/native');

/** What the native benchmark prints. @param {...string} args @returns {string} */
export const benchText = (...args) => execFileSync(path.join(native, 'umbilic_bench'), args, { encoding: 'utf8' });

/**
 * What the benchmark's program that links CHOLMOD prints, with one thread of the BLAS that CHOLMOD calls.
 * @returns {any} described in tests/bench/factorization/main.cpp
 */
export function benchFactorization() {
  const env = { ...process.env, OPENBLAS_NUM_THREADS: '1' };
  return JSON.parse(execFileSync(path.join(native, 'umbilic_bench_factorization'), { encoding: 'utf8', env }));
}

/**
 * The measurements of one subject of the benchmark.
 * @param {Platform} platform
 * @param {...string} args
 * @returns {any} described in the subject's main.cpp
 */
export function bench(platform, ...args) {
  const [program, ...first] =
    platform === 'native'
      ? [path.join(native, 'umbilic_bench')]
      : [process.execPath, path.join(root, 'build/wasm/umbilic_bench.cjs')];
  return JSON.parse(execFileSync(program, [...first, ...args], { encoding: 'utf8', maxBuffer: 1 << 28 }));
}

/**
 * The fastest of at most `rounds` runs, fewer if they would take more than a few seconds.
 * @param {Platform} platform
 * @param {RunChoice} choice
 * @param {number} [rounds]
 * @returns {RunRow}
 */
export function benchRun(platform, { cage, functional, lastLevel, metric, symmetry }, rounds = 3) {
  /** @type {RunRow[]} */
  const runs = [];
  let total = 0;
  while (runs.length < rounds && total < 3) {
    runs.push(bench(platform, 'run', cage, functional, String(lastLevel), metric, symmetry));
    total += runs[runs.length - 1].seconds;
  }
  return runs.reduce((a, b) => (b.seconds < a.seconds ? b : a));
}

/**
 * One run of the command line with its report.
 * @param {string[]} args of `optimize`
 * @returns {{ report: import('../../../wasm/types.js').Report, seconds: number, cpuSeconds: number }}
 */
export function timeReport(args) {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  try {
    const file = path.join(folder, 'report.json');
    const times = timeUmbilic(['optimize', ...args, '--quiet', '--report', file], 1);
    return { report: JSON.parse(readFileSync(file, 'utf8')), ...times };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * The times of a whole process of the command line, the fastest of some rounds.
 * @param {string[]} args
 * @param {number} [rounds]
 * @returns {{ seconds: number, cpuSeconds: number }}
 */
export function timeUmbilic(args, rounds = 5) {
  const timed = ['-c', 'TIMEFORMAT="%R %U %S"; time "$@" > /dev/null', 'bash', path.join(native, 'umbilic'), ...args];
  const results = Array.from({ length: rounds }, () => {
    const { status, stderr } = spawnSync('bash', timed, { encoding: 'utf8' });
    if (status !== 0) throw new Error(`umbilic ${args.join(' ')}: ${stderr}`);
    const [seconds, user, system] = stderr.trim().split(/\s+/).slice(-3).map(Number);
    return { seconds, cpuSeconds: user + system };
  });
  return results.reduce((a, b) => (b.seconds < a.seconds ? b : a));
}
