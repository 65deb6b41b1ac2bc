// SPDX-License-Identifier: MIT
/**
 * @file The alert below the surface, and the downloads.
 */
import { element, find, onPress, setEnabled, whenChanged } from '../../../views/dom.js';
import { certifyingOf } from '../state/parts.js';

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
      const { session, view } = state;
      const { saved, latest } = state.document.result;
      const [control, limit, report, problem] = buttons;
      const { exporting, opening, phase } = session;
      const busy = exporting || opening || certifyingOf(phase) || phase.name === 'unavailable';
      setEnabled(limit, view.surface !== null && !busy);
      setEnabled(control, saved !== null && !busy);
      setEnabled(report, latest !== null && !busy);
      setEnabled(problem, view.surface !== null && !busy);
    },
    dispose: () => listening.abort(),
  };
}
