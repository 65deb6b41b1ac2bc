// SPDX-License-Identifier: MIT
/**
 * @file Reads an STL file with a solid modeller that others wrote.
 */
import Module from 'manifold-3d';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

/** @type {Promise<Awaited<ReturnType<typeof Module>>> | undefined} */
let loading;

async function modeller() {
  const solid = await Module();
  solid.setup();
  return solid;
}

/**
 * The solid that the triangles of a file enclose, whose corners with the same coordinates are one. Its `status` says whether
 * the triangles are closed and oriented.
 * @param {ArrayBuffer} file of STL
 */
export async function solidOf(file) {
  const solid = await (loading ??= modeller());
  const corners = new STLLoader().parse(file).getAttribute('position').array;
  /** @type {Map<string, number>} */
  const known = new Map();
  const triVerts = Uint32Array.from({ length: corners.length / 3 }, (_, i) => {
    const key = corners.subarray(3 * i, 3 * i + 3).join(' ');
    if (!known.has(key)) known.set(key, known.size);
    return Number(known.get(key));
  });
  const vertProperties = Float32Array.from([...known.keys()].flatMap((key) => key.split(' ').map(Number)));
  return new solid.Manifold(new solid.Mesh({ numProp: 3, triVerts, vertProperties }));
}
