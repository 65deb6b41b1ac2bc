// SPDX-License-Identifier: MIT
/**
 * @file Triangles as binary STL, for printing. All numbers have single precision, so a small mesh far from the origin loses
 * digits.
 */

/** @import {Placed} from './placed.js' */

const HEADER = 80;
/** Normal, three corners, and two bytes without a meaning. */
const TRIANGLE = 50;

/** @param {number} triangles @returns {number} bytes */
export const stlSize = (triangles) => HEADER + 4 + TRIANGLE * triangles;

/** @param {Placed} placed @returns {ArrayBuffer} */
export function stl({ mesh: { positions, triangles }, scale, offset }) {
  const count = triangles.length / 3;
  const file = new DataView(new ArrayBuffer(stlSize(count)));
  file.setUint32(HEADER, count, true);
  // The corners as the file has them, so that the normal is that of the triangle in the file.
  const corners = Float32Array.from({ length: 9 });
  for (let face = 0; face < count; face++) {
    for (let i = 0; i < 9; i++) {
      const vertex = triangles[3 * face + Math.floor(i / 3)];
      corners[i] = scale * positions[3 * vertex + (i % 3)] + offset[i % 3];
    }
    const at = HEADER + 4 + TRIANGLE * face;
    normalOf(corners).forEach((value, axis) => file.setFloat32(at + 4 * axis, value, true));
    corners.forEach((value, i) => file.setFloat32(at + 12 + 4 * i, value, true));
  }
  return file.buffer;
}

/** The unit normal of a triangle; 0 if it has no area. @param {Float32Array} corners 9 coordinates */
function normalOf([ax, ay, az, bx, by, bz, cx, cy, cz]) {
  const [ux, uy, uz, vx, vy, vz] = [bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal);
  return length > 0 ? normal.map((value) => value / length) : normal;
}
