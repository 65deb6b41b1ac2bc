// SPDX-License-Identifier: MIT
/**
 * @file The controls of the blend: two functionals, the slider between them, and presets.
 */
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { functionals } from '../../../words/functionals.js';
import { compact } from '../../../words/numbers.js';
import { shareOf } from '../family.js';

/** @import {FunctionalName} from '../../../../wasm/types.js' */
/** @import {Action, Blend, State} from '../types.js' */

/** Number of steps of the slider. */
const STEPS = 1000;

/** @type {Array<{words: string, weights: Blend['weights']}>} */
const presets = [
  { words: '1 : 0', weights: [1, 0] },
  { words: '0.95 : 0.05', weights: [0.95, 0.05] },
  { words: '1 : 1', weights: [1, 1] },
  { words: '0 : 1', weights: [0, 1] },
];

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createControlsView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const selects = ['first', 'second'].map((name) => /** @type {HTMLSelectElement} */ (find(root, `[name=${name}]`)));
  const slider = /** @type {HTMLInputElement} */ (find(root, '[name=share]'));
  const outputs = ['first', 'second'].map((name) => find(root, `output.${name}`));
  slider.max = String(STEPS);

  selects.forEach((select, i) => {
    select.append(...functionals.map(({ id, name }) => element('option', { value: id }, name)));
    const index = i ? 1 : 0;
    select.addEventListener(
      'change',
      () => dispatch({ type: 'functionalChosen', index, name: /** @type {FunctionalName} */ (select.value) }),
      { signal },
    );
  });
  slider.addEventListener('input', () => dispatch({ type: 'shareChosen', share: slider.valueAsNumber / STEPS }), {
    signal,
  });
  find(root, '.presets').append(
    ...presets.map(({ words, weights }) => {
      const button = element('button', { type: 'button', class: 'quiet' }, words);
      button.addEventListener('click', () => dispatch({ type: 'weightsChosen', weights }), { signal });
      return button;
    }),
  );

  const show = whenChanged((/** @type {Blend} */ { names, weights }) => {
    const words = weights.map((weight) => compact(weight, 4));
    selects.forEach((select, i) => (select.value = names[i]));
    outputs.forEach((output, i) => setText(output, words[i]));
    slider.value = String(Math.round(STEPS * shareOf([weights[0], weights[1]])));
    slider.setAttribute('aria-valuetext', `weights ${words.join(' to ')}`);
  });

  return {
    /** @param {State} state */
    update: (state) => show(state.blend),
    dispose: () => listening.abort(),
  };
}
