// SPDX-License-Identifier: MIT
/**
 * @file How opening a cage or a surface begins: under a new run number, with the current settings.
 */

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
  return { ...state, lastRun: run, wanted: null, opening: { ...opening, run, settings: state.settings } };
}

/** Begins to open the generator's cage. @param {State} state @returns {State} */
export function openGenerated(state) {
  const source = /** @type {const} */ ({ kind: 'generated', ...state.generator });
  return beginOpening(state, { source, purpose: 'cage', then: 'hold', start: null });
}
