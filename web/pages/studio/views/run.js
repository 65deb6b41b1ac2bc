// SPDX-License-Identifier: MIT
/**
 * @file The run's buttons, its status in words, and its current numbers.
 */
import { runButtons, statusSentence } from '../state/select.js';
import { counted, significant } from '../../../words/numbers.js';
import { find, onPress, setEnabled, setText } from '../../../views/dom.js';

/** @import {Button} from '../state/select.js' */
/** @import {Action, State} from '../state/types.js' */

/** @param {State} state */
function progressLine({ document, session }) {
  const { samples, progress } = document.result;
  const runs = session.phase.name === 'running';
  const sample = samples.at(-1);
  if (!progress || !sample) return runs ? 'Preparing the level …' : '';
  if (runs && progress.phase === 'prepare') return `Preparing level ${progress.level} …`;
  return [
    `energy ${significant(sample.energy, 6)}`,
    `level ${sample.level}`,
    counted(sample.evaluation, 'evaluation'),
  ].join(' · ');
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createRunView(root, dispatch) {
  const listening = new AbortController();
  const names = /** @type {const} */ (['primary', 'step', 'cancel', 'reset']);
  const buttons = names.map((name) => /** @type {HTMLButtonElement} */ (find(root, `#${name}`)));
  const status = find(root, '#status');
  const progress = find(root, '#progress');
  /** @type {Button['action'][]} */
  const actions = [];
  buttons.forEach((button, i) => {
    onPress(button, () => dispatch(/** @type {Action} */ ({ type: actions[i] })), listening.signal);
  });

  return {
    /** @param {State} state */
    update(state) {
      const shown = runButtons(state);
      names.forEach((name, i) => {
        setText(buttons[i], shown[name].label);
        setEnabled(buttons[i], shown[name].enabled);
        actions[i] = shown[name].action;
      });
      setText(status, statusSentence(state));
      setText(progress, progressLine(state));
    },
    dispose: () => listening.abort(),
  };
}
