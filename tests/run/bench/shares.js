// SPDX-License-Identifier: MIT
/**
 * @file What the CPU time of whole runs goes into, part by part, with the fraction of the multiply-add peak where operations
 * are counted.
 */
import { bench } from './programs.js';
import { digits, percent } from './tables.js';

/** @typedef {{ part: string, seconds: number, flops: number }} Part */
/** @typedef {{ cage: string, symmetric: boolean, functional: string, level: number, seconds: number, peak: number, parts: Part[] }} Row */

/** @returns {Row[]} */
export const measure = () => bench('native', 'shares');

/** @param {Row} row @returns {string[]} */
function cells({ seconds, peak, parts }) {
  const rest = seconds - parts.reduce((sum, part) => sum + part.seconds, 0);
  const cell = (/** @type {Part} */ part) =>
    `${percent(part.seconds / seconds)}${part.flops ? ` (${percent(part.flops / part.seconds / peak)})` : ''}`;
  return [...parts.map(cell), percent(rest / seconds)];
}

/** @param {Row[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title:
        'Where the CPU time of a run goes, one thread: how often a part is done times what it takes alone (in brackets the fraction of the multiply-add peak, where operations are counted); rest: the optimizer, searches for negative eigenvalues, and what differs from the part measured alone:',
      head: ['run', 'CPU s', ...rows[0].parts.map(({ part }) => part), 'rest'],
      rows: rows.map((row) => [
        `${row.cage}${row.symmetric ? '' : ', no symmetry'}, ${row.functional}, to level ${row.level}`,
        digits(row.seconds),
        ...cells(row),
      ]),
    },
  ];
}

export const summary = tables;
