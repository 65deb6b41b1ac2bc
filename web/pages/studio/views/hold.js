// SPDX-License-Identifier: MIT
/**
 * @file The panel for faces that are held: the groups of the file, what the pointer does on the surface, and changes of all
 * faces at once.
 */
import { heldPart, holdsTheSame, heldWithCopies, problemOfHold, shownHeld } from '../state/hold.js';
import { cageOnScreen } from '../state/taken.js';
import { changeWords, heldWords, pointerWords } from '../../../words/holding.js';
import { counted } from '../../../words/numbers.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';

/** @import {Constraints} from '../../../../wasm/types.js' */
/** @import {Action, CageFaces, HoldAction, Pointer, State} from '../state/types.js' */

/** @type {Array<{how: Extract<HoldAction, {type: 'holdEdited'}>['how'], name: string, title: string}>} */
const edits = [
  { how: 'all', name: 'All', title: 'Hold all faces' },
  { how: 'invert', name: 'Invert', title: 'Hold what is free, and free what is held' },
  { how: 'grow', name: 'Grow', title: 'Hold the faces around those that are held, too' },
  { how: 'clear', name: 'Clear', title: 'Free all faces' },
];

/** Whether there is something that can be copied over the symmetry. @param {Constraints} constraints */
const holdsSomething = ({ hold, free, pins = [], boundary }) =>
  Boolean(hold ?? free) || pins.length > 0 || (boundary?.loops?.length ?? 0) > 0;

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createHoldView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const groups = find(root, '#groups');
  const groupList = find(groups, '.list');
  const pointers = find(root, '#pointer');
  const words = find(root, '#pointer-words');
  const changes = find(root, '#hold-edits');
  const count = find(root, '#held-count');
  const change = find(root, '#hold-change');
  const problem = find(root, '#hold-problem');
  const copies = find(root, '#copies');
  const copied = /** @type {HTMLInputElement} */ (find(copies, 'input'));
  copied.addEventListener('change', () => dispatch({ type: 'copiesSwitched', on: copied.checked }), { signal });

  const radios = Object.entries(pointerWords).map(([pointer, { name, words: title }]) => {
    const input = element('input', { type: 'radio', name: 'pointer', value: pointer });
    pointers.append(element('label', { title: title || 'Drag to turn the surface' }, input, element('span', {}, name)));
    input.addEventListener(
      'change',
      () => dispatch({ type: 'viewChanged', change: { pointer: /** @type {Pointer} */ (pointer), pin: null } }),
      { signal },
    );
    return input;
  });
  for (const { how, name, title } of edits) {
    const button = element('button', { type: 'button', title }, name);
    button.addEventListener('click', () => dispatch({ type: 'holdEdited', how }), { signal });
    changes.append(button);
  }
  /** @type {Array<{group: CageFaces['groups'][number], input: HTMLInputElement}>} */
  let boxes = [];
  const showGroups = whenChanged((/** @type {CageFaces | null} */ cage) => {
    groups.hidden = !cage?.groups.length;
    boxes = (cage?.groups ?? []).map((group) => {
      const input = element('input', { type: 'checkbox' });
      const { name } = group;
      input.addEventListener('change', () => dispatch({ type: 'groupHeld', name, held: input.checked }), { signal });
      return { group, input };
    });
    groupList.replaceChildren(
      ...boxes.map(({ group: { name, faces }, input }) =>
        element(
          'label',
          {},
          input,
          element('span', { class: 'name' }, name),
          element('span', { class: 'note' }, counted(faces.length, 'face')),
        ),
      ),
    );
  });

  const show = whenChanged(
    (
      /** @type {Constraints} */ constraints,
      /** @type {CageFaces | null} */ cage,
      /** @type {number[] | null} */ withCopies,
      /** @type {boolean} */ symmetry,
      /** @type {Pointer} */ pointer,
    ) => {
      showGroups(cage);
      const held = shownHeld(constraints, cage, withCopies);
      copied.checked = constraints.symmetric ?? false;
      copies.hidden = !symmetry || !holdsSomething(constraints);
      const total = held.reduce((sum, one) => sum + one, 0);
      for (const { group, input } of boxes) {
        const part = heldPart(group, held);
        input.checked = part === 'all';
        input.indeterminate = part === 'some';
      }
      for (const input of radios) input.checked = input.value === pointer;
      setText(words, pointerWords[pointer].words);
      words.hidden = pointer === 'turn';
      changes.hidden = pointer !== 'hold' && pointer !== 'free';
      setText(count, cage ? heldWords(total, held.length) : '');
    },
  );

  return {
    /** @param {State} state */
    update(state) {
      const { document, session, view } = state;
      const { settings, result } = document;
      show(settings.constraints, cageOnScreen(document), heldWithCopies(document), settings.symmetry, view.pointer);
      setText(change, changeWords(!holdsTheSame(settings, result.settings), session.phase.name));
      setText(problem, problemOfHold(document) ?? '');
    },
    dispose: () => listening.abort(),
  };
}

/** The word for held parts beside the colours. @param {HTMLElement} root */
export function createHeldKeyView(root) {
  const show = whenChanged((/** @type {Parameters<typeof shownHeld>} */ ...asked) => {
    root.hidden = !shownHeld(...asked).some(Boolean);
  });
  return {
    /** @param {State} state */
    update: ({ document }) => show(document.settings.constraints, cageOnScreen(document), heldWithCopies(document)),
    dispose() {},
  };
}
