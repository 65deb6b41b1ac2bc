// SPDX-License-Identifier: MIT
/**
 * @file The line beside the legend that says whether the surface crosses itself, while that is shown.
 */
import { find, setText } from '../../../views/dom.js';
import { crossingsWords } from '../../../words/crossings.js';
import { crossingsKnown } from '../state/crossing.js';

/** @import {State} from '../state/types.js' */

/** @param {HTMLElement} root */
export function createCrossingsView(root) {
  const swatch = find(root, '.swatch');
  const words = find(root, '.words');
  return {
    /** @param {State} state */
    update(state) {
      const known = crossingsKnown(state);
      root.hidden = !state.view.crossings || known === 'unasked';
      swatch.hidden = typeof known === 'string' || known.places === 0;
      setText(words, root.hidden ? '' : crossingsWords(known));
    },
    dispose() {},
  };
}
