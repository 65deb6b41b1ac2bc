// SPDX-License-Identifier: MIT
/**
 * @file The list of pins, the field that pins a vertex by its number, and, after a run, how strongly held regions
 * pull.
 */
import { holdsTheSame } from '../state/hold.js';
import { heldNormal } from '../state/normals.js';
import { pullWords, regionWords } from '../../../words/holding.js';
import { createPinRows } from './pin_rows.js';
import { createLines, element, find, setText, whenChanged } from '../../../views/dom.js';

/** @import {Constraints, ConstraintsReport, Pull} from '../../../../wasm/types.js' */
/** @import {Action, OpenCage, State} from '../state/types.js' */

/** @param {Pull} pull */
function strength(pull) {
  const { value, direction } = pullWords(pull);
  return element('span', { class: 'pull', title: direction }, value);
}

/** The longest side of the surface's box; 0 if there is none. @param {State['view']['surface']} surface */
function sizeOf(surface) {
  if (!surface) return 0;
  const { positions } = surface.control;
  const low = [Infinity, Infinity, Infinity];
  const high = low.map((x) => -x);
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.max(...high.map((x, c) => x - low[c]));
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
  const showPins = createPinRows(list, dispatch, signal);
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
      /** @type {State['view']['surface']} */ surface,
    ) => {
      const focused = [...list.querySelectorAll('button')].findIndex((button) => button === document.activeElement);
      const normals = pins.map((pin) => surface && heldNormal(pin, surface.limit));
      showPins(pins, report?.pins ?? [], normals, sizeOf(surface));
      // The button that had the focus may be gone.
      const buttons = list.querySelectorAll('button');
      const next = buttons[Math.min(focused, buttons.length - 1)] ?? document.querySelector('#pointer input:checked');
      if (focused >= 0 && next instanceof HTMLElement && next !== document.activeElement) next.focus();

      const regions = report?.regions ?? [];
      regionList.hidden = !regions.length;
      regionList.replaceChildren(
        ...regions.map((region) => {
          const name = element('span', { class: 'name' }, regionWords(region, cage?.groups ?? []));
          return element('li', {}, element('span', { class: 'square' }), name, strength(region));
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
      const pinned = Boolean(settings.constraints.pins?.length);
      form.hidden = view.pointer !== 'pin';
      // What has been changed since pulls as nobody knows.
      show(
        settings.constraints,
        holdsTheSame(settings, result.settings) ? result.constrained : null,
        cage,
        pinned ? view.surface : null,
      );
      setText(said, view.said);
    },
    dispose: () => listening.abort(),
  };
}
