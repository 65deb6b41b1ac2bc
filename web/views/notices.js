// SPDX-License-Identifier: MIT
/**
 * @file The alert below the surface, and the downloads.
 */
import { element, find, onPress, setEnabled, whenChanged } from './dom.js';

/** @import {Action, State} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createAlertView(root, dispatch) {
  const listening = new AbortController();
  const box = find(root, 'div');
  find(root, 'button').addEventListener('click', () => dispatch({ type: 'alertDismissed' }), {
    signal: listening.signal,
  });
  const show = whenChanged((/** @type {State['alert']} */ alert) => {
    root.hidden = !alert;
    box.replaceChildren(...(alert ? [element('strong', {}, alert.title), element('p', {}, alert.message)] : []));
  });
  return {
    /** @param {State} state */
    update: (state) => show(state.alert),
    dispose: () => listening.abort(),
  };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createDownloadsView(root, dispatch) {
  const listening = new AbortController();
  const names = /** @type {const} */ (['control', 'limit', 'report', 'problem']);
  const buttons = names.map((name) => {
    const button = /** @type {HTMLButtonElement} */ (find(root, `[name=${name}]`));
    onPress(button, () => dispatch({ type: 'downloadPressed', what: name }), listening.signal);
    return button;
  });
  return {
    /** @param {State} state */
    update(state) {
      const [control, limit, report, problem] = buttons;
      const busy = state.exporting || state.opening || state.certifying || state.status === 'unavailable';
      setEnabled(limit, state.surface !== null && !busy);
      setEnabled(control, state.saved !== null && !busy);
      setEnabled(report, state.latest !== null && !busy);
      setEnabled(problem, state.surface !== null && !busy);
    },
    dispose: () => listening.abort(),
  };
}
