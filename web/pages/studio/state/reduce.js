// SPDX-License-Identifier: MIT
/**
 * @file The studio's initial state and reducer. Pure; sending and saving are in effects.js.
 */
import { firstSection } from './section.js';
import { parseStudioAddress } from '../../../address/studio.js';
import { whatIsAsked } from './address.js';
import { afterAnswer } from './answers.js';
import { afterEditing } from './editing.js';
import { openEntry, openWithout } from './entry.js';
import { noHistory, redone, remembered, undone } from './history.js';
import { afterHold, holdIsUsable, holdsTheSame, keptOf } from './hold.js';
import { afterLoss } from './lost.js';
import { followed, takesWeights } from './following.js';
import { alongAxis, looked } from './looking.js';
import { canBeCertified, canDescend, goFiner, goOnFromSurface } from './next.js';
import { beginOpening, firstGenerator, openGenerated, openPreview } from './opening.js';
import {
  askedOf,
  certifyingOf,
  noResult,
  phases,
  withDocument,
  withResult,
  withSession,
  withSettings,
  withView,
} from './parts.js';
import { restored, retried } from './restore.js';
import { changeSettings, defaultSettings, problemWith } from './settings.js';

/** @import {StudioAddress} from '../../../address/studio.js' */
/** @import {Action, HoldAction, State, View} from './types.js' */

/**
 * The initial state opens what the address names: a minimizer of the catalog, or a generated cage.
 * @param {View['theme']} [theme]
 * @param {{address: StudioAddress, notices: string[]}} [said]
 * @returns {State}
 */
export function initialState(theme = 'system', said = parseStudioAddress('')) {
  const { address } = said;
  const { settings, wanted, notices } = whatIsAsked(address, defaultSettings);
  const sentences = [...said.notices, ...notices];
  /** @type {State} */
  const blank = {
    document: {
      generator: { name: address.shape, family: address.family, thickness: address.thickness },
      settings,
      cage: null,
      minimizer: null,
      result: noResult(settings),
    },
    session: {
      phase: { name: 'loading' },
      run: 0,
      lastRun: 0,
      before: null,
      opening: null,
      wanted,
      targets: null,
      exporting: false,
      estimate: null,
      refused: null,
      version: '',
      cageNames: [firstGenerator.name],
    },
    view: {
      shading: address.shading,
      cage: false,
      original: false,
      patches: false,
      isolines: false,
      crossings: false,
      section: firstSection,
      printing: false,
      pinned: null,
      camera: address.camera,
      returnTo: null,
      projection: 'perspective',
      theme,
      pointer: 'turn',
      editing: null,
      boundary: null,
      pin: null,
      surface: null,
      before: false,
      start: null,
      coarse: false,
      fits: 0,
      fitDue: false,
      said: '',
      alert: sentences.length ? { title: 'A part of the address is left out', message: sentences.join(' ') } : null,
    },
    history: noHistory,
  };
  return wanted ? blank : openGenerated(blank);
}

