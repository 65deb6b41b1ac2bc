// SPDX-License-Identifier: MIT
/**
 * @file How a cage or a surface begins to be opened: under a new run number, with the settings of now.
 */

/** @import {Opening, State} from './types.js' */

/**
 * @param {State} state
 * @param {Omit<Opening, 'run' | 'settings'>} opening
 * @returns {State}
 */
export function beginOpening(state, opening) {
  if (state.status === 'unavailable') return state;
  const run = state.lastRun + 1;
  return { ...state, lastRun: run, opening: { ...opening, run, settings: state.settings } };
}
