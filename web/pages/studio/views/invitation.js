// SPDX-License-Identifier: MIT
/**
 * @file The invitation to open a cage of one's own, for who comes from the home page for that: a dialog that a file closes.
 */
import { createDialog } from '../../../views/dialog.js';
import { element } from '../../../views/dom.js';

/** What follows the address of the studio where it is asked for. */
export const INVITED = '#open';

/** @param {() => void} choose lets the user choose a file */
export function createInvitation(choose) {
  const listening = new AbortController();
  const button = element('button', { type: 'button', class: 'primary' }, 'Choose file …');
  const dialog = createDialog(
    'invitation',
    'Open a cage of your own',
    element(
      'p',
      {},
      'Drop a mesh anywhere on this page, paste its text, or choose its file: OBJ or OFF, as modelling programs save it. A few dozen faces are enough, since the surface over them is smooth.',
    ),
    element('p', { class: 'note' }, 'It is computed in this page and does not leave this machine.'),
    element('div', { class: 'buttons' }, button),
  );
  const close = () => {
    listening.abort();
    dialog.close();
  };
  button.addEventListener('click', () => {
    close();
    choose();
  });
  for (const type of ['drop', 'paste']) document.addEventListener(type, close, { signal: listening.signal });
  dialog.addEventListener('close', () => {
    listening.abort();
    dialog.remove();
  });
  document.body.append(dialog);
  dialog.showModal();
  button.focus();
}
