// SPDX-License-Identifier: MIT
/**
 * @file How opening a cage or a surface begins: under a new run number, with the current settings.
 */

import { holdIsUsable, keptOf, nothingKept } from './hold.js';
import { problemWith } from './settings.js';

/** @import {Generator, Opening, State} from './types.js' */

/** The shape that the studio opens by default. @type {Generator} */
export const firstGenerator = { name: 'two-3', family: 'flag', thickness: 1 };

/**
 * @param {State} state
 * @param {Omit<Opening, 'run' | 'settings'>} opening
 * @returns {State}
 */
export function beginOpening(state, opening) {
  if (state.status === 'unavailable') return state;
  const run = state.lastRun + 1;
  const settings = { ...state.settings, ...keptBy(state, opening) };
  return { ...state, lastRun: run, wanted: null, opening: { ...opening, run, settings } };
}

/**
 * What is held and filled belongs to the cage that is open, and a surface that is brought back to the run that it comes from.
 * @param {State} state
 * @param {Pick<Opening, 'purpose'>} opening
 */
function keptBy({ settings, runSettings }, { purpose }) {
  if (purpose === 'cage') return nothingKept;
  return keptOf(purpose === 'recovery' ? runSettings : settings);
}

/** Opens the cage again with the current settings. @param {State} state @returns {State} */
export function openPreview(state) {
  const pending = state.opening?.purpose === 'cage' ? state.opening : null;
  const source = pending?.source ?? state.cage?.source;
  if (!source || problemWith(state.settings) || !holdIsUsable(state)) return state;
  return beginOpening(state, { source, purpose: pending?.purpose ?? 'preview', then: 'hold', start: null });
}

/** Begins to open the generator's cage. @param {State} state @returns {State} */
export function openGenerated(state) {
  const source = /** @type {const} */ ({ kind: 'generated', ...state.generator });
  return beginOpening(state, { source, purpose: 'cage', then: 'hold', start: null });
}
