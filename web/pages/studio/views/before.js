// SPDX-License-Identifier: MIT
/**
 * @file The button, and the key B, that show the cage's own surface for as long as they are held down.
 */
import { find, setText } from '../../../views/dom.js';

/** @import {Action, State} from '../state/types.js' */

/** Where the key B means the letter. */
const TYPED = 'input:not([type=checkbox], [type=radio], [type=range]), select, textarea';

/** @param {KeyboardEvent} event */
const isKey = ({ key, target }) => key.toLowerCase() === 'b' && !(target instanceof Element && target.matches(TYPED));

/**
 * @param {HTMLElement} root contains the button and what screen readers are told
 * @param {(action: Action) => void} dispatch
 */
export function createBeforeView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const button = find(root, '#before');
  const told = find(root, '#before-told');
  let on = false;

  /** @param {boolean} next */
  function hold(next) {
    if (next !== on) dispatch({ type: 'viewChanged', change: { before: next } });
  }

  button.addEventListener(
    'pointerdown',
    (event) => {
      if (event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      hold(true);
    },
    { signal },
  );
  for (const type of ['pointerup', 'pointercancel', 'blur']) {
    button.addEventListener(type, () => hold(false), { signal });
  }
  button.addEventListener('contextmenu', (event) => event.preventDefault(), { signal }); // of a finger that stays
  for (const type of /** @type {const} */ (['keydown', 'keyup'])) {
    button.addEventListener(
      type,
      (event) => {
        if (event.key !== ' ' && event.key !== 'Enter') return;
        event.preventDefault();
        hold(type === 'keydown');
      },
      { signal },
    );
    document.addEventListener(
      type,
      (event) => {
        if (!isKey(event) || event.ctrlKey || event.metaKey || event.altKey) return;
        hold(type === 'keydown');
      },
      { signal },
    );
  }
  // A screen reader presses without holding.
  button.addEventListener('click', ({ detail }) => detail === 0 && hold(!on), { signal });
  window.addEventListener('blur', () => hold(false), { signal });

  return {
    /** @param {State} state */
    update({ view, session }) {
      const was = on;
      on = view.before;
      button.setAttribute('aria-pressed', String(on));
      const there = view.start?.run === session.run;
      if (on) setText(told, there ? 'This is the cage’s own surface.' : 'The cage’s own surface is being computed.');
      else if (was) setText(told, 'This is the surface as it is now.');
    },
    dispose: () => listening.abort(),
  };
}
