// SPDX-License-Identifier: MIT
/**
 * @file The optimizer's sparse factorization beside Eigen's SimplicialLDLT and CHOLMOD's supernodal one with OpenBLAS, one
 * thread each, on matrices of the optimizer's own metrics.
 */
import { bench, benchFactorization } from './programs.js';
import { digits, percent } from './tables.js';

/** @typedef {{ analysis: number, factorization: number, solution: number, entries: number, difference: number }} Measured seconds, entries of L, and by how much A^-1 (1, 1, …) differs from umbilic's */
/** @typedef {{ cage: string, symmetric: boolean, level: number, functional: string, unknowns: number, nonzeros: number, flops: number, umbilic: Measured, eigen: Measured, cholmod: Measured }} Row */
/** @typedef {{ peak: number, rows: Row[] }} Factorizations */

/** By how much the solutions of these matrices may differ: their condition times the rounding. */
const MOST_DIFFERENCE = 1e-4;

/** @returns {Factorizations} */
export function measure() {
  /** @type {Row[]} */
  const rows = benchFactorization();
  for (const { cage, level, eigen, cholmod } of rows) {
    const difference = Math.max(eigen.difference, cholmod.difference);
    if (!(difference < MOST_DIFFERENCE)) throw new Error(`${cage}, level ${level}: solutions differ by ${difference}`);
  }
  const peaks = bench('native', 'peaks');
  return { peak: peaks[peaks.length - 1].flopsPerSecond, rows };
}

const milliseconds = (/** @type {number} */ seconds) => digits(1e3 * seconds);

/** @param {Factorizations} measured @returns {import('./tables.js').Table[]} */
export function tables({ peak, rows }) {
  return [
    {
      title:
        "Factorization of the Hessian metric's matrix, one thread: ms (fraction of the multiply-add peak), and for each of these the ms of Eigen's SimplicialLDLT and of CHOLMOD's supernodal one with OpenBLAS; then the same with analysis and one solution:",
      head: ['matrix', 'unknowns', 'entries of L', 'umbilic', 'Eigen', 'CHOLMOD', 'umbilic, all', 'Eigen', 'CHOLMOD'],
      rows: rows.map(({ cage, symmetric, level, functional, unknowns, flops, umbilic, eigen, cholmod }) => {
        const all = (/** @type {Measured} */ { analysis, factorization, solution }) =>
          analysis + factorization + solution;
        const ratio = (/** @type {number} */ other, /** @type {number} */ own) => (other / own).toFixed(2);
        return [
          `${cage}${symmetric ? '' : ', no symmetry'}, level ${level}, ${functional}`,
          ...[unknowns, umbilic.entries],
          `${milliseconds(umbilic.factorization)} (${percent(flops / umbilic.factorization / peak)})`,
          ratio(eigen.factorization, umbilic.factorization),
          ratio(cholmod.factorization, umbilic.factorization),
          milliseconds(all(umbilic)),
          ratio(all(eigen), all(umbilic)),
          ratio(all(cholmod), all(umbilic)),
        ];
      }),
    },
  ];
}

export const summary = tables;
