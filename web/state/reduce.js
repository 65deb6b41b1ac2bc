// SPDX-License-Identifier: MIT
/**
 * @file The studio's initial state and reducer. Pure; sending and saving are in effects.js.
 */
import { parseStudioAddress } from '../address/studio.js';
import { whatIsAsked } from './address.js';
import { afterAnswer, afterLoss } from './answers.js';
import { openEntry, openWithout } from './entry.js';
import { afterHold, holdIsUsable, holdsTheSame, keptOf } from './hold.js';
import { beginOpening, firstGenerator, openGenerated, openPreview } from './opening.js';
import { changeSettings, defaultSettings, problemWith } from './settings.js';

/** @import {StudioAddress} from '../address/studio.js' */
/** @import {Action, State} from './types.js' */

/**
 * The initial state opens what the address names: a minimizer of the catalog, or a generated cage.
 * @param {State['view']['theme']} [theme]
 * @param {{address: StudioAddress, notices: string[]}} [said]
 * @returns {State}
 */
export function initialState(theme = 'system', said = parseStudioAddress('')) {
  const { address } = said;
  const { settings, wanted, notices } = whatIsAsked(address, defaultSettings);
  const sentences = [...said.notices, ...notices];
  /** @type {State} */
  const blank = {
    status: 'loading',
    version: '',
    cageNames: [firstGenerator.name],
    generator: { name: address.shape, family: address.family, thickness: address.thickness },
    settings,
    cage: null,
    taken: null,
    wanted,
    minimizer: null,
    opening: null,
    lastRun: 0,
    run: 0,
    runSettings: settings,
    group: null,
    asked: null,
    progress: null,
    stop: null,
    samples: [],
    levels: [],
    limit: null,
    first: null,
    latest: null,
    surface: null,
    coarse: false,
    saved: null,
    fits: 0,
    fitDue: false,
    exporting: false,
    certifying: null,
    certificate: null,
    constrained: null,
    refused: null,
    said: '',
    alert: sentences.length ? { title: 'A part of the address is left out', message: sentences.join(' ') } : null,
    view: { shading: address.shading, cage: false, camera: address.camera, theme, pointer: 'turn', boundary: null },
  };
  return wanted ? blank : openGenerated(blank);
}

