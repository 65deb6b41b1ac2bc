// SPDX-License-Identifier: MIT
/**
 * @file Undo and redo. A step is remembered with the document as it was before, which costs nothing, since documents are
 * never changed in place. Steps that change only what is asked leave the run alone when they are undone; those that take
 * another cage or surface to the screen bring back the one that was there. Pure.
 */
import { stepName } from '../../../words/history.js';
import { openPreview } from './opening.js';
import { withDocument, withSession } from './parts.js';
import { hasMoved, restored } from './restore.js';

/** @import {Action, Asked, Document, History, State, Step} from './types.js' */

/** So many steps are remembered, and so many bytes of surfaces and cages in them; the last step always. */
export const MOST_STEPS = 100;
export const MOST_BYTES = 256e6;

/** @type {History} */
export const noHistory = { past: [], future: [] };

/** What is asked of a run, and nothing else. @param {Asked} document @returns {Asked} */
const askedIn = ({ generator, settings }) => ({ generator, settings });

/** @param {Asked} one @param {Asked} other */
const asksTheSame = (one, other) =>
  (one.settings === other.settings && one.generator === other.generator) ||
  JSON.stringify(askedIn(one)) === JSON.stringify(askedIn(other));

/** The bytes of surfaces in some steps, and of the texts of their cages, each counted once. @param {Step[]} steps */
function bytesOf(steps) {
  /** @type {Set<string | Uint8Array>} */
  const texts = new Set();
  let points = 0;
  for (const step of steps) {
    if (!('document' in step)) continue;
    const { result, cage } = step.document;
    points += result.saved?.state.points.length ?? 0;
    if (cage?.source.kind === 'text') texts.add(cage.source.text);
  }
  return [...texts].reduce((sum, { length }) => sum + length, 8 * points);
}

/** @param {State} state @param {Step} step @returns {State} */
function withStep(state, step) {
  const past = [...state.history.past, step].slice(-MOST_STEPS);
  let gone = 0;
  while (gone < past.length - 1 && bytesOf(past.slice(gone)) > MOST_BYTES) gone++;
  return { ...state, history: { past: past.slice(gone), future: [] } };
}

/**
 * Remembers the step that an action made.
 * @param {State} before
 * @param {State} after
 * @param {Action} action
 * @returns {State}
 */
export function remembered(before, after, action) {
  if (action.type === 'paintingEnded') return withStrokeEnded(after);
  if (action.type === 'cageDragged' || action.type === 'cageEdited') {
    if (after.session.targets !== before.session.targets) return withGesture(before, after, action);
  }
  const slides = action.type === 'weightsChanged' || action.type === 'pinMoved' || action.type === 'pinTurned';
  const moving = slides && action.moving;
  if (slides && !moving && isStroke(before.history.past.at(-1))) return withStrokeEnded(after);
  if (after === before || action.type === 'undoPressed' || action.type === 'redoPressed') return after;
  const replaced = replacement(before, after);
  if (replaced) return withStep(after, replaced);
  const name = stepName(action);
  if (!name) return withoutVain(before, after);
  const { opening } = after.session;
  if (opening && opening !== before.session.opening && takesAway(after)) {
    const asked = before.session.opening?.before?.asked ?? askedIn(before.document);
    return withSession(after, { opening: { ...opening, before: { name, asked } } });
  }
  const phase = before.session.phase.name;
  if (phase === 'resting' && after.session.phase.name === 'running') {
    return withStep(after, { name, document: before.document, phase });
  }
  if (asksTheSame(before.document, after.document)) return after;
  const stroke = action.type === 'facesPainted' || moving;
  if (stroke && isStroke(before.history.past.at(-1))) return after;
  return withStep(after, { name, asked: askedIn(before.document), ...(stroke && { stroke }) });
}

/**
 * A run follows the points of its cage: one step from where the hand began to move them.
 * @param {State} before
 * @param {State} after
 * @param {Extract<Action, {type: 'cageDragged' | 'cageEdited'}>} action
 * @returns {State}
 */
