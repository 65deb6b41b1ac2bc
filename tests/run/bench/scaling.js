// SPDX-License-Identifier: MIT
/**
 * @file How the time of an evaluation and of a level grows with the number of patches, without symmetry.
 */
import { bench } from './programs.js';
import { digits, fitExponent } from './tables.js';

/** @typedef {{ patches: number, unknowns: number, evaluationSeconds: number, solveSeconds: number, evaluations: number, metric: string, metrics: number, stop: string, energy: number }} ScalingRow */

/** @returns {ScalingRow[]} */
export const measure = () => bench('native', 'scaling');

/** @param {ScalingRow[]} rows @returns {(string | number)[]} */
function exponents(rows) {
  const patches = rows.map((row) => row.patches);
  const of = (/** @type {(row: ScalingRow) => number} */ value) => fitExponent(patches, rows.map(value)).toFixed(2);
  return [of((row) => row.evaluationSeconds), of((row) => row.solveSeconds), of((row) => row.evaluations)];
}

/** The rows with the same metric as the last one, since the cost depends on the metric. @param {ScalingRow[]} rows */
const ofLastMetric = (rows) => rows.filter((row) => row.metric === rows[rows.length - 1].metric);

/** @param {ScalingRow[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  const all = exponents(rows);
  const same = exponents(ofLastMetric(rows));
  return [
    {
      title:
        'Bending, genus-2 frame without symmetry: an evaluation, and a level from the one before, minimized, to 1e-6',
      head: ['patches', 'unknowns', 'evaluation ms', 'solve s', 'evaluations', 'metric', 'built', 'stop', 'energy'],
      rows: [
        ...rows.map((row) => [
          ...[row.patches, row.unknowns, digits(1000 * row.evaluationSeconds), digits(row.solveSeconds)],
          ...[row.evaluations, row.metric, row.metrics, row.stop, row.energy.toFixed(5)],
        ]),
        ['exponent', '', ...all, '', '', '', ''],
        [`${rows[rows.length - 1].metric} only`, '', ...same, '', '', '', ''],
      ],
    },
  ];
}

/** @param {ScalingRow[]} rows @returns {import('./tables.js').Table[]} */
export function summary(rows) {
  const all = exponents(rows);
  const same = exponents(ofLastMetric(rows));
  return [
    {
      title:
        'Bending of the genus-2 frame without symmetry against the number of patches, each level from the minimized one before:',
      head: ['patches', ...rows.map((row) => String(row.patches)), 'exponent', `${rows[rows.length - 1].metric} only`],
      rows: [
        ['evaluation, ms', ...rows.map((row) => digits(1000 * row.evaluationSeconds)), all[0], same[0]],
        ['solve, s', ...rows.map((row) => digits(row.solveSeconds)), all[1], same[1]],
        ['evaluations', ...rows.map((row) => row.evaluations), all[2], same[2]],
        ['metric', ...rows.map((row) => row.metric), '', ''],
      ],
    },
  ];
}
