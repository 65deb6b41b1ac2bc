// SPDX-License-Identifier: MIT
/**
 * @file The alert below the surface.
 */
import { element, find, whenChanged } from '../../../views/dom.js';

/** @import {Action, State, View} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {() => void} save the document as a file
 */
export function createAlertView(root, dispatch, save) {
  const listening = new AbortController();
  const box = find(root, 'div');
  find(root, '.dismiss').addEventListener('click', () => dispatch({ type: 'alertDismissed' }), {
    signal: listening.signal,
  });
  const show = whenChanged((/** @type {View['alert']} */ alert) => {
    root.hidden = !alert;
    if (!alert) return box.replaceChildren();
    const button = (/** @type {string} */ words, /** @type {() => void} */ press) => {
      const made = element('button', { type: 'button' }, words);
      made.addEventListener('click', press, { signal: listening.signal });
      return made;
    };
    box.replaceChildren(
      element('strong', {}, alert.title),
      element('p', {}, alert.message),
      ...(alert.retry ? [button('Try again', () => dispatch({ type: 'retryPressed' }))] : []),
      ...(alert.save ? [button('Save project', save)] : []),
    );
  });
  return {
    /** @param {State} state */
    update: (state) => show(state.view.alert),
    dispose: () => listening.abort(),
  };
}
