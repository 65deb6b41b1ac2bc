// SPDX-License-Identifier: MIT
/**
 * @file Which triangle of a mesh a ray meets first, and which vertex of the cage is nearest to a point. Arrays only, so
 * that the pointer over a fine mesh stays quick.
 */

import { PART, boxesOf, enters } from './boxes.js';

/** @import {Vector3Tuple} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */

/**
 * Where a ray meets a surface: the triangle and the face of the cage, from 0, the point, and the weights of the triangle's
 * corners there.
 * @typedef {{triangle: number, face: number, point: Vector3Tuple, weights: Vector3Tuple}} Hit
 */

/** The points x with normal · x + constant ≥ 0, as three.js' `Plane` has them. @typedef {{normal: {x: number, y: number, z: number}, constant: number}} HalfSpace */

/**
 * How far beside a triangle a ray still meets it, as a part of its sides. Without it rounding lets a ray through an edge
 * pass between the two triangles there.
 */
const EDGE = 1e-6;

/**
 * The nearest of some triangles that the ray meets, from either side. T. Möller & B. Trumbore 1997.
 * @param {Pick<Mesh, 'positions' | 'triangles'>} mesh
 * @param {Vector3Tuple} origin
 * @param {Vector3Tuple} direction
 * @param {number} first index of the first corner
 * @param {number} last index after the last corner
 * @param {number} least distance
 * @param {{distance: number, triangle: number, u: number, v: number}} found nearer than this; changed in place. Distances are
 *   multiples of the direction, and u, v are the weights of the triangle's second and third corner
 */
function meet({ positions, triangles }, [ox, oy, oz], [dx, dy, dz], first, last, least, found) {
  for (let t = first; t < last; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ax, ay, az] = [positions[a], positions[a + 1], positions[a + 2]];
    const [ux, uy, uz] = [positions[b] - ax, positions[b + 1] - ay, positions[b + 2] - az];
    const [vx, vy, vz] = [positions[c] - ax, positions[c + 1] - ay, positions[c + 2] - az];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const [sx, sy, sz] = [ox - ax, oy - ay, oz - az];
    const u = (sx * px + sy * py + sz * pz) / determinant;
    if (!(u >= -EDGE && u <= 1 + EDGE)) continue;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (!(v >= -EDGE && u + v <= 1 + EDGE)) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / determinant;
    if (distance > least && distance < found.distance) Object.assign(found, { distance, triangle: t / 3, u, v });
  }
}

/**
 * The part of a ray where normal · x + constant ≥ 0, as its first and last distance in multiples of the direction; the first
 * is not below the last where there is none.
 * @param {Vector3Tuple} origin
 * @param {Vector3Tuple} direction
 * @param {HalfSpace} space
 * @returns {[first: number, last: number]}
 */
function within(origin, direction, { normal, constant }) {
  const dot = (/** @type {Vector3Tuple} */ [x, y, z]) => normal.x * x + normal.y * y + normal.z * z;
  const [height, slope] = [dot(origin) + constant, dot(direction)];
  if (slope === 0) return height >= 0 ? [0, Infinity] : [0, 0];
  const crossing = Math.max(0, -height / slope);
  return slope > 0 ? [crossing, Infinity] : [0, crossing];
}

/**
 * The nearest triangle that the ray meets, from either side.
 * @param {Pick<Mesh, 'positions' | 'triangles' | 'faces'>} mesh
 * @param {Vector3Tuple} origin
 * @param {Vector3Tuple} direction
 * @param {object} [how]
 * @param {Float64Array} [how.boxes] of the mesh; see boxes.js
 * @param {HalfSpace | null} [how.space] outside of which the ray meets nothing
 * @returns {Hit | null}
 */
export function pick(mesh, origin, direction, { boxes = boxesOf(mesh), space = null } = {}) {
  const [ix, iy, iz] = direction.map((component) => 1 / component);
  const [least, most] = space ? within(origin, direction, space) : [0, Infinity];
  const found = { distance: most, triangle: -1, u: 0, v: 0 };
  for (let box = 0; box < boxes.length; box += 6) {
    if (enters(boxes, box, origin, [ix, iy, iz]) >= found.distance) continue;
    const first = (box / 6) * 3 * PART;
    meet(mesh, origin, direction, first, Math.min(first + 3 * PART, mesh.triangles.length), least, found);
  }
  const { triangle, distance, u, v } = found;
  if (triangle < 0) return null;
  const [x, y, z] = origin.map((component, axis) => component + distance * direction[axis]);
  return { triangle, face: mesh.faces[triangle], point: [x, y, z], weights: [1 - u - v, u, v] };
}

/**
 * The vertex of the cage, among those of a face, whose limit point is nearest to a point of the surface. Refinement
 * keeps the numbers of vertices, so the first points of a limit mesh are those of the cage's vertices.
 * @param {Pick<Mesh, 'positions' | 'triangles' | 'faces'>} mesh
 * @param {Pick<Hit, 'face' | 'point'>} hit
 * @param {number} vertices of the cage
 * @returns {number} from 0; -1 if there is none
 */
export function nearestVertex({ positions, triangles, faces }, { face, point: [x, y, z] }, vertices) {
  let nearest = -1;
  let least = Infinity;
  for (let i = 0; i < triangles.length; i++) {
    const v = triangles[i];
    if (v >= vertices || faces[Math.floor(i / 3)] !== face) continue;
    const distance = Math.hypot(positions[3 * v] - x, positions[3 * v + 1] - y, positions[3 * v + 2] - z);
    if (distance < least) [least, nearest] = [distance, v];
  }
  return nearest;
}
