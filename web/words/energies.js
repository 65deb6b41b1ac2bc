// SPDX-License-Identifier: MIT
/**
 * @file What energies prove of their surface, or why they cannot be its own, in words.
 */
import { functionals } from './functionals.js';
import { compact } from './numbers.js';

/** @import {Energies} from '../../wasm/types.js' */

/** What `embedded` in the energies of a surface says, and why. */
export const embeddedWords = {
  name: 'embedded, as below 8π',
  reason: 'With a Willmore energy below 8π no surface touches or crosses itself (Li & Yau 1982).',
};

/** Relative changes up to this are below the digits that are shown. */
const HARMLESS = 1e-12;

/**
 * Warnings about energies that no closed surface can have.
 * @param {Pick<Energies, 'resolved' | 'below_bound'>} energies
 * @returns {string[]}
 */
export function energyWarnings({ resolved, below_bound }) {
  const warnings = [];
  if (below_bound) {
    warnings.push('No closed surface of this genus has so little energy: these numbers are not the surface’s.');
  }
  if (!resolved) {
    warnings.push('∫ K dA is not 2πχ: curvature hides in folds or necks, and these numbers are not the surface’s.');
  }
  return warnings;
}

/**
 * How many digits the rounding of the cage's coordinates leaves.
 * @param {Energies['input_rounding']} changes relative
 * @returns {string} empty if it leaves more than are shown
 */
export function roundingWords(changes) {
  if (!changes) return '';
  /** @param {boolean} third the largest change of functionals of third order, or of the others */
  const largest = (third) =>
    functionals
      .filter(({ areaPower }) => areaPower > 0 === third)
      .reduce((most, { id }) => (changes[id] > most ? changes[id] : most), 0);
  const [second, third] = [largest(false), largest(true)];
  if (Math.max(second, third) <= HARMLESS) return '';
  const ofThird = third > 0 ? `, third-order ones by up to ${compact(third, 2)}` : '';
  return `So far from the origin, rounding of the coordinates changes energies by up to ${compact(second, 2)} of their value${ofThird}.`;
}
