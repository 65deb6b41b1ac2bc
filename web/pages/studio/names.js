// SPDX-License-Identifier: MIT
/**
 * @file The names of the files that are saved.
 */
import { stemOf } from '../../words/cages.js';

/** @import {State} from './state/types.js' */
/** @import {Exportable} from '../../worker/protocol.js' */

/** "two-3.umbilic.json" @param {State} state */
export const projectName = ({ document }) => `${stemOf(document.cage?.name ?? 'cage')}.umbilic.json`;

/**
 * "two-3-mvs_cross-level2.obj", "two-3-mvs_cross-level2-limit.obj", "two-3-mvs_cross.json",
 * "two-3-mvs_cross-problem.json"; without the functional
 * before a run.
 * @param {State} state
 * @param {Exportable} what
 */
export function fileName(state, what) {
  const parts = [stemOf(state.document.cage?.name ?? 'cage')];
  if (state.document.result.samples.length) parts.push(state.document.result.settings.functional);
  if (what === 'report') return `${parts.join('-')}.json`;
  if (what === 'problem') return `${parts.join('-')}-problem.json`;
  parts.push(`level${state.document.result.saved?.state.level ?? 0}`);
  if (what === 'limit') parts.push('limit');
  return `${parts.join('-')}.obj`;
}
