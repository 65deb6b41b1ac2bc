// SPDX-License-Identifier: MIT
/**
 * @file What the catalog says about the minimizer that was opened, and the button that minimizes it again.
 */
import { compareLink } from '../../../address/links.js';
import { settingsAreFree } from '../state/reduce.js';
import { besideWords, energyWords, opinionWords, statusWords, typeset } from '../../../words/entries.js';
import { element, find, onPress, setEnabled, whenChanged } from '../../../views/dom.js';

/** @import {EntryName} from '../../../address/compare.js' */
/** @import {CatalogEntry} from '../../../files/catalog.js' */
/** @import {Action, State} from '../state/types.js' */

/**
 * What an entry is compared with first: its shape under another functional; a hole, which has one only, with another hole.
 * @param {EntryName} entry
 * @returns {EntryName}
 */
export function besideIt({ shape, functional }) {
  const sides = Number(/^hole-(\d+)$/.exec(shape)?.[1]);
  if (sides) return { shape: `hole-${sides === 4 ? 5 : 4}`, functional };
  return { shape, functional: functional === 'bending' ? 'mvs_cross' : 'bending' };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createEntryView(root, dispatch) {
  const listening = new AbortController();
  const button = /** @type {HTMLButtonElement} */ (find(root, 'button'));
  const words = find(root, 'p');
  const opinion = find(root, 'p.note');
  const compare = /** @type {HTMLAnchorElement} */ (find(root, 'a'));
  onPress(button, () => dispatch({ type: 'againPressed' }), listening.signal);

  const show = whenChanged((/** @type {CatalogEntry | null} */ entry) => {
    root.hidden = !entry;
    opinion.textContent = entry ? opinionWords(entry) : '';
    opinion.hidden = !opinion.textContent;
    if (!entry) return words.replaceChildren();
    words.title = typeset(entry.reason ?? '');
    const { value, error } = energyWords(entry);
    compare.href = compareLink([entry, besideIt(entry)]);
    words.replaceChildren(
      'Catalog: ',
      element('strong', {}, error ? `${value} ± ${error}` : value),
      ' ',
      element('span', { class: 'note' }, [statusWords[entry.status].name, ...besideWords(entry)].join(' · ')),
    );
  });

  return {
    /** @param {State} state */
    update(state) {
      show(state.document.minimizer?.entry ?? null);
      setEnabled(button, settingsAreFree(state) && !state.session.opening);
    },
    dispose: () => listening.abort(),
  };
}
