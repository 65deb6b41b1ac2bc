// SPDX-License-Identifier: MIT
/**
 * @file The panel for what is minimized and how: functional or blend, cap, symmetry, levels, tolerance, and where the
 * next run starts.
 */
import { takesWeights } from '../state/following.js';
import { canStartFromSurface, settingsAreFree } from '../state/reduce.js';
import { ACCURACIES, MAX_LEVEL, problemWith } from '../state/settings.js';
import { caps, functionals } from '../../../words/functionals.js';
import { percent } from '../../../words/numbers.js';
import { groupWords } from '../../../words/results.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { groupSymbol } from '../../../views/group.js';

/** @import {CapName, FunctionalName} from '../../../../wasm/types.js' */
/** @import {Action, Result, Settings, State} from '../state/types.js' */

/** A number as a user would type it: 1e-6, 0.01. @param {number} value */
function plainNumber(value) {
  return value > 0 && value < 1e-3 ? value.toExponential() : String(value);
}

/** The value of an accuracy in the menu of levels. @param {number} accuracy */
const accuracyValue = (accuracy) => `within ${accuracy}`;

/**
 * What the menus of levels say. With an accuracy the last level does not count.
 * @param {string} first
 * @param {string} last
 * @returns {Partial<Settings>}
 */
function levelsChosen(first, last) {
  const accuracy = /^within (.+)$/.exec(last)?.[1];
  if (accuracy) return { accuracy: Number(accuracy), levels: [Number(first), Math.max(Number(first), 2)] };
  return { accuracy: null, levels: [Number(first), Number(last)] };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createObjectiveView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  /** @template {HTMLElement} T @param {string} name @returns {T} */
  const field = (name) => /** @type {T} */ (find(root, `[name=${name}]`));
  const functional = /** @type {HTMLSelectElement} */ (field('functional'));
  const symmetry = /** @type {HTMLInputElement} */ (field('symmetry'));
  const group = find(root, '#group');
  const first = /** @type {HTMLSelectElement} */ (field('first'));
  const last = /** @type {HTMLSelectElement} */ (field('last'));
  const tolerance = /** @type {HTMLInputElement} */ (field('tolerance'));
  const maxIterations = /** @type {HTMLInputElement} */ (field('max-iterations'));
  const fields = /** @type {HTMLFieldSetElement[]} */ ([find(root, '#settings-fields'), find(root, '#more-settings')]);
  const weights = find(root, '#weights');
  const origin = find(root, '#origin');
  const problem = find(root, '#settings-problem');

  /** @param {Partial<Settings>} change */
  const change = (change) => dispatch({ type: 'settingsChanged', change });
  /** @param {EventTarget} target @param {() => void} work */
  const onChange = (target, work) => target.addEventListener('change', work, { signal });

  functional.append(
    ...functionals.map(({ id, name, formula }) => element('option', { value: id, title: formula }, name)),
    element('option', { value: 'blend' }, 'Blend …'),
  );
  onChange(functional, () => change({ functional: /** @type {Settings['functional']} */ (functional.value) }));

  const weightInputs = new Map(
    functionals.map(({ id, name, formula }) => {
      const input = element('input', { type: 'number', min: '0', step: 'any', name: `weight-${id}` });
      const slider = element('input', {
        type: 'range',
        min: '0',
        max: '1',
        step: '0.01',
        name: `slide-${id}`,
        'aria-label': `Weight of ${name}`,
      });
      weights.append(element('label', { class: 'line', title: formula }, element('span', {}, name), input), slider);
      /** @param {HTMLInputElement} from @param {boolean} moving */
      const weigh = (from, moving) =>
        dispatch({ type: 'weightsChanged', weights: { [id]: from.valueAsNumber }, moving });
      onChange(input, () => weigh(input, false));
      onChange(slider, () => weigh(slider, false));
      slider.addEventListener('input', () => weigh(slider, true), { signal });
      return /** @type {[FunctionalName, HTMLInputElement[]]} */ ([id, [input, slider]]);
    }),
  );

  const capInputs = caps.map(({ id, name, meaning }) => {
    const input = element('input', { type: 'radio', name: 'cap', value: id });
    find(root, '#caps').append(element('label', { title: meaning }, input, element('span', {}, name)));
    onChange(input, () => change({ cap: /** @type {CapName} */ (id) }));
    return input;
  });

  onChange(symmetry, () => change({ symmetry: symmetry.checked }));

  for (const select of [first, last]) {
    select.append(
      ...Array.from({ length: MAX_LEVEL + 1 }, (_, i) => element('option', { value: String(i) }, String(i))),
    );
    onChange(select, () => change(levelsChosen(first.value, last.value)));
  }
  const accuracies = element('optgroup', { label: 'As many as it takes' });
  last.append(accuracies);
  const offer = (/** @type {number} */ accuracy) =>
    accuracies.append(element('option', { value: accuracyValue(accuracy) }, `within ${percent(accuracy)}`));
  ACCURACIES.forEach(offer);
  onChange(tolerance, () => change({ tolerance: Number(tolerance.value.replace(',', '.') || NaN) }));
  onChange(maxIterations, () => change({ max_iterations: maxIterations.valueAsNumber }));
  const originInputs = /** @type {HTMLInputElement[]} */ ([...origin.querySelectorAll('input')]);
  for (const input of originInputs) {
    onChange(input, () => change({ origin: input.value === 'surface' ? 'surface' : 'cage' }));
  }

  const showSettings = whenChanged((/** @type {Settings} */ settings) => {
    functional.value = settings.functional;
    weights.hidden = settings.functional !== 'blend';
    for (const [id, inputs] of weightInputs) {
      for (const input of inputs) {
        const weight = settings.weights[id] ?? 0; // a stored document may be older than a functional
        if (input.valueAsNumber !== weight) input.value = String(weight);
      }
    }
    for (const input of capInputs) input.checked = input.value === settings.cap;
    setText(find(root, '#cap-words'), caps.find(({ id }) => id === settings.cap)?.meaning ?? '');
    symmetry.checked = settings.symmetry;
    [first.value, last.value] = settings.levels.map(String);
    if (settings.accuracy !== null) {
      last.value = accuracyValue(settings.accuracy);
      if (!last.value) offer(settings.accuracy);
      last.value = accuracyValue(settings.accuracy);
    }
    if (Number.isFinite(settings.tolerance)) tolerance.value = plainNumber(settings.tolerance);
    if (Number.isFinite(settings.max_iterations)) maxIterations.value = String(settings.max_iterations);
    for (const input of originInputs) input.checked = input.value === settings.origin;
    setText(problem, problemWith(settings) ?? '');
  });

  const showGroup = whenChanged((/** @type {Result['group']} */ kept, /** @type {boolean} */ wanted) => {
    const { symbol, words } = groupWords(kept, wanted);
    group.replaceChildren(...groupSymbol(symbol), words);
  });

  return {
    /** @param {State} state */
    update(state) {
      showSettings(state.document.settings);
      // A run without symmetry has group C1, whatever the symmetry of the cage.
      showGroup(
        state.document.result.settings.symmetry ? state.document.result.group : null,
        state.document.settings.symmetry,
      );
      for (const part of fields) part.disabled = !settingsAreFree(state);
      for (const input of [...weightInputs.values()].flat())
        input.disabled = !settingsAreFree(state) && !takesWeights(state);
      origin.hidden = !canStartFromSurface(state);
    },
    dispose: () => listening.abort(),
  };
}
