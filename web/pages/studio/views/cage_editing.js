// SPDX-License-Identifier: MIT
/**
 * @file The panel that edits the cage: numbers of what is selected, where that lies, and the edits.
 */
import { counted } from '../../../words/numbers.js';
import { numbersIn, numbersWords } from '../../../words/numbering.js';
import { find, setText, whenChanged } from '../../../views/dom.js';
import { editingOn, problemOfEditing, runInTheWay } from '../state/editing.js';
import { handleOf } from './edited.js';

/** @import {Point} from '../../../cage/polygons.js' */
/** @import {Action, CageEdit, Editing, State} from '../state/types.js' */

/** "2 faces, 8 vertices selected". @param {Editing} editing */
function selectedWords({ cage, selection: { points, faces } }) {
  if (!points.length && !faces.length) {
    return `Nothing is selected of ${counted(cage.faces.length, 'face')}, ${counted(cage.points.length, 'vertex', 'vertices')}.`;
  }
  const words = [
    ...(faces.length ? [counted(faces.length, 'face')] : []),
    ...(points.length ? [counted(points.length, 'vertex', 'vertices')] : []),
  ];
  return `${words.join(', ')} selected.`;
}

/** A length that is a tenth of the cage's, rounded to one digit. @param {Editing} editing */
function stepOf({ cage: { points } }) {
  let most = 0;
  for (const axis of [0, 1, 2]) {
    let [low, high] = [Infinity, -Infinity];
    for (const point of points) [low, high] = [Math.min(low, point[axis]), Math.max(high, point[axis])];
    most = Math.max(most, high - low);
  }
  return Number((most / 10).toPrecision(1)) || 0.1;
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createCageEditingView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const panel = /** @type {HTMLFieldSetElement} */ (find(root, '#cage-editing'));
  const said = find(root, '#cage-edited');
  /** @param {string} name */
  const field = (name) => /** @type {HTMLInputElement} */ (find(panel, `[name='${name}']`));
  /** @param {string} name @param {() => void} press */
  const onClick = (name, press) => field(name).addEventListener('click', press, { signal });
  /** @type {Editing | null} */
  let editing = null;
  /** The middle of what is selected, exactly; the fields may show fewer digits. @type {Point | null} */
  let place = null;

  for (const what of /** @type {const} */ (['faces', 'points'])) {
    const input = field(what);
    input.addEventListener(
      'change',
      () => {
        const numbers = numbersIn(input.value);
        input.setCustomValidity(numbers ? '' : 'Numbers and ranges, such as 1, 4–6');
        if (!numbers || !editing) return void input.reportValidity();
        dispatch({ type: 'cageSelected', selection: { ...editing.selection, [what]: numbers } });
      },
      { signal },
    );
  }
  for (const how of /** @type {const} */ (['grow', 'loop', 'none'])) {
    onClick(how, () => dispatch({ type: 'cageSelectionChanged', how }));
  }
  const places = ['x', 'y', 'z'].map(field);
  places.forEach((input, axis) =>
    input.addEventListener(
      'change',
      () => {
        if (!place || !Number.isFinite(input.valueAsNumber)) return;
        /** @type {Point} */
        const by = [0, 0, 0];
        by[axis] = input.valueAsNumber - place[axis];
        if (by[axis]) edit({ kind: 'move', by });
      },
      { signal },
    ),
  );
  /** @param {CageEdit} asked */
  const edit = (asked) => dispatch({ type: 'cageEdited', edit: asked });
  const extrude = () => edit({ kind: 'extrude', by: field('by').valueAsNumber });
  onClick('extrude', extrude);
  field('by').addEventListener('keydown', (event) => event.key === 'Enter' && extrude(), { signal });
  for (const kind of /** @type {const} */ (['remove', 'bridge', 'split'])) onClick(kind, () => edit({ kind }));
  onClick('mirror', () => {
    const [axis, side] = field('side').value.split(' ').map(Number);
    edit({ kind: 'mirror', axis: /** @type {0 | 1 | 2} */ (axis), side: side > 0 ? 1 : -1 });
  });

  /** @param {Editing} now */
  function showSelection(now) {
    const { selection } = now;
    for (const what of /** @type {const} */ (['faces', 'points'])) {
      field(what).setCustomValidity('');
      field(what).value = numbersWords(selection[what]);
    }
    place = handleOf(now);
    const step = stepOf(now);
    const digits = Math.min(Math.max(Math.ceil(-Math.log10(step)) + 3, 0), 20);
    places.forEach((input, axis) => {
      input.disabled = !place;
      input.step = String(step / 10);
      input.value = place ? String(Number(place[axis].toFixed(digits))) : '';
    });
    field('by').step = String(step);
    if (!field('by').value) field('by').value = String(step);
  }

  const show = whenChanged((/** @type {Editing | null} */ now) => {
    editing = now;
    if (now) showSelection(now);
  });

  return {
    /** @param {State} state */
    update(state) {
      const isOn = state.view.pointer === 'edit';
      panel.hidden = !isOn;
      said.hidden = !isOn;
      const problem = problemOfEditing(state);
      panel.disabled = problem !== null;
      for (const name of ['extrude', 'remove', 'bridge', 'split', 'mirror']) {
        field(name).disabled = runInTheWay(state) !== null;
      }
      const now = editingOn(state);
      show(now);
      setText(said, !isOn ? '' : (problem ?? (now ? now.said || selectedWords(now) : '')));
      said.classList.toggle('problem', Boolean(now?.said));
    },
    dispose: () => listening.abort(),
  };
}
