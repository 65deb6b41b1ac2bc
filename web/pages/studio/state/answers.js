// SPDX-License-Identifier: MIT
/**
 * @file How the worker's messages change the studio's state. Pure. Messages about runs that are no longer shown change
 * nothing.
 */
import { SAMPLE_SIZE, withTopology } from '../../../worker/protocol.js';
import { afterCageTold } from './editing.js';
import { afterRetargeted } from './following.js';
import { afterFailed, afterOpened } from './opened.js';
import { keptOf } from './hold.js';
import { beginOpening } from './opening.js';
import { certifyingOf, phases, withDocument, withResult, withSession, withView } from './parts.js';

/** @import {SurfaceState} from '../../../../wasm/types.js' */
/** @import {Message, Surfaced} from '../../../worker/protocol.js' */
/** @import {Sample, State} from './types.js' */

/**
 * @param {State} state
 * @param {Message} message
 * @returns {State}
 */
export function afterAnswer(state, message) {
  const { opening, run } = state.session;
  switch (message.type) {
    case 'started':
      return withSession(state, { version: message.version, cageNames: message.cages });
    case 'opened':
      return opening?.run === message.run ? afterOpened(state, opening, message) : state;
    case 'failed':
      return afterFailed(state, message.run, message.message);
    case 'ponged':
      return state;
    default:
      return message.run === run ? afterRunMessage(state, message) : state;
  }
}

/**
 * @param {State} state
 * @param {Exclude<Message, {type: 'started' | 'opened' | 'failed' | 'ponged'}>} message
 * @returns {State}
 */
function afterRunMessage(state, message) {
  const { session, document } = state;
  const { result } = document;
  const before = session.before ?? 0;
  const evaluations = 'evaluations' in message ? before + message.evaluations : 0;
  /** Whether this is about the surface as it was brought back. */
  const known = session.before !== null && evaluations === before;
  switch (message.type) {
    case 'surfaced':
      return afterSurfaced(state, message, evaluations);
    case 'recalled': {
      const { run, limit, density, cage } = message;
      return withView(state, { start: { run, limit, density, cage } });
    }
    case 'searched': {
      const { surface } = state.view;
      if (!surface || surface.evaluations !== evaluations) return state;
      return withView(state, { surface: { ...surface, crossings: message.crossings } });
    }
    case 'cageTold':
      return afterCageTold(state, message.obj);
    case 'measured': {
      const { energies, level } = message;
      const kept = known && result.latest?.evaluations === evaluations ? result.latest : null;
      const latest = kept ?? { energies, evaluations, level };
      return withResult(state, { latest, first: result.first ?? latest });
    }
    case 'constrained':
      return withResult(state, { constrained: message.report });
    case 'stepped':
      return withResult(state, {
        progress: message.progress,
        samples: result.samples.concat(unpack(message.samples, before)),
      });
    case 'levelEnded': {
      const others = result.levels.filter(({ level }) => level !== message.report.level);
      // Of a surface that was brought back, the core knows only the levels since.
      const limit = session.before !== null && message.limit.status === 'too_few_levels' ? result.limit : null;
      return withResult(state, { levels: [...others, message.report], limit: limit ?? message.limit });
    }
    case 'retargeted':
      return afterRetargeted(state, message);
    case 'paused':
      return withSession(withResult(state, { progress: message.progress }), {
        phase: { name: 'paused', asked: null },
      });
    case 'ended':
      return withSession(withResult(state, { stop: message.stop, progress: message.progress }), {
        phase: phases.ended,
      });
    case 'saved':
      return known && result.saved ? state : withResult(state, { saved: { state: message.state, evaluations } });
    case 'exported':
      return withSession(state, { exporting: false });
    case 'certificateAdvanced': {
      const certifying = certifyingOf(session.phase);
      if (!certifying) return state;
      return withSession(state, {
        phase: { name: 'ended', certifying: { ...certifying, progress: message.progress } },
      });
    }
    case 'certified':
      return withoutCertifying(withResult(state, { certificate: message.report }));
    case 'descended':
      return afterDescended(withoutCertifying(state), message.state);
    case 'certificateAbandoned':
      return withoutCertifying(state);
  }
}

/** A new run of the same problem begins with the lower surface. @param {State} state @param {SurfaceState} start @returns {State} */
function afterDescended(state, start) {
  const { cage, settings, result } = state.document;
  if (!cage || state.session.phase.name !== 'ended' || state.session.opening) return state;
  const [first, last] = result.settings.levels;
  const asked = { ...result.settings, ...keptOf(settings) };
  asked.levels = [Math.min(first, start.level), Math.max(last, start.level)];
  return beginOpening(withDocument(state, { settings: asked }), {
    source: cage.source,
    purpose: 'start',
    then: 'run',
    start,
  });
}

/** @param {State} state @returns {State} */
const withoutCertifying = (state) =>
  certifyingOf(state.session.phase) ? withSession(state, { phase: phases.ended }) : state;

/** @param {State} state @param {Surfaced} message @param {number} evaluations @returns {State} */
function afterSurfaced(state, message, evaluations) {
  const { surface, fits, fitDue } = state.view;
  const { density, patches, computed = null, coarse = false } = message;
  const limit = withTopology(message.limit, surface?.limit);
  const control = withTopology(message.control, surface?.control);
  return withView(state, {
    surface: { limit, density, control, patches, computed, crossings: null, evaluations },
    coarse,
    fits: fits + (fitDue ? 1 : 0),
    fitDue: false,
  });
}

/** @param {Float64Array} packed @param {number} before evaluations that they do not count @returns {Sample[]} */
function unpack(packed, before) {
  return Array.from({ length: packed.length / SAMPLE_SIZE }, (_, i) => {
    const [evaluation, energy, gradientNorm, level] = packed.subarray(i * SAMPLE_SIZE, (i + 1) * SAMPLE_SIZE);
    return { evaluation: before + evaluation, energy, gradientNorm, level };
  });
}
