// SPDX-License-Identifier: MIT
/**
 * @file How the values of a quantity are spread over the area of a surface.
 */

import { placeOf } from './quantities.js';

/** @import {Quantity} from './quantities.js' */
/** @import {Range} from './range.js' */

/**
 * `shares` are parts of the whole area for equal steps of the range, `below` and `above` the parts outside of it. All add
 * up to 1.
 * @typedef {{shares: Float64Array, below: number, above: number}} Histogram
 */

/**
 * The area that belongs to each vertex: a third of that of its triangles.
 * @param {Float32Array} positions 3 per vertex
 * @param {Uint32Array} triangles 3 per triangle
 * @returns {Float64Array}
 */
export function vertexAreas(positions, triangles) {
  const areas = new Float64Array(positions.length / 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const third = Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 6;
    areas[a / 3] += third;
    areas[b / 3] += third;
    areas[c / 3] += third;
  }
  return areas;
}

/**
 * The places of a quantity's values at all vertices; NaN where it has none.
 * @param {Quantity} quantity
 * @param {Float32Array} curvatures κ1, κ2 per vertex
 * @param {Float32Array | null} computed per vertex, where they are no function of curvatures
 * @returns {Float32Array}
 */
export function valuesOf(quantity, curvatures, computed) {
  const { value: of, axis } = quantity;
  if (of) {
    return Float32Array.from({ length: curvatures.length / 2 }, (_, vertex) =>
      of(curvatures[2 * vertex], curvatures[2 * vertex + 1]),
    );
  }
  if (!computed) return new Float32Array(curvatures.length / 2).fill(NaN);
  return axis ? computed.map((value) => placeOf(quantity, value)) : computed;
}

/**
 * @param {Float32Array} values per vertex; those that are NaN do not count
 * @param {Float64Array} areas per vertex
 * @param {Pick<Range, 'low' | 'high'>} range
 * @param {number} steps
 * @returns {Histogram | null} null if nothing has a value
 */
export function histogram(values, areas, { low, high }, steps) {
  const shares = new Float64Array(steps);
  let [below, above, whole] = [0, 0, 0];
  for (let vertex = 0; vertex < values.length; vertex++) {
    const [value, area] = [values[vertex], areas[vertex]];
    if (Number.isNaN(value)) continue;
    whole += area;
    if (value < low) below += area;
    else if (value > high) above += area;
    else shares[Math.min(steps - 1, Math.floor((steps * (value - low)) / (high - low)))] += area;
  }
  if (!(whole > 0)) return null;
  return { shares: shares.map((area) => area / whole), below: below / whole, above: above / whole };
}
