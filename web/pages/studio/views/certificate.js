// SPDX-License-Identifier: MIT
/**
 * @file Whether the surface is a minimum: the button that begins or cancels the check, its progress, and its answer.
 */
import { certifyingOf } from '../state/parts.js';
import { certificateButton } from '../state/select.js';
import { certificateDetails, certificateWords } from '../../../words/results.js';
import { groupSymbol } from '../../../views/group.js';
import { find, onPress, setEnabled, setText, whenChanged } from '../../../views/dom.js';

/** @import {CertificateReport} from '../../../../wasm/types.js' */
/** @import {Button} from '../state/select.js' */
/** @import {Action, Result, State} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createCertificateView(root, dispatch) {
  const listening = new AbortController();
  const button = /** @type {HTMLButtonElement} */ (find(root, 'button'));
  const progress = /** @type {HTMLProgressElement} */ (find(root, 'progress'));
  const question = find(root, '.note');
  const answer = find(root, '[role=status]');
  const details = find(root, 'details');
  const numbers = find(details, '.numbers');
  /** @type {Button['action']} */
  let action = 'certifyPressed';
  onPress(button, () => dispatch(/** @type {Action} */ ({ type: action })), listening.signal);

  const showAnswer = whenChanged(
    (
      /** @type {CertificateReport | null} */ report,
      /** @type {Result['group']} */ group,
      /** @type {Result['stop']} */ stop,
    ) => {
      details.hidden = !report;
      if (!report) return answer.replaceChildren();
      const { before, symbol, after } = certificateWords(report, group, stop);
      answer.replaceChildren(before, ...groupSymbol(symbol), after);
      setText(numbers, certificateDetails(report));
    },
  );

  return {
    /** @param {State} state */
    update(state) {
      const certifying = certifyingOf(state.session.phase);
      const shown = certificateButton(state);
      setText(button, shown.label);
      setEnabled(button, shown.enabled);
      ({ action } = shown);
      progress.hidden = !certifying;
      question.hidden = certifying !== null;
      if (certifying) progress.value = certifying.progress;
      showAnswer(state.document.result.certificate, state.document.result.group, state.document.result.stop);
    },
    dispose: () => listening.abort(),
  };
}
