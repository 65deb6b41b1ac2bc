// SPDX-License-Identifier: MIT
/**
 * @file Editing the cage: what of it is selected, and the new cage that an edit makes, which takes the place of the one that
 * is open. What is held goes along where it still fits. A run whose cage holds something follows its points. Pure.
 */
import { bridge } from '../../../cage/bridge.js';
import { mirror } from '../../../cage/mirror.js';
import { formatObj, parseObj } from '../../../cage/obj.js';
import { grown, looped, within } from '../../../cage/select.js';
import { extrude, move, remove } from '../../../cage/shape.js';
import { split } from '../../../cage/split.js';
import { cageWords } from '../../../words/cages.js';
import { counted } from '../../../words/numbers.js';
import { takesPoints, withPoints } from './following.js';
import { beginOpening } from './opening.js';
import { withDocument, withView } from './parts.js';

/** @import {Constraints, FaceSelection} from '../../../../wasm/types.js' */
/** @import {Edited, Point, PolygonCage, Refused, Selection} from '../../../cage/polygons.js' */
/** @import {CageEdit, EditAction, EditedCage, Editing, OpenCage, Settings, State} from './types.js' */

/** @type {Selection} */
const nothing = { points: [], faces: [] };

/** Says why a run is in the way of edits that change the cage's faces; null if none is. @param {State} state */
export function runInTheWay({ session: { phase } }) {
  if (phase.name === 'running') return 'A run goes on. Cancel it to edit the cage.';
  return phase.name === 'paused' ? 'A run is paused. Cancel it to edit the cage.' : null;
}

/** Says why the cage cannot be edited now; null if it can, at least its points. @param {State} state */
export function problemOfEditing(state) {
  const { phase } = state.session;
  const { cage } = state.document;
  const problem = runInTheWay(state);
  if (problem && !takesPoints(state)) return problem;
  if (phase.name === 'unavailable') return 'Without the core no cage can be opened.';
  if (cage?.counts.holes) return 'This cage has faces that are marked as holes, which cannot be edited here.';
  return null;
}

/** The cage that the pointer edits; null if it does not, or if the worker has not told it yet. @param {State} state @returns {Editing | null} */
export function editingOn(state) {
  const { view, document } = state;
  if (view.pointer !== 'edit' || problemOfEditing(state)) return null;
  return view.editing && view.editing.source === document.cage?.source ? view.editing : null;
}

/** Whether the worker is to tell the cage that is open. @param {State} state */
export function needsCage(state) {
  const { view, session, document } = state;
  if (view.pointer !== 'edit' || !view.surface || !document.cage || session.opening) return false;
  return !problemOfEditing(state) && !editingOn(state);
}

/** @param {State} state @param {string} obj @returns {State} */
export function afterCageTold(state, obj) {
  const { cage } = state.document;
  const parsed = parseObj(obj);
  if (!cage) return state;
  if ('refused' in parsed) {
    return withView(state, { alert: { title: 'The cage cannot be edited', message: parsed.refused } });
  }
  return withView(state, {
    editing: { source: cage.source, cage: parsed, selection: nothing, drag: null, said: '' },
  });
}

/** @param {OpenCage['source']} source @param {Omit<EditedCage, 'kept'>} edited @returns {Editing} */
export const editingOf = (source, { cage, selection, said }) => ({ source, cage, selection, drag: null, said });

/** Without what a hand has moved, since the core has refused it. @param {State} state @returns {State} */
export const withoutDrag = (state) =>
  state.view.editing?.drag ? withView(state, { editing: { ...state.view.editing, drag: null } }) : state;

/** @param {PolygonCage} cage @param {Selection} selection @param {CageEdit} edit @returns {Edited | Refused} */
function made(cage, selection, edit) {
  switch (edit.kind) {
    case 'move':
      return move(cage, selection, edit.by);
    case 'extrude':
      return extrude(cage, selection, edit.by);
    case 'remove':
      return remove(cage, selection);
    case 'bridge':
      return bridge(cage, selection);
    case 'split':
      return split(cage, selection);
    case 'mirror':
      return mirror(cage, edit.axis, edit.side);
  }
}

/** The new numbers, from 1, of things that had these. @param {number[]} numbers @param {number[]} origins @returns {number[]} */
function renumbered(numbers, origins) {
  const now = new Map(origins.map((origin, i) => [origin + 1, i + 1]));
  return numbers.flatMap((number) => now.get(number) ?? []);
}

/**
 * The faces and groups of a selection that are still there.
 * @param {FaceSelection | undefined} selection
 * @param {Edited} edited
 * @returns {FaceSelection | null} null if none is
 */
function stillSelected({ groups = [], faces = [] } = {}, { cage, faceOrigins }) {
  const known = new Set(cage.groups.map(({ name }) => name));
  const [names, numbers] = [groups.filter((name) => known.has(name)), renumbered(faces, faceOrigins)];
  if (!names.length && !numbers.length) return null;
  return { ...(names.length && { groups: names }), ...(numbers.length && { faces: numbers }) };
}

/** How many faces and groups a selection has. @param {FaceSelection | null | undefined} selection */
const sizeOf = (selection) => (selection?.groups?.length ?? 0) + (selection?.faces?.length ?? 0);

