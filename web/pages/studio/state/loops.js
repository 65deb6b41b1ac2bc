// SPDX-License-Identifier: MIT
/**
 * @file The boundary loops of a limit mesh. They have the numbers of the cage's boundaries, less those that are filled: the
 * core orders them by their first vertices, which refinement keeps in front of all others. Pure.
 */

/** @import {Mesh} from '../../../../wasm/types.js' */

/**
 * The vertices of each loop, in their order along it.
 * @param {Pick<Mesh, 'triangles'>} mesh
 * @returns {number[][]} by the smallest vertex of each
 */
export function boundaryLoops({ triangles }) {
  const vertices = triangles.reduce((most, v) => Math.max(most, v + 1), 0);
  /** The directed edges without an opposite one. @type {Map<number, [from: number, to: number]>} */
  const open = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; i++) {
      const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
      if (!open.delete(b * vertices + a)) open.set(a * vertices + b, [a, b]);
    }
  }
  const next = new Map(open.values());
  /** @type {number[][]} */
  const loops = [];
  while (next.size > 0) {
    const [first] = next.keys();
    /** @type {number[]} */
    const loop = [];
    for (let v = first, to = next.get(v); to !== undefined; v = to, to = next.get(v)) {
      loop.push(v);
      next.delete(v);
    }
    loops.push(loop);
  }
  const least = (/** @type {number[]} */ loop) => loop.reduce((a, b) => Math.min(a, b));
  return loops.sort((one, other) => least(one) - least(other));
}
