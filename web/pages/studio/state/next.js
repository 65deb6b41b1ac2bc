// SPDX-License-Identifier: MIT
/**
 * @file What comes after a result: the facts that its verdict is made of, and the runs that its next action begins. Pure.
 */
import { nextWords, verdict } from '../../../words/verdict.js';
import { showsEntry } from './entry.js';
import { holdIsUsable, holdsTheSame, keptOf } from './hold.js';
import { beginOpening } from './opening.js';
import { askedOf, certifyingOf, withDocument } from './parts.js';
import { MAX_LEVEL, activeWeights, problemWith } from './settings.js';
import { cageOnScreen } from './taken.js';

/** @import {Next, Outcome} from '../../../words/verdict.js' */
/** @import {Action, Document, Result, Settings, State} from './types.js' */

/** @type {Record<Next, Action['type']>} */
const actions = {
  finer: 'finerPressed',
  goOn: 'goOnPressed',
  check: 'certifyPressed',
  descend: 'descendPressed',
};

/** Whether a run has ended with a surface that has no certificate yet. @param {State} state */
export function canBeCertified({ session: { phase, opening }, document }) {
  return phase.name === 'ended' && !opening && !phase.certifying && !document.result.certificate;
}

/** Whether the surface of an ended run is no minimum, so that the worker may find a lower one. @param {State} state */
export function canDescend({ session: { phase, opening }, document }) {
  const { certificate } = document.result;
  return phase.name === 'ended' && !opening && !phase.certifying && certificate !== null && certificate.negative > 0;
}

/** Whether both ask for the same minimum, however well it is to be known. @param {Settings} one @param {Settings} other */
const seeksTheSame = (one, other) =>
  one.cap === other.cap &&
  one.symmetry === other.symmetry &&
  JSON.stringify(activeWeights(one)) === JSON.stringify(activeWeights(other)) &&
  holdsTheSame(one, other);

/** Whether the result is what is asked for by now. @param {State} state */
const isAsked = ({ document: { settings, result } }) => seeksTheSame(settings, result.settings);

/** Whether the result is that of a run that can be gone on from: nothing runs, and nothing else is asked for. @param {State} state */
function canGoOn(state) {
  const { document, session } = state;
  const still = session.phase.name === 'ended' && !session.opening && !certifyingOf(session.phase);
  return still && document.cage !== null && !document.result.catalogs && isAsked(state);
}

/** The finest level that a run has ended. @param {Result} result */
const finest = ({ levels }) => Math.max(...levels.map(({ level }) => level));

/** Whether a run may take one level more; one with an accuracy has taken all that help and fit. @param {State} state */
const canGoFiner = (state) => {
  const { result } = state.document;
  return canGoOn(state) && result.levels.length > 0 && result.settings.accuracy === null && finest(result) < MAX_LEVEL;
};

/** @param {State} state */
const canGoOnFromSurface = (state) =>
  canGoOn(state) && state.document.result.saved !== null && state.document.result.settings.max_iterations > 0;

/** @param {State} state @returns {Next[]} */
function possible(state) {
  const { cap } = state.document.result.settings;
  const usable = holdIsUsable(state) && !problemWith(state.document.settings);
  return /** @type {Next[]} */ ([
    ...(usable && canGoFiner(state) ? ['finer'] : []),
    ...(usable && canGoOnFromSurface(state) ? ['goOn'] : []),
    // The core gives no certificate with flat caps.
    ...(canGoOn(state) && canBeCertified(state) && cap !== 'flat' ? ['check'] : []),
    ...(isAsked(state) && canDescend(state) ? ['descend'] : []),
  ]);
}

/** What the run of a result holds. @param {Document} document @returns {Outcome['held']} */
function heldBy(document) {
  const { constraints, fill } = document.result.settings;
  const { hold, free, pins = [], boundary = {} } = constraints;
  if (hold || free || pins.length || fill) return 'part';
  const loops = cageOnScreen(document)?.counts.boundaries.length ?? 0;
  const conditions = [boundary.condition ?? 'tangent', ...(boundary.loops ?? []).map(({ condition }) => condition)];
  return loops > 0 && conditions.some((condition) => condition !== 'free') ? 'boundary' : 'nothing';
}

/** @param {State} state @returns {Outcome | null} null unless it has a result */
export function outcomeOf(state) {
  const { document, session } = state;
  const { result } = document;
  const { name } = session.phase;
  if (name !== 'paused' && name !== 'ended') return null;
  if (name === 'ended' && !result.stop && !showsEntry(state)) return null;
  // A report that was opened has levels, but no samples.
  const [sample, last] = [result.samples.at(-1), result.levels.at(-1)];
  return {
    phase: name,
    stop: result.stop,
    energy: sample?.energy ?? last?.energy_reported ?? NaN,
    level: sample?.level ?? last?.level ?? -1,
    levels: result.levels,
    limit: result.limit,
    accuracy: result.settings.accuracy,
    maxIterations: result.settings.max_iterations,
    certificate: result.certificate,
    held: heldBy(document),
    catalog: showsEntry(state) ? (document.minimizer?.entry.status ?? null) : null,
    possible: possible(state),
  };
}

/** What is to be done next, if the result says so. @param {State} state @returns {{label: string, action: Action['type']} | null} */
export function nextButton(state) {
  const outcome = outcomeOf(state);
  if (!outcome || askedOf(state.session.phase)) return null;
  const { next } = verdict(outcome);
  return next && { label: nextWords[next], action: actions[next] };
}

/**
 * Minimizes the same once more with one level more, from where its run began: only levels of one run tell a limit.
 * @param {State} state
 * @returns {State}
 */
export function goFiner(state) {
  const { cage, settings, result } = state.document;
  if (!cage || !canGoFiner(state)) return state;
  /** @type {[number, number]} */
  const levels = [result.settings.levels[0], finest(result) + 1];
  const asked = { ...result.settings, ...keptOf(settings), levels };
  return beginOpening(withDocument(state, { settings: asked }), {
    source: cage.source,
    purpose: 'start',
    then: 'run',
    start: result.start ?? null,
  });
}

/** Minimizes the same further from the surface. @param {State} state @returns {State} */
export function goOnFromSurface(state) {
  const { cage, settings, result } = state.document;
  if (!cage || !result.saved || !canGoOnFromSurface(state)) return state;
  /** @type {Settings} */
  const asked = { ...result.settings, ...keptOf(settings), origin: 'surface' };
  return beginOpening(withDocument(state, { settings: asked }), {
    source: cage.source,
    purpose: 'start',
    then: 'run',
    start: result.saved.state,
  });
}
