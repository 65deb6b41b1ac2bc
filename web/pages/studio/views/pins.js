// SPDX-License-Identifier: MIT
/**
 * @file The list of pins, the field that pins a vertex by its number, and, after a run, how strongly pins and held regions
 * pull.
 */
import { holdsTheSame } from '../state/hold.js';
import { pinWords, pullWords, regionWords } from '../../../words/holding.js';
import { createLines, element, find, setText, whenChanged } from '../../../views/dom.js';

/** @import {Constraints, ConstraintsReport, Pull} from '../../../../wasm/types.js' */
/** @import {Action, OpenCage, State} from '../state/types.js' */

/** @param {Pull | undefined} pull @returns {Node[]} */
function strength(pull) {
  if (!pull) return [];
  const { value, direction } = pullWords(pull);
  return [element('span', { class: 'pull', title: direction }, value)];
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createPinsView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const form = /** @type {HTMLFormElement} */ (find(root, '#pin-vertex'));
  const number = /** @type {HTMLInputElement} */ (find(form, 'input'));
  const list = find(root, '#pins');
  const regionList = find(root, '#regions');
  const words = find(root, '#pull-words');
  const said = find(root, '#hold-said');
  const showNotes = createLines(find(root, '#constraint-notes'));

  form.addEventListener(
    'submit',
    (event) => {
      event.preventDefault();
      dispatch({ type: 'vertexPinned', vertex: number.valueAsNumber });
      number.value = '';
    },
    { signal },
  );

  const show = whenChanged(
    (
      /** @type {Constraints} */ { pins = [] },
      /** @type {ConstraintsReport | null} */ report,
      /** @type {OpenCage | null} */ cage,
    ) => {
      const focused = [...list.querySelectorAll('button')].findIndex((button) => button === document.activeElement);
      list.hidden = !pins.length;
      list.replaceChildren(
        ...pins.map((pin, index) => {
          const name = pinWords(pin);
          const remove = element(
            'button',
            { type: 'button', class: 'quiet', 'aria-label': `Remove the pin: ${name}` },
            '✕',
          );
          remove.addEventListener('click', () => dispatch({ type: 'pinRemoved', index }), { signal });
          const pull = report?.pins.find((one) => one.pin === index + 1);
          const text = element('span', { class: 'name' }, name);
          return element('li', {}, element('span', { class: 'dot' }), text, ...strength(pull), remove);
        }),
      );
      // The button that had the focus is gone.
      const buttons = list.querySelectorAll('button');
      const next = buttons[Math.min(focused, buttons.length - 1)] ?? document.querySelector('#pointer input:checked');
      if (focused >= 0 && next instanceof HTMLElement) next.focus();

      const regions = report?.regions ?? [];
      regionList.hidden = !regions.length;
      regionList.replaceChildren(
        ...regions.map((region) => {
          const name = element('span', { class: 'name' }, regionWords(region, cage?.groups ?? []));
          return element('li', {}, element('span', { class: 'square' }), name, ...strength(region));
        }),
      );
      words.hidden = ![report?.regions, report?.pins, report?.boundaries].some((pulls) => pulls?.length);
      showNotes((report?.notes ?? []).map((note) => ({ words: `Note: ${note}.` })));
      number.max = String(cage?.counts.vertices ?? 1);
    },
  );

  return {
    /** @param {State} state */
    update({ document: { settings, cage, result }, view }) {
      form.hidden = view.pointer !== 'pin';
      // What has been changed since pulls as nobody knows.
      show(settings.constraints, holdsTheSame(settings, result.settings) ? result.constrained : null, cage);
      setText(said, view.said);
    },
    dispose: () => listening.abort(),
  };
}
