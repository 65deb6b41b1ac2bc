// SPDX-License-Identifier: MIT
/**
 * @file How a run follows what is asked while the hand still moves: where only the weights of a blend differ from those of the
 * run, it goes on with the new ones. Pure.
 */
import { askedOf, withResult, withSession } from './parts.js';
import { activeWeights, problemWith } from './settings.js';

/** @import {Retargeted} from '../../../worker/protocol.js' */
/** @import {Action, Settings, State} from './types.js' */

/** Whether the worker has a run that can take other weights. @param {State} state */
export function canFollow({ session: { phase, opening }, document: { settings, result } }) {
  const taken = phase.name === 'running' || phase.name === 'paused' || phase.name === 'ended';
  const blends = settings.functional === 'blend' && result.settings.functional === 'blend';
  return taken && blends && !askedOf(phase) && !opening && !result.catalogs;
}

/** @param {Settings} one @param {Settings} other */
const weighsTheSame = (one, other) => JSON.stringify(activeWeights(one)) === JSON.stringify(activeWeights(other));

/**
 * The state in which the run is told what an action has changed, if it can follow.
 * @param {State} state after the action
 * @param {Action} action
 * @returns {State}
 */
export function followed(state, action) {
  const weighs = action.type === 'weightChanged' || action.type === 'undoPressed' || action.type === 'redoPressed';
  const { settings, result } = state.document;
  if (!weighs || !canFollow(state) || problemWith(settings) || weighsTheSame(settings, result.settings)) return state;
  return withSession(state, { targets: { terms: activeWeights(settings) } });
}

/**
 * The run has taken the targets: what it told before is about others.
 * @param {State} state
 * @param {Retargeted} message
 * @returns {State}
 */
export function afterRetargeted(state, { runs }) {
  const { settings, result } = state.document;
  const fresh = withResult(state, {
    settings: { ...result.settings, weights: settings.weights },
    progress: null,
    stop: null,
    samples: [],
    levels: [],
    limit: null,
    certificate: null,
    constrained: null,
  });
  return withSession(fresh, {
    before: null,
    phase: runs ? { name: 'running', asked: null } : { name: 'paused', asked: null },
  });
}
