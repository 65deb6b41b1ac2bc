// SPDX-License-Identifier: MIT
/**
 * @file What the worker has to compute for the shading, and whether it has. Pure.
 */
import { computedOf } from '../../../colour/quantities.js';
import { activeWeights, problemWith } from './settings.js';

/** @import {Wish} from '../../../worker/computed.js' */
/** @import {State} from './types.js' */

/**
 * The density is that of the energy that is chosen, which the surface need not be minimized for.
 * @param {State} state
 * @returns {Wish | null}
 */
export function wishOf({ view: { shading }, document: { settings } }) {
  const of = computedOf(shading);
  if (of !== 'energy') return of && { of };
  return problemWith(settings) ? null : { of, terms: activeWeights(settings) };
}

/** @param {Wish | null} one @param {Wish | null} other */
export const sameWish = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/**
 * The values at the vertices of the surface on the screen; null if none are wished for, or others are on the way.
 * @param {State} state
 * @returns {Float32Array | null}
 */
export function computedValues(state) {
  const computed = state.view.surface?.computed;
  const wish = wishOf(state);
  return computed && wish && sameWish(computed.wish, wish) ? computed.values : null;
}
