// SPDX-License-Identifier: MIT
/**
 * @file How a document comes back: from the history, or from where it was kept. All of it is shown at once, and its surface
 * as soon as the worker has opened it. Pure.
 */
import { beginOpening, openGenerated, openPreview } from './opening.js';
import { withSession, withView } from './parts.js';

/** @import {Document, Phase, Result, Source, State} from './types.js' */

/** Whether a result has a surface of its own, not that of the cage. @param {Result} result */
export const hasMoved = ({ samples, stop, catalogs }) => samples.length > 0 || stop !== null || catalogs;

/**
 * A result whose run may go on: without what came after the copy of its surface.
 * @param {Result} result
 * @returns {Result}
 */
function upToCopy(result) {
  const evaluations = result.saved?.evaluations ?? 0;
  const samples = result.samples.filter(({ evaluation }) => evaluation <= evaluations);
  return samples.length < result.samples.length ? { ...result, samples } : result;
}

/**
 * @param {State} state
 * @param {Document} document
 * @param {Phase['name']} phase in which it was
 * @param {'hold' | 'run'} [then] whether a run that went on goes on again
 * @returns {State}
 */
export function restored(state, document, phase, then = 'hold') {
  const { cage } = document;
  const went = phase === 'running' || phase === 'paused';
  const result = went ? upToCopy(document.result) : document.result;
  const shown = withView(
    { ...state, document: result === document.result ? document : { ...document, result } },
    { boundary: null, pin: null, said: '', fitDue: cage?.source !== state.document.cage?.source, alert: null },
  );
  const idle = withSession(shown, { refused: null, exporting: false, wanted: null, opening: null });
  if (!cage) return openGenerated(idle);
  if (state.session.phase.name === 'unavailable') return idle;
  const opened = reopened(withSession(idle, { phase: phaseOf(phase) }), cage.source);
  const { opening, lastRun } = opened.session;
  // From now on nothing is heard of the run before.
  return opening ? withSession(opened, { run: lastRun, opening: { ...opening, then } }) : opened;
}

/**
 * Begins to open a surface again: a run's own as it was, a cage's for what is asked now, which its result may not have been.
 * @param {State} state
 * @param {Source} source
 * @returns {State}
 */
function reopened(state, source) {
  const { result } = state.document;
  const start = hasMoved(result) ? (result.saved?.state ?? null) : null;
  const preview = start ? state : openPreview(state);
  if (preview.session.opening) return preview;
  const opened = beginOpening(state, { source, purpose: 'recovery', then: 'hold', start });
  const { opening } = opened.session;
  return opening ? withSession(opened, { opening: { ...opening, settings: result.settings } }) : opened;
}

/**
 * Tries again what could not be loaded: the core, or an entry of the catalog.
 * @param {State} state
 * @returns {State}
 */
export function retried(state) {
  const { retry } = state.view.alert ?? {};
  if (!retry) return state;
  const again = withView(state, { alert: null });
  if (retry !== 'core') return withSession(again, { wanted: retry, opening: null });
  const { document, session } = again;
  const loading = withSession(again, { phase: { name: 'loading' } });
  if (session.wanted && !document.cage) return loading;
  return restored(loading, document, hasMoved(document.result) ? 'ended' : 'resting');
}

/** @param {Phase['name']} name @returns {Phase} */
function phaseOf(name) {
  if (name === 'ended') return { name, certifying: null };
  return name === 'running' || name === 'paused' ? { name: 'paused', asked: null } : { name: 'resting' };
}
