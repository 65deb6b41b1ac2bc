// SPDX-License-Identifier: MIT
/**
 * @file How the worker's messages, and the loss of a worker, change the studio's state. Pure. Messages about runs that
 * are no longer shown change nothing.
 */
import { SAMPLE_SIZE, withTopology } from '../worker/protocol.js';
import { integer } from '../words/numbers.js';
import { afterEntryOpened, endedWith, openWithout, showsEntry } from './entry.js';
import { keptOf, nothingKept } from './hold.js';
import { beginOpening, firstGenerator, openGenerated } from './opening.js';
import { placedRefusal } from './refusal.js';
import { settingsFrom, sourceOf } from './settings.js';
import { cagesOf } from './taken.js';

/** @import {Loss} from '../worker/client.js' */
/** @import {Message, Opened} from '../worker/protocol.js' */
/** @import {OpenCage, Opening, Sample, State} from './types.js' */

/**
 * @param {State} state
 * @param {Message} message
 * @returns {State}
 */
export function afterAnswer(state, message) {
  switch (message.type) {
    case 'started':
      return { ...state, version: message.version, cageNames: message.cages };
    case 'opened':
      return state.opening?.run === message.run ? afterOpened(state, state.opening, message) : state;
    case 'failed':
      return afterFailed(state, message.run, message.message);
    case 'ponged':
      return state;
    default:
      return message.run === state.run ? afterRunMessage(state, message) : state;
  }
}

/**
 * @param {State} state
 * @param {Exclude<Message, {type: 'started' | 'opened' | 'failed' | 'ponged'}>} message
 * @returns {State}
 */
function afterRunMessage(state, message) {
  switch (message.type) {
    case 'surfaced': {
      const { evaluations, deviations = null } = message;
      const limit = withTopology(message.limit, state.surface?.limit);
      const control = withTopology(message.control, state.surface?.control);
      const fits = state.fits + (state.fitDue ? 1 : 0);
      return {
        ...state,
        surface: { limit, control, deviations, evaluations },
        coarse: message.coarse ?? false,
        fits,
        fitDue: false,
      };
    }
    case 'measured': {
      const { energies, evaluations, level } = message;
      const latest = { energies, evaluations, level };
      return { ...state, latest, first: state.first ?? latest };
    }
    case 'constrained':
      return { ...state, constrained: message.report };
    case 'stepped':
      return {
        ...state,
        progress: message.progress,
        samples: state.samples.concat(unpack(message.samples)),
      };
    case 'levelEnded':
      return { ...state, levels: [...state.levels, message.report], limit: message.limit };
    case 'paused':
      return { ...state, status: 'paused', asked: null, progress: message.progress };
    case 'ended':
      return { ...state, status: 'ended', asked: null, stop: message.stop, progress: message.progress };
    case 'saved':
      return { ...state, saved: { state: message.state, evaluations: message.evaluations } };
    case 'exported':
      return { ...state, exporting: false };
    case 'certificateAdvanced':
      return state.certifying ? { ...state, certifying: { ...state.certifying, progress: message.progress } } : state;
    case 'certified':
      return { ...state, certifying: null, certificate: message.report };
    case 'certificateAbandoned':
      return { ...state, certifying: null };
  }
}

/** @param {Float64Array} packed @returns {Sample[]} */
function unpack(packed) {
  return Array.from({ length: packed.length / SAMPLE_SIZE }, (_, i) => {
    const [evaluation, energy, gradientNorm, level] = packed.subarray(i * SAMPLE_SIZE, (i + 1) * SAMPLE_SIZE);
    return { evaluation, energy, gradientNorm, level };
  });
}

/**
 * @param {State} state
 * @param {Opening} opening
 * @param {Opened} message
 * @returns {State}
 */
function afterOpened(state, opening, message) {
  const { run, source, settings, purpose, then } = opening;
  const { counts, groups, taken } = cagesOf(message);
  /** @type {State} */
  const opened = {
    ...state,
    run,
    taken,
    opening: null,
    refused: null,
    asked: null,
    runSettings: settings,
    group: message.group,
    exporting: false,
    certifying: null,
    coarse: false,
  };
  if (purpose === 'recovery') {
    const minimizer = state.minimizer && showsEntry(state) ? { ...state.minimizer, run } : state.minimizer;
    return { ...opened, status: state.stop ? 'ended' : 'resting', minimizer };
  }
  if (opening.entry && opening.report && source.kind === 'generated') {
    const cage = { source, name: source.name, counts, groups };
    return afterEntryOpened({ ...opened, cage, alert: null }, opening.entry, opening.report, message.level);
  }
  /** @type {State} */
  const fresh = {
    ...opened,
    status: then === 'hold' ? 'resting' : 'running',
    progress: null,
    stop: null,
    samples: [],
    levels: [],
    limit: null,
    first: null,
    certificate: null,
    constrained: null,
  };
  if (purpose !== 'cage') return fresh;
  /** @type {State} */
  const shown = {
    ...fresh,
    settings: { ...state.settings, ...nothingKept, origin: 'cage' },
    view: { ...state.view, boundary: null },
    said: '',
    minimizer: null,
    saved: null,
    latest: null,
    fitDue: true,
    // A notice about the address must stay visible when the first cage opens.
    alert: state.cage ? null : state.alert,
  };
  if (source.kind === 'problem') return afterFileOpened(shown, source.name, message, { counts, groups });
  return { ...shown, cage: { source, name: source.name, counts, groups } };
}

