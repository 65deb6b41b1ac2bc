// SPDX-License-Identifier: MIT
/**
 * @file The alert below the surface.
 */
import { element, find, whenChanged } from '../../../views/dom.js';

/** @import {Action, State, View} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createAlertView(root, dispatch) {
  const listening = new AbortController();
  const box = find(root, 'div');
  find(root, '.dismiss').addEventListener('click', () => dispatch({ type: 'alertDismissed' }), {
    signal: listening.signal,
  });
  const show = whenChanged((/** @type {View['alert']} */ alert) => {
    root.hidden = !alert;
    if (!alert) return box.replaceChildren();
    const again = element('button', { type: 'button' }, 'Try again');
    again.addEventListener('click', () => dispatch({ type: 'retryPressed' }), { signal: listening.signal });
    box.replaceChildren(
      element('strong', {}, alert.title),
      element('p', {}, alert.message),
      ...(alert.retry ? [again] : []),
    );
  });
  return {
    /** @param {State} state */
    update: (state) => show(state.view.alert),
    dispose: () => listening.abort(),
  };
}
