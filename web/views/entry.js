// SPDX-License-Identifier: MIT
/**
 * @file What the catalog says of the minimizer that was opened, and the button that minimizes it again.
 */
import { settingsAreFree } from '../state/reduce.js';
import { energyWords, statusWords } from '../words/entries.js';
import { significant } from '../words/numbers.js';
import { element, find, onPress, setEnabled, whenChanged } from './dom.js';

/** @import {CatalogEntry} from '../files/catalog.js' */
/** @import {Action, State} from '../state/types.js' */

/** @param {CatalogEntry} entry @returns {string} */
function beside({ status, paper, exact }) {
  return [
    statusWords[status],
    ...(paper === null ? [] : [`paper ${significant(paper, Math.max(1, String(Math.round(paper)).length))}`]),
    ...(exact === null ? [] : [`exact ${significant(exact, 7)}`]),
  ].join(' · ');
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createEntryView(root, dispatch) {
  const listening = new AbortController();
  const button = /** @type {HTMLButtonElement} */ (find(root, 'button'));
  const words = find(root, 'p');
  onPress(button, () => dispatch({ type: 'againPressed' }), listening.signal);

  const show = whenChanged((/** @type {CatalogEntry | null} */ entry) => {
    root.hidden = !entry;
    if (!entry) return words.replaceChildren();
    words.title = entry.reason ?? '';
    words.replaceChildren(
      'Catalog: ',
      element('strong', {}, energyWords(entry)),
      ' ',
      element('span', { class: 'note' }, beside(entry)),
    );
  });

  return {
    /** @param {State} state */
    update(state) {
      show(state.minimizer?.entry ?? null);
      setEnabled(button, settingsAreFree(state) && !state.opening);
    },
    dispose: () => listening.abort(),
  };
}
