// SPDX-License-Identifier: MIT
/**
 * @file Undo, redo and saving the document, by button and by key.
 */
import { find, onPress, setEnabled, setText, takesText } from '../../../views/dom.js';
import { redoName, undoName } from '../state/history.js';

/** @import {Action, State} from '../state/types.js' */

/** @param {KeyboardEvent} event @returns {'undo' | 'redo' | 'save' | null} */
function keyOf({ key, ctrlKey, metaKey, shiftKey, altKey, target }) {
  if (!(ctrlKey || metaKey) || altKey) return null;
  if (key.toLowerCase() === 's' && !shiftKey) return 'save';
  // There the browser itself takes back what is typed.
  if (takesText(target)) return null;
  if (key.toLowerCase() === 'z') return shiftKey ? 'redo' : 'undo';
  return key.toLowerCase() === 'y' && !shiftKey ? 'redo' : null;
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {() => void} save the document as a file
 */
export function createEditView(root, dispatch, save) {
  const listening = new AbortController();
  const { signal } = listening;
  const said = find(root, '[role=status]');
  const commands = {
    undo: {
      button: /** @type {HTMLButtonElement} */ (find(root, '#undo')),
      word: 'Undo',
      done: 'Undone',
      keys: 'Ctrl+Z',
    },
    redo: {
      button: /** @type {HTMLButtonElement} */ (find(root, '#redo')),
      word: 'Redo',
      done: 'Done again',
      keys: 'Shift+Ctrl+Z',
    },
  };
  /** @type {Record<'undo' | 'redo', string | null>} */
  let names = { undo: null, redo: null };

  /** @param {'undo' | 'redo'} what */
  function run(what) {
    const name = names[what];
    if (name === null) return;
    dispatch({ type: what === 'undo' ? 'undoPressed' : 'redoPressed' });
    setText(said, `${commands[what].done}: ${name}.`);
  }

  for (const what of /** @type {const} */ (['undo', 'redo'])) onPress(commands[what].button, () => run(what), signal);
  find(root, '#save').addEventListener('click', save, { signal });
  document.addEventListener(
    'keydown',
    (event) => {
      const what = keyOf(event);
      if (!what) return;
      event.preventDefault();
      if (what === 'save') save();
      else run(what);
    },
    { signal },
  );

  return {
    /** @param {State} state */
    update(state) {
      names = { undo: undoName(state), redo: redoName(state) };
      for (const what of /** @type {const} */ (['undo', 'redo'])) {
        const { button, word, keys } = commands[what];
        const name = names[what];
        setEnabled(button, name !== null);
        const label = name ? `${word} ${name}` : word;
        if (button.title !== `${label} (${keys})`) {
          button.title = `${label} (${keys})`;
          button.setAttribute('aria-label', label);
        }
      }
    },
    dispose: () => listening.abort(),
  };
}
