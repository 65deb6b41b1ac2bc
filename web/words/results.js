// SPDX-License-Identifier: MIT
/**
 * @file A cage's repairs, and a run's levels, limit, symmetry and certificate in words.
 */
import { counted, lowerBound, percent, significant, withError } from './numbers.js';

/** @import {CageReport, CertificateReport, Group, LevelReport, Limit, StopReason} from '../../wasm/types.js' */

/** An error bar needs this many levels. */
const ENOUGH_LEVELS = 3;
/** Number of digits of an extrapolated energy's error. */
const ERROR_DIGITS = 2;
/** Number of digits of a bound that cuts an error bar. */
const BOUND_DIGITS = 7;

/** @type {Record<LevelReport['metric'], string>} */
export const metricWords = { identity: 'Euclidean', sobolev: 'Sobolev', hessian: 'Hessian', newton: 'Newton' };

/**
 * The extrapolated energy with its error, or the reason why there is none.
 * @param {Limit} limit
 * @param {LevelReport[]} levels
 * @param {number | null} [accuracy] that was asked for, as a part of the limit
 * @returns {{value: string, error: string, words: string}} `value` and `error` are empty if there is no limit
 */
export function limitWords({ status, energy, order, error, lower }, levels, accuracy = null) {
  switch (status) {
    case 'converging': {
      const words = Number.isFinite(order) ? `observed order ${order.toFixed(1)}` : 'the last levels agree';
      const cut = lower > energy - error ? `, but not below ${lowerBound(lower, BOUND_DIGITS)}, as no surface is` : '';
      return {
        ...withError(energy, error, ERROR_DIGITS),
        words: words + cut + accuracyWords(error / Math.abs(energy), accuracy),
      };
    }
    case 'too_few_levels': {
      const missing = ENOUGH_LEVELS - levels.filter(({ evaluable }) => evaluable).length;
      const words = missing > 1 ? `${missing} more levels give an error bar` : 'one more level gives an error bar';
      return { value: '', error: '', words };
    }
    case 'not_minimized':
      return { value: '', error: '', words: 'no error bar: a level ended before its minimum' };
    case 'not_resolved':
      return { value: '', error: '', words: 'no error bar: the last level’s energy is not the surface’s' };
    case 'not_comparable':
      return { value: '', error: '', words: 'no error bar: each level is pulled with its own weight' };
    case 'not_converging':
      return { value: significant(energy), error: '', words: 'upper bound, not converging' };
  }
}

/** @param {number} reached @param {number | null} asked */
function accuracyWords(reached, asked) {
  if (asked === null) return '';
  return reached <= asked ? `, within ${percent(reached)}` : `, within ${percent(reached)}, not ${percent(asked)}`;
}

/**
 * Splits a Schoenflies symbol into its letter and its subscript: D3h is D and 3h.
 * @param {string} name
 * @returns {{letter: string, index: string}}
 */
export function schoenflies(name) {
  return { letter: name.slice(0, 1), index: name.slice(1) };
}

/**
 * The symmetry that a run keeps: the group's symbol, if it has one, and the words after it.
 * @param {Group | null} group
 * @param {boolean} wanted whether symmetry is to be kept
 * @returns {{symbol: string, words: string}}
 */
export function groupWords(group, wanted) {
  if (!group || !wanted) return { symbol: '', words: '' };
  const { name, order, incomplete } = group;
  if (order === 1) return { symbol: '', words: incomplete ? `none known: ${incomplete}` : 'the cage has none' };
  return { symbol: name, words: `, order ${order}${incomplete ? ` or more: ${incomplete}` : ''}` };
}

/**
 * What was changed of a cage when it was read, and what else there is to say of its file, a sentence each.
 * @param {CageReport} report
 * @returns {string[]}
 */
export const repairWords = ({ repairs, notes }) => [
  ...repairs.map((repair) => `Repaired: ${repair}.`),
  ...notes.map((note) => `Note: ${note}.`),
];

/** The levels whose start was made thicker. @param {LevelReport[]} levels @returns {string[]} */
export const thickenedWords = (levels) =>
  levels
    .filter(({ thickened }) => thickened)
    .map(({ level }) => `Level ${level} began thicker than it was: its samples missed curvature of its rims.`);

/**
 * What a certificate says about the surface at the end of a run: the words before and after the symbol of its symmetry.
 * @param {CertificateReport} report
 * @param {Group | null} group
 * @param {StopReason | 'interrupted' | null} stop
 * @returns {{before: string, symbol: string, after: string}}
 */
export function certificateWords({ negative }, group, stop) {
  /** @param {string} before */
  const plain = (before) => ({ before, symbol: '', after: '' });
  const converged = stop === 'converged' || stop === 'round_off';
  if (negative === 0) {
    return plain(
      converged
        ? 'A local minimum among all surfaces near it.'
        : 'No direction lowers the energy to second order, but the run ended before it converged.',
    );
  }
  const directions = `${counted(negative, 'direction lowers', 'directions lower')} the energy`;
  if (!converged) return plain(`${directions} to second order.`);
  if (!group || group.order === 1) return plain(`${directions}: a saddle point, not a minimum.`);
  return { before: `${directions}: a minimum only within its symmetry (`, symbol: group.name, after: ').' };
}

/** The size of the Hessian and the tolerance behind a certificate. @param {CertificateReport} report */
export function certificateDetails({ unknowns, tau }) {
  return `${counted(unknowns, 'unknown')}, τ\u00a0=\u00a0${tau}`;
}
