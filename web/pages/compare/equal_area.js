// SPDX-License-Identifier: MIT
/**
 * @file Brings surfaces to one size, so that they and their curvatures can be compared: each as large as the unit sphere.
 */
import { extent } from '../../scene/geometry.js';

/** @import {Mesh} from '../../../wasm/types.js' */

/**
 * The area of a mesh's triangles.
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 */
export function areaOf({ positions, triangles }) {
  let doubled = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    const [ux, uy, uz] = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    doubled += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  }
  return doubled / 2;
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
    positions: mesh.positions.map((value, i) => scale * (value - centre[i % 3])),
    curvatures: mesh.curvatures.map((value) => value / scale),
  };
}
