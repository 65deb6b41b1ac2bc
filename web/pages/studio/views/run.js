// SPDX-License-Identifier: MIT
/**
 * @file The run's status or result in a sentence, the next thing to do, the run's buttons, its current numbers, and
 * how long it takes.
 */
import { nextButton } from '../state/next.js';
import { runButtons, statusSentence } from '../state/select.js';
import { estimateWords, leftWords, patienceWords } from '../../../words/durations.js';
import { counted, significant } from '../../../words/numbers.js';
import { effortWords } from '../../../words/results.js';
import { find, onPress, setEnabled, setText } from '../../../views/dom.js';

/** @import {Button} from '../state/select.js' */
/** @import {Action, Result, State} from '../state/types.js' */

/** Reasons to end at a surface that is not the result of all levels. @type {Array<Result['stop']>} */
const HALTED = [null, 'cancelled', 'interrupted', 'max_iterations'];

/** The numbers of a run that goes on or may, and else what it took. @param {State} state */
function progressLine({ document, session }) {
  const { samples, progress, stop, levels } = document.result;
  const runs = session.phase.name === 'running';
  const sample = samples.at(-1);
  const { estimate } = session;
  if (session.phase.name === 'resting') {
    return estimate && !session.opening && !patienceWords(estimate) ? estimateWords(estimate) : '';
  }
  if (!progress || !sample) return runs ? 'Preparing the level …' : '';
  if (runs && progress.phase === 'prepare') return `Preparing level ${progress.level} …`;
  if (runs && progress.phase === 'compare_caps') {
    return ['Comparing with narrower caps', leftWords(progress.seconds_left)].filter(Boolean).join(' · ');
  }
  if (session.phase.name === 'ended' && !HALTED.includes(stop)) return effortWords(levels, sample.evaluation);
  return [
    `energy ${significant(sample.energy, 6)}`,
    `level ${sample.level}`,
    counted(sample.evaluation, 'evaluation'),
    ...(runs ? [leftWords(progress.seconds_left)] : []),
  ]
    .filter(Boolean)
    .join(' · ');
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createRunView(root, dispatch) {
  const listening = new AbortController();
  const names = /** @type {const} */ (['primary', 'step', 'cancel', 'reset']);
  const buttons = names.map((name) => /** @type {HTMLButtonElement} */ (find(root, `#${name}`)));
  const next = /** @type {HTMLButtonElement} */ (find(root, '#next'));
  const status = find(root, '#status');
  const progress = find(root, '#progress');
  const done = /** @type {HTMLProgressElement} */ (find(root, '#done'));
  const patience = find(root, '#patience');
  /** @type {Button['action'][]} */
  const actions = [];
  buttons.forEach((button, i) => {
    onPress(button, () => dispatch(/** @type {Action} */ ({ type: actions[i] })), listening.signal);
  });

  /** @type {Action['type'] | null} */
  let nextAction = null;
  onPress(next, () => nextAction && dispatch(/** @type {Action} */ ({ type: nextAction })), listening.signal);

  /** Shows the next thing to do, if there is one, as the first button of all. @param {State} state */
  function showNext(state) {
    const shown = nextButton(state);
    nextAction = shown?.action ?? null;
    if (shown) setText(next, shown.label);
    else if (document.activeElement === next) buttons[0].focus(); // what has the focus must not vanish
    next.hidden = !shown;
    buttons[0].classList.toggle('primary', !shown);
  }

  /** How much of a run's time is done, and a warning before one that takes long. @param {State} state */
  function showTime({ document, session: { phase, estimate, opening } }) {
    done.hidden = phase.name !== 'running';
    done.value = document.result.progress?.share_done ?? 0;
    const words = phase.name === 'resting' && estimate && !opening ? patienceWords(estimate) : '';
    setText(patience, words);
    patience.hidden = !words;
  }

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
      showNext(state);
      setText(progress, progressLine(state));
      showTime(state);
    },
    dispose: () => listening.abort(),
  };
}
