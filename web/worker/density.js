// SPDX-License-Identifier: MIT
/**
 * @file The density of the limit mesh: fewer quads while the surface moves, more when it rests.
 */

export const MOVING_QUADS = 14_000;
export const RESTING_QUADS = 70_000;
export const SAVED_QUADS = 200_000;

/** Largest number of quads along each edge of a patch; more would not be visible. */
const RESTING_DENSITY = 32;
const MOVING_DENSITY = 16;

/**
 * The number of quads along each edge of a patch for a mesh of at most about `quads` quads.
 * @param {number} patches
 * @param {number} quads
 */
export function densityFor(patches, quads) {
  const most = quads > MOVING_QUADS ? RESTING_DENSITY : MOVING_DENSITY;
  return Math.min(most, Math.max(1, Math.floor(Math.sqrt(quads / Math.max(1, patches)))));
}
