// SPDX-License-Identifier: MIT
/**
 * @file Boxes around parts of a mesh, so that a ray need not be tested with each triangle. Triangles that follow each other
 * in a limit mesh are neighbours, so parts of its list are small in space, and no tree is needed.
 */

/** @import {Vector3Tuple} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */

/** How many triangles share a box. */
export const PART = 64;
/** By which part of its size a box is larger than its triangles, since rays meet these a little beside them, too. */
const MARGIN = 1e-5;

/**
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 * @returns {Float64Array} 6 numbers for each `PART` triangles: the low corner, and the high corner
 */
export function boxesOf({ positions, triangles }) {
  const boxes = new Float64Array(6 * Math.ceil(triangles.length / (3 * PART)));
  for (let box = 0, first = 0; box < boxes.length; box += 6, first += 3 * PART) {
    let [lx, ly, lz, hx, hy, hz] = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let i = first; i < Math.min(first + 3 * PART, triangles.length); i++) {
      const vertex = 3 * triangles[i];
      const [x, y, z] = [positions[vertex], positions[vertex + 1], positions[vertex + 2]];
      [lx, ly, lz] = [x < lx ? x : lx, y < ly ? y : ly, z < lz ? z : lz];
      [hx, hy, hz] = [x > hx ? x : hx, y > hy ? y : hy, z > hz ? z : hz];
    }
    const margin = MARGIN * (hx - lx + hy - ly + hz - lz);
    boxes.set([lx - margin, ly - margin, lz - margin, hx + margin, hy + margin, hz + margin], box);
  }
  return boxes;
}

/**
 * Where a ray enters a box: multiples of its direction; infinite if it misses the box.
 * @param {Float64Array} boxes
 * @param {number} box index of its first number
 * @param {Vector3Tuple} origin
 * @param {Vector3Tuple} inverse 1 / each component of the direction
 */
export function enters(boxes, box, origin, inverse) {
  let near = 0;
  let far = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    const low = (boxes[box + axis] - origin[axis]) * inverse[axis];
    const high = (boxes[box + 3 + axis] - origin[axis]) * inverse[axis];
    // A ray within a plane of the box has no number here, which changes neither bound.
    const [first, last] = low > high ? [high, low] : [low, high];
    if (first > near) near = first;
    if (last < far) far = last;
  }
  return near <= far ? near : Infinity;
}
