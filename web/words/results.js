// SPDX-License-Identifier: MIT
/**
 * @file A cage's repairs, and a run's levels, limit, symmetry and certificate in words.
 */
import { counted, lowerBound, withError } from './numbers.js';

/** @import {CageReport, CertificateReport, Group, LevelReport, Limit, StopReason} from '../../wasm/types.js' */

/** Number of digits of an extrapolated energy's error. */
const ERROR_DIGITS = 2;
/** Number of digits of a bound that cuts an error bar. */
const BOUND_DIGITS = 7;

/** @type {Record<LevelReport['metric'], string>} */
export const metricWords = { identity: 'Euclidean', sobolev: 'Sobolev', hessian: 'Hessian', newton: 'Newton' };

/**
 * How the error of the energy was told from the levels, or why it was not: a detail beside the verdict.
 * @param {Limit} limit
 * @returns {{value: string, error: string, words: string}} `value` and `error` are empty if there is none, and `words` say why
 */
export function limitWords({ status, energy, order, error, lower, caps_included: capsIncluded }) {
  /** @param {string} words */
  const none = (words) => ({ value: '', error: '', words });
  const observed = Number.isFinite(order) ? `observed order ${order.toFixed(1)}` : 'the last levels agree';
  switch (status) {
    case 'converging': {
      const cut = lower > energy - error ? `, but not below ${lowerBound(lower, BOUND_DIGITS)}, as no surface is` : '';
      const caps = capsIncluded === false ? ', without the caps’ own error' : '';
      return { ...withError(energy, error, ERROR_DIGITS), words: observed + caps + cut };
    }
    case 'too_few_levels':
      return none('it takes three levels');
    case 'not_minimized':
      return none('one of the last three levels ended early');
    case 'not_resolved':
      return none('the last level’s energy is not the surface’s');
    case 'not_comparable':
      return none('each level is pulled with its own weight');
    case 'not_converging':
      return none(
        `the energies or the surfaces of the last three levels do not settle${Number.isFinite(order) ? ` (${observed})` : ''}`,
      );
  }
}

/** What a run took. @param {LevelReport[]} levels @param {number} evaluations */
export const effortWords = (levels, evaluations) =>
  counted(evaluations, 'evaluation') + (levels.length > 1 ? ` on ${levels.length} levels` : '');

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
 * Whether the surface at the end of a run is a minimum: the words before and after the symbol of its symmetry.
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
        ? 'Yes: on this mesh no surface near it has less energy.'
        : 'Not known: the run ended too early to tell.',
    );
  }
  const directions = counted(negative, 'direction lowers', 'directions lower');
  if (!converged) return plain(`Not yet: ${directions} the energy.`);
  if (!group || group.order === 1) return plain(`No: ${directions} the energy. It is a saddle.`);
  const breaks = negative === 1 ? 'breaks' : 'break';
  return { before: `No: ${directions} the energy, and ${breaks} its symmetry (`, symbol: group.name, after: ').' };
}

/** The size of the Hessian and the tolerance behind a certificate. @param {CertificateReport} report */
export function certificateDetails({ unknowns, tau }) {
  return `${counted(unknowns, 'unknown')}, τ\u00a0=\u00a0${tau}`;
}
