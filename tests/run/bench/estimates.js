// SPDX-License-Identifier: MIT
/**
 * @file How long runs were expected to take, beside how long they took: all kinds of cages, natively on one thread and as
 * WebAssembly. In CPU seconds, so that other work on the machine does not count.
 */
import path from 'node:path';
import { root } from '../process.js';
import { benchRun, timeReport } from './programs.js';
import { digits, percent } from './tables.js';

/** @typedef {{ run: string, platform: string, expected: number, measured: number, evaluations: [number, number] }} Row the evaluations that were expected, and those that it took */

const symmetric = [
  ...['two-3', 'two-4', 'two-6', 'tetrahedron-frame', 'cube-frame', 'octahedron-frame', 'hexagonal-prism-frame'],
  ...['truncated-tetrahedron-frame', 'dodecahedron-frame', 'torus', 'cube'],
];
/** Seeded, and with what an animal's cage is like. */
const unsymmetric = ['moved-two-3', 'moved-two-3:2', 'moved-two-4', 'moved-tetrahedron-frame', 'pushed-cube', 'animal'];
const functionals = ['bending', 'mvs_cross'];
const fish = path.join(root, 'web/samples/fish.obj');

/** @param {number[]} values */
const sum = (values) => values.reduce((one, other) => one + other, 0);

/**
 * @param {'native' | 'wasm'} platform
 * @param {string} cage
 * @param {string} functional
 * @param {number} lastLevel
 * @param {'symmetric' | 'unsymmetric'} symmetry
 * @returns {Row}
 */
function row(platform, cage, functional, lastLevel, symmetry) {
  const run = benchRun(platform, { cage, functional, lastLevel, metric: 'auto', symmetry }, 1);
  return {
    run: `${cage}, ${functional}, level ${lastLevel}`,
    platform: platform === 'native' ? 'native' : 'WebAssembly',
    expected: sum(run.estimate.map(({ seconds }) => seconds)),
    measured: run.cpuSeconds,
    evaluations: [
      sum(run.estimate.map(({ evaluations }) => evaluations)),
      sum(run.levels.map(({ evaluations }) => evaluations)),
    ],
  };
}

/** @param {string} name @param {...string} args of the command line @returns {Row} */
function commandRow(name, ...args) {
  const { report, cpuSeconds } = timeReport([...args, '--threads', '1']);
  const { estimate, levels } = report;
  if (!estimate) throw new Error('a report without an estimate');
  return {
    run: name,
    platform: 'native',
    expected: estimate.seconds,
    measured: cpuSeconds,
    evaluations: [
      sum(estimate.levels.map(({ evaluations }) => evaluations)),
      sum(levels.map(({ evaluations }) => evaluations)),
    ],
  };
}

/** @returns {Row[]} */
export function measure() {
  return functionals.flatMap((functional) => [
    ...symmetric.map((cage) => row('native', cage, functional, 3, 'symmetric')),
    ...unsymmetric.flatMap((cage) => [1, 2].map((level) => row('native', cage, functional, level, 'unsymmetric'))),
    commandRow(
      `fish, head free, ${functional}`,
      fish,
      '--hold',
      'body',
      '--functional',
      functional,
      '--levels',
      '1..2',
    ),
    ...['two-3', 'cube-frame', 'torus'].map((cage) => row('wasm', cage, functional, 3, 'symmetric')),
    ...['moved-two-3', 'pushed-cube'].map((cage) => row('wasm', cage, functional, 1, 'unsymmetric')),
  ]);
}

/** @param {Row[]} rows the part of them that was expected within a factor of two */
const within = (rows) =>
  rows.filter(({ expected, measured }) => Math.abs(Math.log2(expected / measured)) <= 1).length / rows.length;

/** @param {Row[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: `What runs were expected to take, CPU seconds; ${percent(within(rows))} of ${rows.length} within a factor of two`,
      head: ['run', 'platform', 'expected', 'measured', 'expected / measured', 'evaluations', 'measured'],
      rows: rows.map(({ run, platform, expected, measured, evaluations }) => [
        ...[run, platform, digits(expected), digits(measured), (expected / measured).toFixed(2), ...evaluations],
      ]),
    },
  ];
}

export const summary = tables;
