// SPDX-License-Identifier: MIT
/**
 * @file The list of all keys, in a dialog that `?` or a button opens, and the link past the header.
 */
import { createDialog, opensByKey } from './dialog.js';
import { element, find, takesText } from './dom.js';

/** @import {KeyGroup, KeyWords} from '../words/keys.js' */

/** Macs have another key for commands. @param {string} key */
const named = (key) => (/Mac|iPhone|iPad/.test(navigator.platform) ? key.replace('Ctrl', '⌘') : key);

/** @param {string} together keys, joined by + @returns {(string | Node)[]} */
function keyNodes(together) {
  const keys = together === '+' ? ['+'] : together.split('+');
  return keys.flatMap((key, i) => [...(i ? ['+'] : []), element('kbd', {}, named(key))]);
}

/** @param {KeyWords} key */
function row({ keys, words }) {
  const names = keys.flatMap((together, i) => [...(i ? [' '] : []), element('span', {}, ...keyNodes(together))]);
  return element('div', {}, element('dt', {}, ...names), element('dd', {}, words));
}

/** @param {KeyGroup[]} groups */
const createSections = (groups) =>
  groups.map(({ title, keys }) =>
    element('section', {}, element('h3', {}, title), element('dl', {}, ...keys.map(row))),
  );

/** @param {HTMLElement} header of the page @param {KeyGroup[]} groups */
export function createKeyListView(header, groups) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @type {HTMLDialogElement | null} */
  let dialog = null;

  function open() {
    if (!dialog) document.body.append((dialog = createDialog('key-list', 'Keys', ...createSections(groups))));
    if (!dialog.open) dialog.showModal();
  }

  find(header, '#keys').addEventListener('click', open, { signal });
  opensByKey('?', open, signal, takesText);
  // The address, which may be copied, stays as it is.
  find(header, '.skip').addEventListener(
    'click',
    (event) => {
      event.preventDefault();
      const main = find(document, 'main');
      main.tabIndex = -1;
      main.focus();
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
