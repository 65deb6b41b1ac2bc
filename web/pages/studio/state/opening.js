// SPDX-License-Identifier: MIT
/**
 * @file How opening a cage or a surface begins: under a new run number, with the current settings.
 */

import { holdIsUsable, keptOf, nothingKept } from './hold.js';
import { withSession } from './parts.js';
import { problemWith } from './settings.js';

/** @import {Document, Generator, Opening, State} from './types.js' */

/** The shape that the studio opens by default. @type {Generator} */
export const firstGenerator = { name: 'two-3', family: 'flag', thickness: 1 };

/**
 * @param {State} state
 * @param {Omit<Opening, 'run' | 'settings'>} opening
 * @returns {State}
 */
export function beginOpening(state, opening) {
  const { phase, lastRun } = state.session;
  if (phase.name === 'unavailable') return state;
  const run = lastRun + 1;
  const settings = { ...state.document.settings, ...keptBy(state.document, opening) };
  return withSession(state, { lastRun: run, wanted: null, opening: { ...opening, run, settings } });
}

/**
 * What is held and filled belongs to the cage that is open, and a surface that is brought back to the run that it comes from.
 * @param {Document} document
 * @param {Pick<Opening, 'purpose' | 'edited'>} opening
 */
function keptBy({ settings, result }, { purpose, edited }) {
  if (purpose === 'cage') return edited?.kept ?? nothingKept;
  return keptOf(purpose === 'recovery' ? result.settings : settings);
}

/** Opens the cage again with the current settings. @param {State} state @returns {State} */
export function openPreview(state) {
  const { document, session } = state;
  const pending = session.opening?.purpose === 'cage' ? session.opening : null;
  const source = pending?.source ?? document.cage?.source;
  if (!source || problemWith(document.settings) || !holdIsUsable(state)) return state;
  const edited = pending?.edited && { edited: pending.edited };
  return beginOpening(state, { source, purpose: pending?.purpose ?? 'preview', then: 'hold', start: null, ...edited });
}

/** Begins to open the generator's cage. @param {State} state @returns {State} */
export function openGenerated(state) {
  const source = /** @type {const} */ ({ kind: 'generated', ...state.document.generator });
  return beginOpening(state, { source, purpose: 'cage', then: 'hold', start: null });
}