/**
 * What is held of the cage before, as far as it fits the new one. Boundaries have other numbers, so that what is said of
 * single ones is lost with any other edit than a move.
 * @param {Settings} settings
 * @param {Edited} edited
 * @param {boolean} moved whether points have moved and nothing else
 * @returns {Pick<EditedCage, 'kept' | 'said'>}
 */
function keptAfter({ constraints, fill }, edited, moved) {
  if (moved) return { kept: { constraints, fill }, said: '' };
  const { hold, free, pins = [], boundary, ...rest } = constraints;
  const [held, freed] = [stillSelected(hold, edited), stillSelected(free, edited)];
  const left = pins.flatMap((pin) => {
    const [vertex] = renumbered([pin.vertex ?? 0], edited.pointOrigins);
    const [face] = renumbered([pin.face ?? 0], edited.faceOrigins);
    if (vertex === undefined && face === undefined) return [];
    return { ...pin, ...(vertex !== undefined && { vertex }), ...(face !== undefined && { face }) };
  });
  /** @type {Constraints} */
  const kept = {
    ...rest,
    ...(held && { hold: held }),
    ...(freed && { free: freed }),
    ...(left.length && { pins: left }),
    ...(boundary?.condition && { boundary: { condition: boundary.condition } }),
  };
  const lost = [
    [sizeOf(hold) + sizeOf(free) - sizeOf(held) - sizeOf(freed), 'held part'],
    [pins.length - left.length, 'pin'],
    [boundary?.loops?.length ?? 0, 'boundary condition'],
    [fill ? 1 : 0, 'fill'],
  ].filter(([count]) => Number(count) > 0);
  const words = lost.map(([count, name]) => counted(Number(count), String(name)));
  return { kept: { constraints: kept, fill: null }, said: words.length ? `No longer fits: ${words.join(', ')}.` : '' };
}

/** What an edited cage is called: as its file, or after the shape that it was. @param {OpenCage['source']} source */
const nameAfter = (source) => (source.kind === 'text' ? source.name : `${cageWords(source.name).title} edited`);

/** The run goes on with the moved cage. @param {State} state @param {OpenCage['source']} source @param {Edited} moved @returns {State} */
function followedBy(state, source, { cage, selected }) {
  const { cage: open } = state.document;
  const named = open && withDocument(state, { cage: { ...open, source, name: source.name }, minimizer: null });
  const shown = withView(named ?? state, { editing: editingOf(source, { cage, selection: selected, said: '' }) });
  return withPoints(shown, cage.points);
}

/** What a hand still moves, and a run that follows it. @param {State} state @param {Editing} editing @param {Point} by @returns {State} */
function dragged(state, editing, by) {
  const shown = withView(state, { editing: { ...editing, drag: by } });
  const result = takesPoints(state) ? move(editing.cage, editing.selection, by) : null;
  return result && 'cage' in result ? withPoints(shown, result.cage.points) : shown;
}

/** @param {State} state @param {Editing} editing @param {CageEdit} edit @returns {State} */
function edited(state, editing, edit) {
  /** @param {string} said */
  const refused = (said) => withView(state, { editing: { ...editing, drag: null, said } });
  if (state.session.opening) return refused('Another cage or surface is being opened.');
  const problem = runInTheWay(state);
  if (problem && edit.kind !== 'move') return refused(problem);
  const result = made(editing.cage, editing.selection, edit);
  if ('refused' in result) return refused(result.refused);
  const { cage, selected } = result;
  /** @type {OpenCage['source']} */
  const source = { kind: 'text', name: nameAfter(editing.source), text: formatObj(cage) };
  if (edit.kind === 'move' && takesPoints(state)) return followedBy(state, source, result);
  return beginOpening(state, {
    source,
    purpose: 'cage',
    then: 'hold',
    start: null,
    edited: { cage, selection: selected, ...keptAfter(state.document.settings, result, edit.kind === 'move') },
  });
}

/** @param {Selection} selection @param {Extract<EditAction, {type: 'cagePicked'}>} action @returns {Selection} */
function picked(selection, { what, numbers, add }) {
  if (!add) return { ...nothing, [what]: numbers };
  const before = new Set(selection[what]);
  const all = numbers.length > 0 && numbers.every((number) => before.has(number));
  for (const number of numbers) {
    if (all) before.delete(number);
    else before.add(number);
  }
  return { ...selection, [what]: [...before] };
}

/** @param {State} state @param {EditAction} action @returns {State} */
export function afterEditing(state, action) {
  const editing = editingOn(state);
  if (!editing) return state;
  const { cage, selection } = editing;
  /** @param {Selection} next @param {string} [said] */
  const selecting = (next, said = '') =>
    withView(state, { pin: null, editing: { ...editing, selection: within(cage, next), drag: null, said } });
  switch (action.type) {
    case 'cageSelected':
      return selecting(action.selection);
    case 'cagePicked':
      return selecting(picked(selection, action));
    case 'cageSelectionChanged': {
      if (action.how === 'none') return selecting(nothing);
      if (action.how === 'grow') return selecting(grown(cage, selection));
      const loop = looped(cage, selection);
      return loop
        ? selecting(loop)
        : selecting(selection, 'Select two adjacent faces for a strip, or two adjacent vertices for a line.');
    }
    case 'cageDragged':
      return dragged(state, editing, action.by);
    case 'cageEdited':
      return edited(state, editing, action.edit);
  }
}
