// SPDX-License-Identifier: MIT
/**
 * @file How third-order energies depend on the width of smooth caps.
 */
import { bench } from './programs.js';
import { digits } from './tables.js';

/** @typedef {{ level: number, rings: number, energy: number, evaluations: number, seconds: number, stop: string }} CapsLevel */
/** @typedef {{ shape: string, truth: number | null, rings: number, levels: CapsLevel[], limit: number | null, error: number | null, capsIncluded: boolean }} CapsRow */

/** @returns {CapsRow[]} */
export const measure = () => bench('native', 'caps');

/** @param {CapsRow} row */
function limit({ limit, error, capsIncluded }) {
  if (limit === null || error === null) return 'none';
  return `${Number(limit.toPrecision(6))} ± ${digits(error)}${capsIncluded ? '' : ' (without the caps’)'}`;
}

/** @param {CapsRow[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return rows.map((row) => ({
    title:
      `${row.shape}, ${row.levels.at(-1)?.rings ? `caps of at most ${row.rings} rings` : 'no caps'}: limit ${limit(row)}` +
      (row.truth === null ? '' : `, exact ${row.truth}`),
    head: ['level', 'narrowest cap', 'energy', 'evaluations', 'seconds', 'stop'],
    rows: row.levels.map(({ level, rings, energy, evaluations, seconds, stop }) => [
      ...[level, rings, energy, evaluations, digits(seconds), stop],
    ]),
  }));
}

/** @param {CapsRow[]} rows @returns {import('./tables.js').Table[]} */
export function summary(rows) {
  /** @param {CapsRow} row @param {number} level */
  const energy = ({ levels }, level) => {
    const at = levels.find((one) => one.level === level);
    return at ? Number(at.energy.toPrecision(7)) : '';
  };
  const levels = [2, 3, 4, 5];
  return [
    {
      title:
        'Energies by level and by the most rings that smooth caps may take (`mvs_cross`; of the torus, `bending + mvs_cross`, exactly ' +
        `${rows.find(({ shape }) => shape === 'torus')?.truth ?? ''}; of the sphere, from the cube, exactly 0):`,
      head: ['shape', 'rings', ...levels.map((level) => `level ${level}`), 'limit', 'evaluations'],
      rows: rows.map((row) => [
        ...[
          row.shape,
          row.shape === 'torus' ? '' : row.rings,
          ...levels.map((level) => energy(row, level)),
          limit(row),
        ],
        row.levels.map(({ evaluations }) => evaluations).join(', '),
      ]),
    },
  ];
}
