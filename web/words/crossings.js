// SPDX-License-Identifier: MIT
/**
 * @file What is said of a surface that crosses itself, or does not.
 */
import { embeddedWords } from './energies.js';
import { counted, integer } from './numbers.js';

/** @import {CrossingsKnown} from '../pages/studio/state/crossing.js' */

/** @param {CrossingsKnown} known @returns {string} a sentence; empty if nothing is asked */
export function crossingsWords(known) {
  switch (known) {
    case 'unasked':
      return '';
    case 'moving':
      return 'Whether the surface crosses itself is found when it rests.';
    case 'embedded':
      return `The surface does not cross itself: ${embeddedWords.name}.`;
    case 'searching':
      return 'Looking for places where the surface crosses itself …';
  }
  if (known.places > 0) return `The surface crosses itself in ${counted(known.places, 'place')}.`;
  return `The surface does not cross itself, as far as ${integer(known.triangles)} triangles show.`;
}
