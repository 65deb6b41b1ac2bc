// SPDX-License-Identifier: MIT
/**
 * @file The buttons around the surfaces: to add one, and to fit all.
 */
import { MOST } from '../../../address/compare.js';
import { find, onPress, setEnabled } from '../../../views/dom.js';

/** @import {Action, State} from '../types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {boolean} draws whether surfaces can be drawn
 */
export function createToolsView(root, dispatch, draws) {
  const listening = new AbortController();
  const { signal } = listening;
  const add = /** @type {HTMLButtonElement} */ (find(root, '#add'));
  const fit = /** @type {HTMLButtonElement} */ (find(root, '#fit'));
  onPress(add, () => dispatch({ type: 'entryAdded' }), signal);
  onPress(fit, () => dispatch({ type: 'fitPressed' }), signal);
  find(root, '.no-webgl').hidden = draws;
  for (const id of ['legend', 'common']) find(root, `#${id}`).hidden = !draws;
  fit.hidden = !draws;

  return {
    /** @param {State} state */
    update: (state) => setEnabled(add, state.entries.length < MOST),
    dispose: () => listening.abort(),
  };
}
