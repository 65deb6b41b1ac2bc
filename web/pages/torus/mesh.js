// SPDX-License-Identifier: MIT
/**
 * @file The torus of revolution as a mesh with exact normals and curvatures.
 */

/** @import {Mesh} from '../../../wasm/types.js' */

/** Number of vertices along the circle of centres, and around the tube. */
const AROUND = 192;
const ACROSS = 64;

/**
 * The torus of ratio a about the z-axis, with the area of the unit sphere, 4π = 4π² r R. So curvatures are in units of
 * that sphere's: κ₁ = 1/r, κ₂ = cos θ / (R + r cos θ).
 * @param {number} ratio in (0, 1)
 * @returns {Mesh}
 */
export function torusMesh(ratio) {
  const large = 1 / Math.sqrt(Math.PI * ratio);
  const small = ratio * large;
  const count = AROUND * ACROSS;
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  const curvatures = new Float32Array(2 * count);
  const triangles = new Uint32Array(6 * count);
  for (let i = 0; i < AROUND; i++) {
    const along = (2 * Math.PI * i) / AROUND;
    for (let j = 0; j < ACROSS; j++) {
      const vertex = i * ACROSS + j;
      const theta = (2 * Math.PI * j) / ACROSS;
      const distance = large + small * Math.cos(theta);
      const outward = [Math.cos(along) * Math.cos(theta), Math.sin(along) * Math.cos(theta), Math.sin(theta)];
      normals.set(outward, 3 * vertex);
      positions.set([distance * Math.cos(along), distance * Math.sin(along), small * Math.sin(theta)], 3 * vertex);
      curvatures.set([1 / small, Math.cos(theta) / distance], 2 * vertex);
      const [next, across] = [((i + 1) % AROUND) * ACROSS, (j + 1) % ACROSS];
      const [a, b, c, d] = [vertex, next + j, next + across, i * ACROSS + across];
      triangles.set([a, b, c, a, c, d], 6 * vertex);
    }
  }
  return {
    centre: new Float64Array(3),
    positions,
    normals,
    curvatures,
    triangles,
    faces: new Uint32Array(),
    edges: new Uint32Array(),
  };
}