function withGesture(before, after, action) {
  const moving = action.type === 'cageDragged';
  if (isStroke(before.history.past.at(-1))) return moving ? after : withStrokeEnded(after);
  const name = stepName({ type: 'cageEdited', edit: { kind: 'move', by: [0, 0, 0] } }) ?? '';
  const { document, session } = before;
  return withStep(after, { name, document, phase: session.phase.name, ...(moving && { stroke: true }) });
}

/** Whether what is being opened takes the surface away that is on the screen. @param {State} state */
function takesAway({ document, session: { opening } }) {
  if (!opening || !document.cage || opening.purpose === 'recovery') return false;
  return opening.purpose !== 'preview' || hasMoved(document.result);
}

/**
 * The step that has just been made by what has opened; null if none.
 * @param {State} before
 * @param {State} after
 * @returns {Step | null}
 */
function replacement(before, after) {
  const { opening } = before.session;
  if (!opening || after.session.opening || opening.run !== after.session.run || !before.document.cage) return null;
  const phase = before.session.phase.name;
  if (opening.before) {
    const { name, asked } = opening.before;
    return { name, document: { ...before.document, ...asked }, phase };
  }
  const starts = opening.purpose !== 'recovery' && after.session.phase.name === 'running';
  return starts ? { name: 'minimize', document: before.document, phase } : null;
}

/** The next stroke of the brush, or of a slider, is another step. @param {State} state @returns {State} */
function withStrokeEnded(state) {
  const last = state.history.past.at(-1);
  if (!last || !isStroke(last)) return state;
  const past = [...state.history.past.slice(0, -1), { ...last, stroke: false }];
  return withoutVain(state, { ...state, history: { ...state.history, past } });
}

/** Without a last step that changed nothing, since the core has refused it. @param {State} before @param {State} after @returns {State} */
function withoutVain(before, after) {
  const last = after.history.past.at(-1);
  const unchanged = before !== after && before.document === after.document && before.history === after.history;
  if (unchanged || !last || !('asked' in last) || !asksTheSame(last.asked, after.document)) return after;
  return { ...after, history: { ...after.history, past: after.history.past.slice(0, -1) } };
}

/** Whether a step is one of a brush, a slider or a part of the cage that is still held. @param {Step | undefined} step */
const isStroke = (step) => Boolean(step?.stroke);

/** Whether something is being opened that a step back would have to wait for. @param {State} state */
const isBusy = ({ session: { opening } }) => Boolean(opening?.before);

/** What would be undone, in words; null if nothing. @param {State} state */
export const undoName = (state) => (isBusy(state) ? null : (state.history.past.at(-1)?.name ?? null));

/** What would be redone, in words; null if nothing. @param {State} state */
export const redoName = (state) => (isBusy(state) ? null : (state.history.future.at(-1)?.name ?? null));

/**
 * Goes to the other side of a step.
 * @param {State} state
 * @param {Step} step
 * @returns {{there: State, back: Step}} `back` leads here again
 */
function crossed(state, step) {
  const { name } = step;
  const phase = state.session.phase.name;
  if ('document' in step) {
    return { there: restored(state, step.document, step.phase), back: { name, document: state.document, phase } };
  }
  const there = withSession(withDocument(state, step.asked), { refused: null });
  const back = { name, asked: askedIn(state.document) };
  return { there: phase === 'resting' ? openPreview(there) : there, back };
}

/** @param {State} state @returns {State} */
export function undone(state) {
  const { past, future } = state.history;
  const step = past.at(-1);
  if (!step || isBusy(state)) return state;
  const { there, back } = crossed(state, step);
  return { ...there, history: { past: past.slice(0, -1), future: [...future, back] } };
}

/** @param {State} state @returns {State} */
export function redone(state) {
  const { past, future } = state.history;
  const step = future.at(-1);
  if (!step || isBusy(state)) return state;
  const { there, back } = crossed(state, step);
  return { ...there, history: { past: [...past, back], future: future.slice(0, -1) } };
}
