// SPDX-License-Identifier: MIT
/**
 * @file How finely the limit surface is tessellated: fewer quads while it moves, more when it rests.
 */

export const MOVING_QUADS = 14_000;
export const RESTING_QUADS = 70_000;
export const SAVED_QUADS = 200_000;

const MAX_DENSITY = 32;

/**
 * Quads along each edge of a patch, such that the mesh has at most about `quads` quads.
 * @param {number} patches
 * @param {number} quads
 */
export function densityFor(patches, quads) {
  return Math.min(MAX_DENSITY, Math.max(1, Math.floor(Math.sqrt(quads / Math.max(1, patches)))));
}
