// SPDX-License-Identifier: MIT
/**
 * @file Triangles as GLB, binary glTF 2.0, with a normal and, if wanted, a colour at each vertex. In glTF y is upwards, and
 * one unit is one metre.
 */

/** @import {Placed} from './placed.js' */

/** The colour where no quantity gives one, linear: the same ceramic as on the page. */
const PLAIN = [0.694, 0.645, 0.558, 1];
const [FLOAT, UINT16, UINT32] = [5126, 5123, 5125];
const [ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER] = [34962, 34963];
const [JSON_CHUNK, BINARY_CHUNK] = [0x4e4f534a, 0x004e4942];

/**
 * Linear colours, red green blue alpha for each vertex, where 65535 is 1.
 * @typedef {Uint16Array} Colours
 */

/** @param {number} vertices @param {number} triangles @param {boolean} coloured @returns {number} bytes, without the description */
export const glbSize = (vertices, triangles, coloured) => (coloured ? 32 : 24) * vertices + 12 * triangles;

/** Turns the z axis upwards onto glTF's y axis. @param {number[]} point @param {'y' | 'z'} up */
const turned = ([x, y, z], up) => (up === 'z' ? [x, z, -y] : [x, y, z]);

/** @param {Float32Array} vectors @param {'y' | 'z'} up @param {number} scale */
function turnedAll(vectors, up, scale) {
  const result = new Float32Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = turned([vectors[i], vectors[i + 1], vectors[i + 2]], up);
    result.set([scale * x, scale * y, scale * z], i);
  }
  return result;
}

/** The least and the largest coordinate of each axis. @param {Float32Array} positions */
function bounds(positions) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    min[i % 3] = Math.min(min[i % 3], positions[i]);
    max[i % 3] = Math.max(max[i % 3], positions[i]);
  }
  return { min, max };
}

/**
 * @param {Placed} placed of a mesh with normals; its offset becomes that of the model, so that a small mesh far from the
 *   origin keeps its digits
 * @param {string} name of the model
 * @param {'y' | 'z'} up the axis of the mesh that points upwards
 * @param {Colours | null} [colours]
 * @returns {ArrayBuffer}
 */
export function glb({ mesh, scale, offset }, name, up, colours = null) {
  const positions = turnedAll(mesh.positions, up, scale);
  const normals = turnedAll(mesh.normals, up, 1);
  const count = positions.length / 3;
  const vertices = { bufferView: 0, componentType: FLOAT, count, type: 'VEC3' };
  const arrays = [positions, normals, ...(colours ? [colours] : []), mesh.triangles];
  const indices = arrays.length - 1;
  const json = {
    asset: { version: '2.0', generator: 'umbilic' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0, translation: turned(offset, up) }],
    meshes: [
      {
        name,
        primitives: [
          {
            attributes: { POSITION: 0, NORMAL: 1, ...(colours && { COLOR_0: 2 }) },
            indices,
            material: 0,
          },
        ],
      },
    ],
    materials: [
      {
        doubleSided: true,
        pbrMetallicRoughness: {
          baseColorFactor: colours ? [1, 1, 1, 1] : PLAIN,
          metallicFactor: 0,
          roughnessFactor: 0.5,
        },
      },
    ],
    accessors: [
      { ...vertices, ...bounds(positions) },
      { ...vertices, bufferView: 1 },
      ...(colours ? [{ bufferView: 2, componentType: UINT16, normalized: true, count, type: 'VEC4' }] : []),
      { bufferView: indices, componentType: UINT32, count: mesh.triangles.length, type: 'SCALAR' },
    ],
    ...buffersOf(arrays, indices),
  };
  return assembled(new TextEncoder().encode(JSON.stringify(json)), arrays);
}

/** @typedef {Float32Array | Uint16Array | Uint32Array} Column of numbers, whose length in bytes is a multiple of 4 */

/** @param {Column[]} arrays @param {number} indices the number of the array of indices */
function buffersOf(arrays, indices) {
  let byteOffset = 0;
  const bufferViews = arrays.map(({ byteLength }, i) => {
    const target = i === indices ? ELEMENT_ARRAY_BUFFER : ARRAY_BUFFER;
    const view = { buffer: 0, byteOffset, byteLength, target };
    byteOffset += byteLength;
    return view;
  });
  return { bufferViews, buffers: [{ byteLength: byteOffset }] };
}

/** @param {Uint8Array} json @param {Column[]} arrays @returns {ArrayBuffer} the header and the two chunks of the file */
function assembled(json, arrays) {
  const padded = Math.ceil(json.length / 4) * 4;
  const binary = arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
  const bytes = new Uint8Array(12 + 8 + padded + 8 + binary);
  const file = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, padded, JSON_CHUNK].forEach((word, i) => file.setUint32(4 * i, word, true));
  bytes.fill(0x20, 20, 20 + padded);
  bytes.set(json, 20);
  file.setUint32(20 + padded, binary, true);
  file.setUint32(24 + padded, BINARY_CHUNK, true);
  let at = 28 + padded;
  for (const { buffer, byteOffset, byteLength } of arrays) {
    bytes.set(new Uint8Array(buffer, byteOffset, byteLength), at);
    at += byteLength;
  }
  return bytes.buffer;
}