/** Whether a file is a problem or a report, not a cage: JSON begins with a brace. @param {Uint8Array} text */
const isJson = (text) => /^[ \t\r\n]*\{/.test(new TextDecoder('latin1').decode(text.subarray(0, 1000)));

/** Whether settings may be changed: not while a run uses them. @param {State} state */
export function settingsAreFree(state) {
  return state.status === 'resting' || state.status === 'ended' || state.status === 'loading';
}

/** Whether the next run can start from the current surface: not if it holds something else. @param {State} state */
export function canStartFromSurface({ status, saved, settings, runSettings }) {
  return status === 'ended' && saved !== null && holdsTheSame(settings, runSettings);
}

/** Whether the next run starts from the current surface. @param {State} state */
export function startsFromSurface(state) {
  return canStartFromSurface(state) && state.settings.origin === 'surface';
}

/** Whether a run has ended with a surface that has no certificate yet. @param {State} state */
export function canBeCertified({ status, opening, certifying, certificate }) {
  return status === 'ended' && !opening && !certifying && !certificate;
}

/**
 * Starts, resumes or makes one step: of the current run, of the one being opened, or of a new one.
 * @param {State} state
 * @param {'run' | 'step'} then
 * @returns {State}
 */
function go(state, then) {
  if (!state.cage || problemWith(state.settings) || !holdIsUsable(state)) return state;
  const { opening } = state;
  if (opening && (opening.purpose === 'cage' || holdsTheSame(state.settings, opening.settings))) {
    return settingsAreFree(state) ? { ...state, opening: { ...opening, then } } : state;
  }
  const current = state.status === 'paused' || holdsTheSame(state.settings, state.runSettings);
  if (state.status === 'paused' || (state.status === 'resting' && current))
    return { ...state, status: 'running', asked: null, stop: null, constrained: null };
  if (state.status !== 'ended' && state.status !== 'resting') return state;
  if (state.saved && startsFromSurface(state)) {
    const { source } = state.cage;
    return beginOpening(state, { source, purpose: 'start', then, start: state.saved.state });
  }
  return beginOpening(state, { source: state.cage.source, purpose: 'start', then, start: null });
}

/** Minimizes again from the cage, with the settings of the catalog's run. @param {State} state @returns {State} */
function again(state) {
  const { minimizer, cage } = state;
  if (!minimizer || !cage || !settingsAreFree(state) || state.opening) return state;
  const asked = { ...state, settings: { ...minimizer.settings, ...keptOf(state.settings) } };
  return beginOpening(asked, { source: cage.source, purpose: 'start', then: 'run', start: null });
}

/**
 * @param {State} state
 * @param {Action} action
 * @returns {State}
 */
export function reduce(state, action) {
  switch (action.type) {
    case 'generatorChanged':
      return openGenerated({ ...state, generator: { ...state.generator, ...action.change } });
    case 'fileChosen': {
      const { name, text } = action;
      const source = isJson(text)
        ? { kind: /** @type {const} */ ('problem'), name, text }
        : { kind: /** @type {const} */ ('text'), name, text };
      return beginOpening(state, { source, purpose: 'cage', then: 'hold', start: null });
    }
    case 'fileRefused':
      return { ...state, alert: { title: `${action.name} was not opened`, message: action.message } };
    case 'settingsChanged': {
      if (!settingsAreFree(state)) return state;
      const changed = { ...state, settings: changeSettings(state.settings, action.change) };
      return state.status === 'ended' ? changed : openPreview(changed);
    }
    case 'weightChanged': {
      const weights = { ...state.settings.weights, [action.functional]: action.weight };
      return reduce(state, { type: 'settingsChanged', change: { weights } });
    }
    case 'facesPainted':
    case 'paintingEnded':
    case 'groupHeld':
    case 'holdEdited':
    case 'vertexPinned':
    case 'pinRemoved':
    case 'conditionChosen':
    case 'fillPressed':
    case 'closenessChanged': {
      const held = afterHold(state, action);
      // A run goes on with what it holds; a stroke is shown by the core when it has ended, and a fill at once.
      const over = state.status === 'resting' || (action.type === 'fillPressed' && state.status === 'ended');
      const waits = !over || state.opening?.purpose === 'cage' || action.type === 'facesPainted';
      const shown = state.opening?.settings ?? state.runSettings;
      return waits || holdsTheSame(held.settings, shown) ? held : openPreview(held);
    }
    case 'startPressed':
      return go(state, 'run');
    case 'stepPressed':
      return go(state, 'step');
    case 'pausePressed':
      return state.status === 'running' && !state.asked ? { ...state, asked: 'pause' } : state;
    case 'cancelPressed':
      return !state.opening && (state.status === 'running' || state.status === 'paused')
        ? { ...state, asked: 'cancel' }
        : state;
    case 'resetPressed': {
      const settings = { ...state.settings, origin: /** @type {const} */ ('cage') };
      return openPreview({ ...state, settings });
    }
    case 'certifyPressed':
      return canBeCertified(state) ? { ...state, certifying: { progress: 0, abandoning: false } } : state;
    case 'certificateCancelPressed':
      return state.certifying ? { ...state, certifying: { ...state.certifying, abandoning: true } } : state;
    case 'entryLoaded':
      return openEntry(state, action);
    case 'entryMissing':
      return state.wanted === action.name ? openWithout(state, action.message) : state;
    case 'againPressed':
      return again(state);
    case 'viewChanged':
      return { ...state, view: { ...state.view, ...action.change } };
    case 'fitPressed':
      return { ...state, fits: state.fits + 1 };
    case 'surfaceDrawn':
      return { ...state, coarse: false };
    case 'downloadPressed':
      return { ...state, exporting: true };
    case 'alertDismissed':
      return { ...state, alert: null };
    case 'answered':
      return afterAnswer(state, action.message);
    case 'workerLost':
      return afterLoss(state, action.loss, action.detail);
  }
}
