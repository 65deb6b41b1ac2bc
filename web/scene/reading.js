// SPDX-License-Identifier: MIT
/**
 * @file What a surface is like at a point of one of its triangles, interpolated between the corners.
 */

/** @import {Vector3Tuple} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Hit} from './pick.js' */

/**
 * Principal curvatures κ1 ≥ κ2 in 1/length, what is computed of each vertex if something is, and the point in the
 * coordinates of the cage.
 * @typedef {{kappa1: number, kappa2: number, computed: number | null, point: Vector3Tuple}} Reading
 */

/**
 * @param {Pick<Mesh, 'triangles' | 'curvatures' | 'centre'>} mesh
 * @param {Float32Array | null} computed per vertex
 * @param {Pick<Hit, 'triangle' | 'weights' | 'point'>} hit
 * @returns {Reading}
 */
export function readingAt({ triangles, curvatures, centre }, computed, { triangle, weights, point }) {
  /** @param {Float32Array} values @param {number} size of each vertex @param {number} [offset] */
  const between = (values, size, offset = 0) =>
    weights.reduce((sum, weight, i) => sum + weight * values[size * triangles[3 * triangle + i] + offset], 0);
  const [x, y, z] = point.map((value, axis) => value + centre[axis]);
  return {
    kappa1: between(curvatures, 2),
    kappa2: between(curvatures, 2, 1),
    computed: computed && between(computed, 1),
    point: [x, y, z],
  };
}
