// SPDX-License-Identifier: MIT
/**
 * @file How finely the limit surface is tessellated: fewer quads while it moves, more when it rests.
 */

export const MOVING_QUADS = 14_000;
export const RESTING_QUADS = 70_000;
export const SAVED_QUADS = 200_000;

/** Quads along each edge of a patch, at most: more are not seen at rest, or while it moves. */
const RESTING_DENSITY = 32;
const MOVING_DENSITY = 16;

/**
 * Quads along each edge of a patch, such that the mesh has at most about `quads` quads.
 * @param {number} patches
 * @param {number} quads
 */
export function densityFor(patches, quads) {
  const most = quads > MOVING_QUADS ? RESTING_DENSITY : MOVING_DENSITY;
  return Math.min(most, Math.max(1, Math.floor(Math.sqrt(quads / Math.max(1, patches)))));
}
