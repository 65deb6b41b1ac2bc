// SPDX-License-Identifier: MIT
/**
 * @file Scales surfaces to the area of the unit sphere, so that they and their curvatures can be compared.
 */
import { extent } from '../../scene/geometry.js';

/** @import {Mesh} from '../../../wasm/types.js' */

/** Number of points of a surface at which curvatures are sampled to choose the colours. */
const SPREAD = 2048;

/**
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 * @returns {Float64Array} cumulative areas: of the first triangle, of the first two, … of all
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
 * Curvatures at points spread evenly by area. (Vertices are not: narrow necks have many vertices but little area.)
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
 * The surface moved to the origin and scaled to area 4π. Its curvatures become κ·√(A/4π), in units of the curvature of
 * the sphere with the same area, and no longer depend on size.
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
