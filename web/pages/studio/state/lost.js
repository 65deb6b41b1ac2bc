// SPDX-License-Identifier: MIT
/**
 * @file What is left of the studio's state when the worker is lost, and how its surface comes back. Pure.
 */
import { integer } from '../../../words/numbers.js';
import { showsEntry } from './entry.js';
import { keptOf } from './hold.js';
import { beginOpening } from './opening.js';
import { certifyingOf, phases, withDocument, withResult, withSession, withView } from './parts.js';

/** @import {Loss} from '../../../worker/client.js' */
/** @import {State} from './types.js' */

/** @type {Record<Loss, string>} */
const lossTitles = {
  silent: 'The computation stopped answering and was restarted',
  broken: 'The computation broke off and was restarted',
  abandoned: 'Opening was given up',
  unloadable: 'The computation could not be loaded',
};

/** Whether the run on the screen has begun. @param {State} state */
const hasBegun = ({ document, session }) => document.result.samples.length > 0 || session.phase.name === 'running';

/**
 * The worker has been replaced by a new one without any run. The page keeps its data, and opens its surface again.
 * @param {State} state
 * @param {Loss} loss
 * @param {string} detail
 * @returns {State}
 */
export function afterLoss(state, loss, detail) {
  const title = lossTitles[loss];
  const idle = withSession(state, { opening: null, exporting: false });
  if (loss === 'unloadable') {
    const unavailable = withSession(idle, { phase: phases.unavailable });
    const message = `Check the connection, and try again. The browser needs WebAssembly with SIMD.${detail && ` (${detail})`}`;
    return withView(unavailable, { alert: { title, message, retry: 'core' } });
  }
  const stopped = certifyingOf(state.session.phase) ? afterCertificate(idle, detail) : afterRun(idle, title, detail);
  const { cage, result } = state.document;
  if (!cage || state.session.opening?.purpose === 'recovery') return stopped;
  const saved = hasBegun(state) || showsEntry(state) ? result.saved : null;
  return beginOpening(stopped, {
    source: cage.source,
    purpose: 'recovery',
    then: 'hold',
    start: saved?.state ?? null,
  });
}

/**
 * Keeps the computed surface; only the certificate is lost. (A worker is also replaced to abandon a certificate in a
 * step that cannot be interrupted.)
 * @param {State} idle
 * @param {string} detail
 * @returns {State}
 */
function afterCertificate(idle, detail) {
  const { document, session, view } = idle;
  const { settings, result } = document;
  const kept = { ...result.settings, ...keptOf(settings), origin: settings.origin };
  const alert = certifyingOf(session.phase)?.abandoning
    ? view.alert
    : { title: 'The search for lower surfaces broke off', message: detail || 'The surface is kept.' };
  return withView(withSession(withDocument(idle, { settings: kept }), { phase: phases.ended }), { alert });
}

/**
 * @param {State} idle
 * @param {string} title
 * @param {string} detail
 * @returns {State}
 */
function afterRun(idle, title, detail) {
  if (showsEntry(idle)) return withView(idle, { alert: { title, message: detail || 'The surface is kept.' } });
  const { settings, result } = idle.document;
  const begun = hasBegun(idle);
  const saved = begun ? result.saved : null;
  const kept = saved
    ? `The surface after ${integer(saved.evaluations)} evaluations is kept; Start goes on from it.`
    : '';
  const message = [detail, kept].filter(Boolean).join(' ') || 'What was there before is kept.';
  const stopped = withDocument(withResult(idle, { stop: begun ? 'interrupted' : null }), {
    settings: { ...result.settings, ...keptOf(settings), origin: saved ? 'surface' : 'cage' },
  });
  return withView(withSession(stopped, { phase: begun ? phases.ended : phases.resting }), {
    alert: { title, message },
  });
}
