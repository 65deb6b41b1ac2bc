// SPDX-License-Identifier: MIT
/**
 * @file The errors of quadrature rules, by which the rules in use were chosen.
 */
import { bench } from './programs.js';

/** @typedef {{ functional: string, cap: string, regular: number, capped: number, grading: number, samples: number, error: number }} RuleError */

/** @returns {RuleError[]} */
export const measure = () => bench('native', 'quadrature');

/** @param {RuleError[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: 'Relative errors of rules on genus-2 minimizers at level 2, which exploit the errors of the rule in use',
      head: ['functional', 'cap', 'regular', 'capped', 'grading', 'samples', 'error'],
      rows: rows.map((row) => [
        ...[row.functional, row.cap, `${row.regular} x ${row.regular}`, `${row.capped} x ${row.capped}`],
        ...[row.grading, row.samples, row.error.toExponential(1)],
      ]),
    },
  ];
}

export const summary = () => [];
