// SPDX-License-Identifier: MIT
/**
 * @file The menu of what is shown over the surface.
 */
import { quantityOf } from '../../../colour/quantities.js';
import { find } from '../../../views/dom.js';

/** @import {Action, State} from '../state/types.js' */

/** The switches by their names on the page, and the fields of the view. */
const SWITCHES = /** @type {const} */ ({
  'show-isolines': 'isolines',
  'show-patches': 'patches',
  'show-cage': 'cage',
  'show-original': 'original',
  'show-crossings': 'crossings',
});

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createShowView(root, dispatch) {
  const listening = new AbortController();
  const boxes = Object.entries(SWITCHES).map(([name, field]) => {
    const box = /** @type {HTMLInputElement} */ (find(root, `[name=${name}]`));
    box.addEventListener('change', () => dispatch({ type: 'viewChanged', change: { [field]: box.checked } }), {
      signal: listening.signal,
    });
    return { box, field };
  });
  const isolines = /** @type {HTMLInputElement} */ (find(root, '[name=show-isolines]'));
  return {
    /** @param {State} state */
    update({ view }) {
      for (const { box, field } of boxes) box.checked = view[field];
      isolines.disabled = !quantityOf(view.shading); // there is nothing of which they could be lines
    },
    dispose: () => listening.abort(),
  };
}
