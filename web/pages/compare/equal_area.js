// SPDX-License-Identifier: MIT
/**
 * @file Brings surfaces to one size, so that they and their curvatures can be compared: each as large as the unit sphere.
 */
import { extent } from '../../scene/geometry.js';

/** @import {Mesh} from '../../../wasm/types.js' */

/** Points that stand for a surface where its colours are chosen. */
const SPREAD = 2048;

/**
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 * @returns {Float64Array} the area of the first triangle, of the first two, … of all of them
 */
function growingAreas({ positions, triangles }) {
  const areas = new Float64Array(triangles.length / 3);
  let sum = 0;
  for (let i = 0; i < areas.length; i++) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[3 * i + k]);
    const [ux, uy, uz] = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    sum += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
    areas[i] = sum;
  }
  return areas;
}

/** The area of a mesh's triangles. @param {Pick<Mesh, 'positions' | 'triangles'>} mesh */
export function areaOf(mesh) {
  return growingAreas(mesh).at(-1) ?? 0;
}

/**
 * Curvatures at points spread evenly over the surface: narrow necks have many vertices and little area.
 * @param {Mesh} mesh
 * @returns {Float32Array} κ₁, κ₂ of each
 */
export function spreadCurvatures(mesh) {
  const areas = growingAreas(mesh);
  const spread = new Float32Array(2 * SPREAD);
  let triangle = 0;
  for (let i = 0; i < SPREAD; i++) {
    const target = (areas[areas.length - 1] * (i + 0.5)) / SPREAD;
    while (areas[triangle] < target && triangle < areas.length - 1) triangle++;
    const vertex = mesh.triangles[3 * triangle];
    spread.set(mesh.curvatures.subarray(2 * vertex, 2 * vertex + 2), 2 * i);
  }
  return spread;
}

/**
 * The surface about the origin with area 4π: curvatures are in units of that of the sphere of the same area, κ·√(A/4π), which are the
 * same for every size.
 * @param {Mesh} mesh
 * @returns {Mesh}
 */
export function withUnitArea(mesh) {
  const scale = Math.sqrt((4 * Math.PI) / areaOf(mesh));
  const { centre } = extent(mesh.positions);
  return {
    ...mesh,
    centre: new Float64Array(3),
    positions: mesh.positions.map((value, i) => scale * (value - centre[i % 3])),
    curvatures: mesh.curvatures.map((value) => value / scale),
  };
}
