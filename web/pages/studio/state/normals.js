// SPDX-License-Identifier: MIT
/**
 * @file The normals that pins hold. Pure.
 */

/** @import {Mesh, Pin} from '../../../../wasm/types.js' */

/** @typedef {[number, number, number]} Normal */

/**
 * The normal that a pin holds, of length 1.
 * @param {Pin} pin
 * @param {Pick<Mesh, 'normals'>} mesh of the surface, whose first points are those of the cage's vertices
 * @returns {Normal | null} null if it holds none, or its own one, which nobody knows
 */
export function heldNormal({ normal, vertex }, { normals }) {
  if (!normal) return null;
  if (Array.isArray(normal)) {
    const length = Math.hypot(...normal);
    return [normal[0] / length, normal[1] / length, normal[2] / length];
  }
  const first = 3 * ((vertex ?? 0) - 1);
  if (first < 0 || first + 2 >= normals.length) return null;
  return [normals[first], normals[first + 1], normals[first + 2]];
}
