// SPDX-License-Identifier: MIT
/**
 * @file The bar with the entries chosen for comparison; hidden while there are none.
 */
import { FEWEST, MOST } from '../../../address/compare.js';
import { compareLink } from '../../../address/links.js';
import { element, find, setText } from '../../../views/dom.js';
import { findEntry } from '../select.js';
import { columnWords, shapeTitle } from '../../../words/entries.js';
import { picture } from './cell.js';

/** @import {Action, EntryId, State} from '../types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createChoiceView(root, dispatch) {
  const listening = new AbortController();
  const list = find(root, 'ul');
  const words = find(root, 'p');
  const compare = /** @type {HTMLAnchorElement} */ (find(root, 'a'));
  find(root, 'button').addEventListener('click', () => dispatch({ type: 'choiceCleared' }), {
    signal: listening.signal,
  });

  /** @param {State} state @param {EntryId} id */
  function item(state, id) {
    const found = findEntry(state.catalog, id);
    if (!found) return [];
    const name = `${shapeTitle(found.shape.name)}, ${columnWords(found.functional).name}`;
    const remove = element(
      'button',
      { type: 'button', class: 'quiet', title: `${name}: remove`, 'aria-label': `Remove ${name}` },
      picture(found.entry, ''),
    );
    remove.addEventListener('click', () => dispatch({ type: 'entryChosen', entry: id, chosen: false }));
    return [element('li', {}, remove)];
  }

  /** @type {EntryId[]} */
  let last = [];
  return {
    /** @param {State} state */
    update(state) {
      const { chosen } = state;
      root.hidden = !chosen.length;
      if (chosen === last) return;
      last = chosen;
      list.replaceChildren(...chosen.flatMap((id) => item(state, id)));
      const enough = chosen.length >= FEWEST;
      if (!enough) setText(words, `Choose one more, up to ${MOST}, to see them side by side.`);
      else
        setText(
          words,
          chosen.length === MOST ? `${MOST} entries, which is as many as fit.` : `${chosen.length} entries.`,
        );
      compare.hidden = !enough;
      compare.href = compareLink(chosen.flatMap((id) => findEntry(state.catalog, id)?.entry ?? []));
    },
    dispose: () => listening.abort(),
  };
}
