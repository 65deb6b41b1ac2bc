// SPDX-License-Identifier: MIT
/**
 * @file Triangles as binary PLY, with a normal and the curvatures at each vertex. Coordinates have double precision, so that
 * a small mesh far from the origin keeps its digits.
 */

/** @import {Placed} from './placed.js' */

/** The properties of a vertex, in their order. Curvatures are those of the surface in the file's size. */
const PROPERTIES = [
  ...['x', 'y', 'z'].map((name) => `double ${name}`),
  ...['nx', 'ny', 'nz', 'kappa1', 'kappa2', 'mean_curvature', 'gaussian_curvature'].map((name) => `float ${name}`),
];
const VERTEX = 3 * 8 + 7 * 4;
/** The number of corners, and three indices. */
const FACE = 1 + 3 * 4;

/** @param {number} vertices @param {number} triangles */
const headerOf = (vertices, triangles) =>
  `${[
    'ply',
    'format binary_little_endian 1.0',
    'comment curvatures in 1/length and 1/length^2, positive on a sphere',
    `element vertex ${vertices}`,
    ...PROPERTIES.map((property) => `property ${property}`),
    `element face ${triangles}`,
    'property list uchar int vertex_indices',
    'end_header',
  ].join('\n')}\n`;

/** @param {number} vertices @param {number} triangles @returns {number} bytes */
export const plySize = (vertices, triangles) =>
  headerOf(vertices, triangles).length + VERTEX * vertices + FACE * triangles;

/** @param {Placed} placed of a mesh with normals and curvatures @returns {ArrayBuffer} */
export function ply({ mesh: { positions, normals, curvatures, triangles }, scale, offset }) {
  const [vertices, faces] = [positions.length / 3, triangles.length / 3];
  const header = new TextEncoder().encode(headerOf(vertices, faces));
  const file = new DataView(new ArrayBuffer(plySize(vertices, faces)));
  new Uint8Array(file.buffer).set(header);
  for (let vertex = 0; vertex < vertices; vertex++) {
    const at = header.length + VERTEX * vertex;
    const [kappa1, kappa2] = [curvatures[2 * vertex] / scale, curvatures[2 * vertex + 1] / scale];
    for (let axis = 0; axis < 3; axis++) {
      file.setFloat64(at + 8 * axis, scale * positions[3 * vertex + axis] + offset[axis], true);
      file.setFloat32(at + 24 + 4 * axis, normals[3 * vertex + axis], true);
    }
    [kappa1, kappa2, (kappa1 + kappa2) / 2, kappa1 * kappa2].forEach((value, i) =>
      file.setFloat32(at + 36 + 4 * i, value, true),
    );
  }
  const start = header.length + VERTEX * vertices;
  for (let face = 0; face < faces; face++) {
    file.setUint8(start + FACE * face, 3);
    for (let i = 0; i < 3; i++) file.setInt32(start + FACE * face + 1 + 4 * i, triangles[3 * face + i], true);
  }
  return file.buffer;
}
