// SPDX-License-Identifier: MIT
/**
 * @file Splits a mesh into what is free and what is held, and finds the rim between them.
 */

/** @import {Mesh} from '../../wasm/types.js' */

/**
 * Triangles reordered so that the free ones come first; `free` counts their indices. `rim` has two vertices for each
 * edge between a held and a free triangle.
 * @typedef {{triangles: Uint32Array, free: number, rim: Uint32Array}} Parts
 */

const FREE = 1;
const HELD = 2;

/**
 * @param {Pick<Mesh, 'positions' | 'triangles' | 'faces'>} mesh
 * @param {Uint8Array | null} held 1 for each held face of the cage; null if nothing is held
 * @returns {Parts}
 */
export function splitHeld({ positions, triangles, faces }, held) {
  if (!held) return { triangles, free: triangles.length, rim: new Uint32Array(0) };
  const ordered = new Uint32Array(triangles.length);
  const sides = new Uint8Array(positions.length / 3);
  let [next, last] = [0, triangles.length];
  for (let t = 0; t < faces.length; t++) {
    const corners = triangles.subarray(3 * t, 3 * t + 3);
    const isHeld = held[faces[t]] === 1;
    ordered.set(corners, isHeld ? (last -= 3) : next);
    if (!isHeld) next += 3;
    for (const corner of corners) sides[corner] |= isHeld ? HELD : FREE;
  }
  return { triangles: ordered, free: next, rim: rimOf(ordered.subarray(next), sides) };
}

/**
 * The edges that only one of the held triangles has. Both ends of such an edge also belong to free triangles, which few
 * vertices do.
 * @param {Uint32Array} triangles the held ones
 * @param {Uint8Array} sides of each vertex
 */
function rimOf(triangles, sides) {
  /** @type {Map<string, [number, number]>} */
  const once = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; i++) {
      const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
      if (sides[a] !== (FREE | HELD) || sides[b] !== (FREE | HELD)) continue;
      const name = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (!once.delete(name)) once.set(name, [a, b]);
    }
  }
  return Uint32Array.from([...once.values()].flat());
}
