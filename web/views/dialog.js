// SPDX-License-Identifier: MIT
/**
 * @file Dialogs that are only read: with a title and a button that closes them, as Esc and a press beside them do.
 */
import { element } from './dom.js';

/**
 * @param {string} id
 * @param {string} title
 * @param {...Node} content
 * @returns {HTMLDialogElement} not yet in the document
 */
export function createDialog(id, title, ...content) {
  const close = element('button', { type: 'button', class: 'quiet close', 'aria-label': 'Close', autofocus: '' }, '✕');
  const heading = element('h2', { id: `${id}-title` }, title);
  const dialog = element(
    'dialog',
    { id, class: 'read', 'aria-labelledby': `${id}-title` },
    element('div', { class: 'content' }, heading, ...content),
    close,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', ({ target }) => target === dialog && dialog.close());
  return dialog;
}

/**
 * Calls `open` when a key is pressed alone, and not into a field.
 * @param {string} key as events name it
 * @param {() => void} open
 * @param {AbortSignal} signal
 * @param {(target: EventTarget | null) => boolean} takes whether an element keeps the key for itself
 */
export function opensByKey(key, open, signal, takes) {
  document.addEventListener(
    'keydown',
    (event) => {
      const { ctrlKey, metaKey, altKey, target } = event;
      if (event.key.toLowerCase() !== key || ctrlKey || metaKey || altKey || takes(target)) return;
      event.preventDefault();
      open();
    },
    { signal },
  );
}
