// SPDX-License-Identifier: MIT
/**
 * @file The shares of a blend in words.
 */
import { functionalWords } from './functionals.js';
import { compact } from './numbers.js';

/** @import {FunctionalName} from '../../wasm/types.js' */

/** A share in percent, to a tenth: 33.3 %. @param {number} share from 0 to 1 */
export const shareWords = (share) => `${compact(Math.round(1000 * share) / 10)}\u202f%`;

/** What weighs in a blend and is at no corner of its triangle. @param {FunctionalName[]} names @returns {string} empty if nothing does */
export function outsideWords(names) {
  if (!names.length) return '';
  const words = names.map((name) => functionalWords(name).short);
  const [weighs, it] = names.length === 1 ? ['weighs', 'it'] : ['weigh', 'them'];
  const last = words.pop();
  const list = words.length ? `${words.join(', ')} and ${last}` : last;
  return `${list} also ${weighs}, at no corner: moving the point leaves ${it} out.`;
}