/**
 * Opens a file. A problem brings its settings; a report is shown as the end of its run.
 * @param {State} shown
 * @param {string} fileName
 * @param {Opened} message
 * @param {Pick<OpenCage, 'counts' | 'groups'>} cage
 * @returns {State}
 */
function afterFileOpened(shown, fileName, { level, asked, report }, { counts, groups }) {
  if (!asked) return shown;
  const source = sourceOf(asked.cage, fileName);
  const settings = settingsFrom(shown.settings, asked);
  /** @type {State} */
  const opened = { ...shown, cage: { source, name: source.name, counts, groups }, settings, runSettings: settings };
  if (source.kind === 'generated') {
    opened.generator = { name: source.name, family: source.family, thickness: source.thickness };
  }
  if (!report) return opened;
  return { ...endedWith(opened, report, level), settings: { ...settings, origin: 'surface' } };
}

/** The notice for a file that cannot be opened. The core's message may begin with the file's name too. @param {string} name @param {string} message */
function notOpened(name, message) {
  const title = `${name} was not opened`;
  return { title, message: message.startsWith(`${name}: `) ? message.slice(name.length + 2) : message };
}

/** @param {State} state @param {number} run @param {string} message @returns {State} */
function afterFailed(state, run, message) {
  const { opening } = state;
  if (opening?.run !== run) {
    if (run !== state.run) return state;
    const title = state.certifying ? 'There is no certificate' : 'This did not work';
    return { ...state, exporting: false, certifying: null, alert: { title, message } };
  }
  /** @type {State} */
  const closed = { ...state, opening: null, status: state.status === 'loading' ? 'resting' : state.status };
  if (opening.purpose === 'entry') return openWithout(closed, message);
  if (opening.purpose === 'cage') {
    /** @type {State} */
    const withAlert = { ...closed, alert: notOpened(opening.source.name, message) };
    // If the address names a shape that does not exist, opens the default shape instead.
    const nothing = !state.cage && opening.source.name !== firstGenerator.name;
    return nothing ? openGenerated({ ...withAlert, status: state.status, generator: firstGenerator }) : withAlert;
  }
  const settings = { ...state.runSettings, ...keptOf(state.settings) };
  const refused = placedRefusal(state, message);
  if (!refused) return { ...closed, settings, alert: { title: 'These settings cannot be used', message } };
  // What could not be filled stays open; everything else waits to be changed.
  const { fill } = state.runSettings;
  return { ...closed, settings: refused.place === 'fill' ? { ...settings, fill } : settings, refused };
}

/** @type {Record<Loss, string>} */
const lossTitles = {
  silent: 'The computation stopped answering and was restarted',
  broken: 'The computation broke off and was restarted',
  abandoned: 'Opening was given up',
  unloadable: 'The computation could not be loaded',
};

/**
 * The worker has been replaced by a new one without any run. The page keeps its data, and opens its surface again.
 * @param {State} state
 * @param {Loss} loss
 * @param {string} detail
 * @returns {State}
 */
export function afterLoss(state, loss, detail) {
  const title = lossTitles[loss];
  /** @type {State} */
  const idle = { ...state, opening: null, asked: null, exporting: false, certifying: null };
  if (loss === 'unloadable') {
    return { ...idle, status: 'unavailable', alert: { title, message: detail || 'WebAssembly with SIMD is needed.' } };
  }
  const started = state.samples.length > 0 || state.status === 'running' || showsEntry(state);
  const stopped = state.certifying ? afterCertificate(state, idle, detail) : afterRun(state, idle, title, detail);
  if (!state.cage || state.opening?.purpose === 'recovery') return stopped;
  const saved = started ? state.saved : null;
  const { source } = state.cage;
  return beginOpening(stopped, { source, purpose: 'recovery', then: 'hold', start: saved?.state ?? null });
}

/**
 * Keeps the computed surface; only the certificate is lost. (A worker is also replaced to abandon a certificate in a
 * step that cannot be interrupted.)
 * @param {State} state
 * @param {State} idle
 * @param {string} detail
 * @returns {State}
 */
function afterCertificate({ certifying, runSettings, settings, alert }, idle, detail) {
  const message = detail || 'The surface is kept.';
  return {
    ...idle,
    settings: { ...runSettings, ...keptOf(settings), origin: settings.origin },
    alert: certifying?.abandoning ? alert : { title: 'The certificate broke off', message },
  };
}

/**
 * @param {State} state
 * @param {State} idle
 * @param {string} title
 * @param {string} detail
 * @returns {State}
 */
function afterRun(state, idle, title, detail) {
  if (showsEntry(state)) return { ...idle, alert: { title, message: detail || 'The surface is kept.' } };
  const started = state.samples.length > 0 || state.status === 'running';
  const kept =
    started && state.saved
      ? `The surface after ${integer(state.saved.evaluations)} evaluations is kept; Start goes on from it.`
      : '';
  const message = [detail, kept].filter(Boolean).join(' ') || 'What was there before is kept.';
  return {
    ...idle,
    status: started ? 'ended' : 'resting',
    stop: started ? 'interrupted' : null,
    settings: {
      ...state.runSettings,
      ...keptOf(state.settings),
      origin: started && state.saved ? 'surface' : 'cage',
    },
    alert: { title, message },
  };
}
