// SPDX-License-Identifier: MIT
/**
 * @file How the symbol of a symmetry group is shown: its letter, and the rest as a subscript.
 */
import { schoenflies } from '../words/results.js';
import { element } from './dom.js';

/** @param {string} name a Schoenflies symbol, or nothing @returns {Array<Node | string>} */
export function groupSymbol(name) {
  if (!name) return [];
  const { letter, index } = schoenflies(name);
  return [element('span', { class: 'group' }, letter, element('sub', {}, index))];
}