/** Whether a file is a problem or a report, not a cage: JSON begins with a brace. @param {Uint8Array} text */
const isJson = (text) => /^[ \t\r\n]*\{/.test(new TextDecoder('latin1').decode(text.subarray(0, 1000)));

/** Whether settings may be changed: not while a run uses them. @param {State} state */
export function settingsAreFree({ session: { phase } }) {
  return phase.name === 'resting' || phase.name === 'ended' || phase.name === 'loading';
}

/** Whether the next run can start from the current surface: not if it holds something else. @param {State} state */
export function canStartFromSurface({ session, document: { settings, result } }) {
  return session.phase.name === 'ended' && result.saved !== null && holdsTheSame(settings, result.settings);
}

/** Whether the next run starts from the current surface. @param {State} state */
export function startsFromSurface(state) {
  return canStartFromSurface(state) && state.document.settings.origin === 'surface';
}

/**
 * Starts, resumes or makes one step: of the current run, of the one being opened, or of a new one.
 * @param {State} state
 * @param {'run' | 'step'} then
 * @returns {State}
 */
function go(state, then) {
  const { cage, settings, result } = state.document;
  const { opening, phase } = state.session;
  if (!cage || problemWith(settings) || !holdIsUsable(state)) return state;
  if (opening && (opening.purpose === 'cage' || holdsTheSame(settings, opening.settings))) {
    return settingsAreFree(state) ? withSession(state, { opening: { ...opening, then } }) : state;
  }
  const current = holdsTheSame(settings, result.settings);
  if (phase.name === 'paused' || (phase.name === 'resting' && current)) {
    return withSession(withResult(state, { stop: null, constrained: null }), { phase: phases.running });
  }
  if (phase.name !== 'ended' && phase.name !== 'resting') return state;
  const start = startsFromSurface(state) ? (result.saved?.state ?? null) : null;
  return beginOpening(state, { source: cage.source, purpose: 'start', then, start });
}

/** Minimizes again from the cage, with the settings of the catalog's run. @param {State} state @returns {State} */
function again(state) {
  const { minimizer, cage, settings } = state.document;
  if (!minimizer || !cage || !settingsAreFree(state) || state.session.opening) return state;
  const asked = withDocument(state, { settings: { ...minimizer.settings, ...keptOf(settings) } });
  return beginOpening(asked, { source: cage.source, purpose: 'start', then: 'run', start: null });
}

/** Whether the hand that changes something still moves. @param {HoldAction} action */
const isMoving = (action) => action.type === 'facesPainted' || ('moving' in action && Boolean(action.moving));

/** @param {State} state @param {HoldAction} action @returns {State} */
function hold(state, action) {
  const held = afterHold(state, action);
  const { phase, opening } = state.session;
  // A run goes on with what it holds; a stroke is shown by the core when it has ended, and a fill at once.
  const over = phase.name === 'resting' || (action.type === 'fillPressed' && phase.name === 'ended');
  const waits = !over || opening?.purpose === 'cage' || isMoving(action);
  const shown = opening?.settings ?? state.document.result.settings;
  return waits || holdsTheSame(held.document.settings, shown) ? held : openPreview(held);
}

/** @param {State} state @param {string} name @param {Uint8Array} text @returns {State} */
function openFile(state, name, text) {
  const kind = isJson(text) ? /** @type {const} */ ('problem') : /** @type {const} */ ('text');
  return beginOpening(state, { source: { kind, name, text }, purpose: 'cage', then: 'hold', start: null });
}

/** @param {State} state @returns {State} */
function cancel(state) {
  const { phase, opening } = state.session;
  if (opening) return state;
  if (phase.name === 'running') return withSession(state, { phase: { name: 'running', asked: 'cancel' } });
  return phase.name === 'paused' ? withSession(state, { phase: { name: 'paused', asked: 'cancel' } }) : state;
}

/**
 * @param {State} state
 * @param {Action} action
 * @returns {State}
 */
export function reduce(state, action) {
  return followed(remembered(state, changed(state, action), action), action);
}

/**
 * @param {State} state
 * @param {Action} action
 * @returns {State}
 */
function changed(state, action) {
  const { document, session, view } = state;
  switch (action.type) {
    case 'generatorChanged':
      return openGenerated(withDocument(state, { generator: { ...document.generator, ...action.change } }));
    case 'fileChosen':
      return openFile(state, action.name, action.text);
    case 'fileRefused':
      return withView(state, { alert: { title: `${action.name} was not opened`, message: action.message } });
    case 'settingsChanged': {
      if (!settingsAreFree(state)) return state;
      const changed = withDocument(state, { settings: changeSettings(document.settings, action.change) });
      return session.phase.name === 'ended' ? changed : openPreview(changed);
    }
    case 'weightsChanged': {
      const { weights, corners = document.settings.corners } = action;
      const change = { weights: { ...document.settings.weights, ...weights }, corners };
      if (takesWeights(state)) return withSettings(state, change);
      return changed(state, { type: 'settingsChanged', change });
    }
    case 'facesPainted':
    case 'paintingEnded':
    case 'groupHeld':
    case 'holdEdited':
    case 'vertexPinned':
    case 'pinRemoved':
    case 'pinMoved':
    case 'pinTurned':
    case 'copiesSwitched':
    case 'conditionChosen':
    case 'fillPressed':
    case 'closenessChanged':
      return hold(state, action);
    case 'cageSelected':
    case 'cagePicked':
    case 'cageSelectionChanged':
    case 'cageDragged':
    case 'cageEdited':
      return afterEditing(state, action);
    case 'startPressed':
      return go(state, 'run');
    case 'stepPressed':
      return go(state, 'step');
    case 'pausePressed':
      return session.phase.name === 'running' && !askedOf(session.phase)
        ? withSession(state, { phase: { name: 'running', asked: 'pause' } })
        : state;
    case 'cancelPressed':
      return cancel(state);
    case 'finerPressed':
      return goFiner(state);
    case 'goOnPressed':
      return goOnFromSurface(state);
    case 'resetPressed':
      return openPreview(withSettings(state, { origin: 'cage' }));
    case 'certifyPressed':
      return canBeCertified(state)
        ? withSession(state, { phase: { name: 'ended', certifying: { progress: 0, abandoning: false } } })
        : state;
    case 'descendPressed':
      return canDescend(state)
        ? withSession(state, { phase: { name: 'ended', certifying: { progress: 1, abandoning: false } } })
        : state;
    case 'certificateCancelPressed': {
      const certifying = certifyingOf(session.phase);
      if (!certifying) return state;
      return withSession(state, { phase: { name: 'ended', certifying: { ...certifying, abandoning: true } } });
    }
    case 'entryLoaded':
      return openEntry(state, action);
    case 'entryMissing':
      return session.wanted === action.name
        ? openWithout(state, action.message, action.retry ? action.name : null)
        : state;
    case 'retryPressed':
      return retried(state);
    case 'againPressed':
      return again(state);
    case 'viewChanged':
      return withView(state, looked(action.change));
    case 'axisPressed':
      return withView(state, alongAxis(view, action.axis));
    case 'fitPressed':
      return withView(state, { fits: view.fits + 1 });
    case 'surfaceDrawn':
      return withView(state, { coarse: false });
    case 'downloadPressed':
      return withSession(state, { exporting: action.what !== 'history' });
    case 'pictureTaken':
      return withView(withSession(state, { exporting: false }), {
        alert: action.failure === null ? view.alert : { title: 'There is no picture', message: action.failure },
      });
    case 'wakened': {
      const { name } = session.phase;
      return restored(state, document, name, name === 'running' ? 'run' : 'hold');
    }
    case 'undoPressed':
      return undone(state);
    case 'redoPressed':
      return redone(state);
    case 'linkRefused':
      return withView(state, { alert: { title: 'There is no link', message: action.message, save: true } });
    case 'documentParted':
      return withView(state, {
        alert: {
          title: 'Another tab has changed this document',
          message: 'It goes on here as a document of its own. Both are kept.',
        },
      });
    case 'alertDismissed':
      return withView(state, { alert: null });
    case 'answered':
      return afterAnswer(state, action.message);
    case 'workerLost':
      return afterLoss(state, action.loss, action.detail);
  }
}
