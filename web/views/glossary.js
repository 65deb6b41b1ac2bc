// SPDX-License-Identifier: MIT
/**
 * @file The glossary, in a dialog that G or a button opens, and the buttons on the page that open it at their term.
 */
import { glossary, termWords } from '../words/glossary.js';
import { createDialog, opensByKey } from './dialog.js';
import { element, find, takesText } from './dom.js';

/**
 * A word on the page that opens the glossary where it is explained.
 * @param {string} id of the term
 * @param {string} [words] by default its name
 */
export const termButton = (id, words = termWords(id).name) =>
  element('button', { type: 'button', class: 'term', 'data-term': id }, words);

/** Menus choose by letters. @param {EventTarget | null} target */
const takesLetters = (target) => takesText(target) || target instanceof HTMLSelectElement;

const createList = () =>
  element(
    'dl',
    {},
    ...glossary.map(({ id, name, words }) =>
      element('div', { id: `term-${id}`, tabindex: '-1' }, element('dt', {}, name), element('dd', {}, words)),
    ),
  );

/** @param {HTMLElement} header of the page */
export function createGlossaryView(header) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @type {HTMLDialogElement | null} */
  let dialog = null;

  /** @param {string | null} id of the term that it opens at */
  function open(id = null) {
    if (!dialog) document.body.append((dialog = createDialog('glossary', 'What the terms mean', createList())));
    if (!dialog.open) dialog.showModal();
    for (const meant of dialog.querySelectorAll('.meant')) meant.classList.remove('meant');
    if (!id) return;
    const term = find(dialog, `#term-${id}`);
    term.classList.add('meant');
    term.focus();
    term.scrollIntoView({ block: 'center' });
  }

  find(header, '#terms').addEventListener('click', () => open(), { signal });
  opensByKey('g', open, signal, takesLetters);
  document.addEventListener(
    'click',
    ({ target }) => {
      const term = target instanceof Element ? target.closest('[data-term]') : null;
      if (term) open(term.getAttribute('data-term'));
    },
    { signal },
  );
  return {
    dispose() {
      listening.abort();
      dialog?.remove();
    },
  };
}
