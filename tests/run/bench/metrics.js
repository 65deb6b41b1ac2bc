// SPDX-License-Identifier: MIT
/**
 * @file What each metric of the optimizer gains: the same runs with the identity, the Sobolev and the Hessian metric.
 */
import { benchRun } from './programs.js';
import { digits } from './tables.js';

/** @typedef {{ case: string, metric: string, evaluations: number, seconds: number, energy: number, stop: string }} MetricRow */

/** @type {{ name: string, choice: Omit<import('./programs.js').RunChoice, 'metric'> }[]} */
const cases = [
  {
    name: 'genus 2, bending, symmetric, level 3',
    choice: { cage: 'two-3', functional: 'bending', lastLevel: 3, symmetry: 'symmetric' },
  },
  {
    name: 'genus 2, MVS_cross, symmetric, level 3',
    choice: { cage: 'two-3', functional: 'mvs_cross', lastLevel: 3, symmetry: 'symmetric' },
  },
  {
    name: 'genus 2, MVS_cross, unsymmetric, level 2',
    choice: { cage: 'two-3', functional: 'mvs_cross', lastLevel: 2, symmetry: 'unsymmetric' },
  },
  {
    name: 'pushed cube, bending, unsymmetric, level 1',
    choice: { cage: 'pushed-cube', functional: 'bending', lastLevel: 1, symmetry: 'unsymmetric' },
  },
];
const metrics = ['identity', 'sobolev', 'hessian'];

/** @returns {MetricRow[]} */
export function measure() {
  return cases.flatMap(({ name, choice }) =>
    metrics.map((metric) => {
      const { seconds, levels } = benchRun('native', { ...choice, metric });
      const last = levels[levels.length - 1];
      const evaluations = levels.reduce((sum, level) => sum + level.evaluations, 0);
      return { case: name, metric, evaluations, seconds, energy: last.energyReported, stop: last.stop };
    }),
  );
}

/** @param {MetricRow[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: 'What each metric gains: cage to the level, at most 1000 iterations per level, native',
      head: ['run', 'metric', 'evaluations', 'seconds', 'energy', 'last level'],
      rows: rows.map((row) => [
        ...[row.case, row.metric, row.evaluations, digits(row.seconds), row.energy.toPrecision(7), row.stop],
      ]),
    },
  ];
}

/** @param {MetricRow[]} rows @returns {import('./tables.js').Table[]} a row for each run */
export function summary(rows) {
  const found = (/** @type {string} */ name, /** @type {string} */ metric) =>
    /** @type {MetricRow} */ (rows.find((row) => row.case === name && row.metric === metric));
  const cell = (/** @type {MetricRow} */ { evaluations, seconds, energy, stop }) =>
    `${evaluations}, ${digits(seconds)} s, ${energy.toPrecision(6)}${stop === 'max_iterations' ? ' (not converged)' : ''}`;
  return [
    {
      title:
        'What each metric gains: evaluations over all levels, seconds, final energy; at most 1000 iterations per level:',
      head: ['run', ...metrics],
      rows: cases.map(({ name }) => [name, ...metrics.map((metric) => cell(found(name, metric)))]),
    },
  ];
}
