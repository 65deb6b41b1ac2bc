// SPDX-License-Identifier: MIT
/**
 * @file The edges of the patches that a limit mesh consists of.
 */

/** @import {Mesh} from '../../wasm/types.js' */

/**
 * The edges of the mesh along the borders of its patches, two vertices for each, every edge once. The triangles of a patch
 * follow each other in the mesh, 2 density² of them; an edge that only one of them has is on the border.
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 * @param {number} density quads along each edge of a patch
 * @returns {Uint32Array}
 */
export function patchEdges({ positions, triangles }, density) {
  const vertices = positions.length / 3;
  const patch = 6 * density * density;
  /** @type {Set<number>} */
  const borders = new Set();
  for (let first = 0; first < triangles.length; first += patch) {
    /** @type {Set<number>} */
    const once = new Set();
    for (let t = first; t < first + patch; t += 3) {
      for (let i = 0; i < 3; i++) {
        const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
        const edge = Math.min(a, b) * vertices + Math.max(a, b);
        if (!once.delete(edge)) once.add(edge);
      }
    }
    for (const edge of once) borders.add(edge);
  }
  const edges = new Uint32Array(2 * borders.size);
  let next = 0;
  for (const edge of borders) {
    edges[next++] = Math.floor(edge / vertices);
    edges[next++] = edge % vertices;
  }
  return edges;
}
