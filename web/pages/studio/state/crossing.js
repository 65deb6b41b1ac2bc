// SPDX-License-Identifier: MIT
/**
 * @file Whether it is known where the surface crosses itself, and when the worker is to find out. Pure.
 */
import { certifyingOf } from './parts.js';

/** @import {Crossings} from '../../../worker/crossings.js' */
/** @import {State} from './types.js' */

/**
 * What is known: nothing is asked; the surface moves; it is embedded as its energy proves; the worker searches; or what it
 * has found.
 * @typedef {'unasked' | 'moving' | 'embedded' | 'searching' | Crossings} CrossingsKnown
 */

/** @param {State} state @returns {CrossingsKnown} */
export function crossingsKnown({ view, session, document }) {
  const { surface } = view;
  if (!(view.crossings || view.printing) || !surface) return 'unasked';
  const { phase, opening } = session;
  if (opening || view.coarse || phase.name === 'running' || phase.name === 'loading') return 'moving';
  const { latest } = document.result;
  // The energies of a surface at rest come soon after it.
  if (!latest || latest.evaluations !== surface.evaluations) return 'moving';
  if (latest.energies.embedded) return 'embedded';
  return surface.crossings ?? 'searching';
}

/** Whether the worker is to search now. @param {State} state */
export const wantsSearch = (state) => crossingsKnown(state) === 'searching' && !certifyingOf(state.session.phase);
