// SPDX-License-Identifier: MIT
/**
 * @file The size and the place that a mesh has in a file.
 */

/** @import {Mesh} from '../../wasm/types.js' */

/**
 * A mesh in a file: the coordinates of its vertices are `scale` * `mesh.positions` + `offset`.
 * @typedef {{mesh: Mesh, scale: number, offset: [number, number, number]}} Placed
 */

/** The longest side of the mesh's bounding box, in the cage's units. @param {Mesh} mesh */
export function longestSide({ positions }) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  return Math.max(...high.map((value, axis) => value - low[axis]));
}

/**
 * @param {Mesh} mesh
 * @param {number | null} [extent] what the longest side becomes, with the middle at the origin; null keeps the cage's size
 *   and place
 * @returns {Placed}
 */
export function placed(mesh, extent = null) {
  if (extent === null) {
    const [x, y, z] = mesh.centre;
    return { mesh, scale: 1, offset: [x, y, z] };
  }
  const side = longestSide(mesh);
  return { mesh, scale: side > 0 ? extent / side : 1, offset: [0, 0, 0] };
}
