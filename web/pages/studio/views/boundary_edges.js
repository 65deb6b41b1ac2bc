// SPDX-License-Identifier: MIT
/**
 * @file The edges of the surface that are marked for a boundary of the cage: that boundary, or the rim of what fills it.
 */
import { splitHeld } from '../../../scene/held.js';
import { boundaryLoops } from '../state/loops.js';
import { boundaryOfFile, faceCount } from '../state/taken.js';

/** @import {Mesh} from '../../../../wasm/types.js' */
/** @import {OpenCage, TakenCage} from '../state/types.js' */

/** The faces of the cage that fill a boundary: 1 for each; null if it is open. @param {number} boundary @param {TakenCage | null} taken */
function fillOf(boundary, taken) {
  const name = taken?.fills.find((fill) => fill.boundary === boundary)?.group;
  const group = taken?.groups.find((one) => one.name === name);
  if (!taken || !group) return null;
  const faces = new Uint8Array(faceCount(taken.counts));
  for (const face of group.faces) faces[face - 1] = 1;
  return faces;
}

/** A function that finds the loops of a mesh once, for all that share its triangles. */
export function createBoundaryEdges() {
  /** @type {{triangles: Uint32Array, loops: number[][]} | null} */
  let known = null;

  /**
   * @param {number | null} boundary its number in the file
   * @param {OpenCage | null} cage
   * @param {TakenCage | null} taken
   * @param {Mesh} mesh
   * @returns {Uint32Array} two vertices for each edge
   */
  return (boundary, cage, taken, mesh) => {
    if (boundary === null) return new Uint32Array(0);
    const fill = fillOf(boundary, taken);
    if (fill) return splitHeld(mesh, fill).rim;
    if (known?.triangles !== mesh.triangles) known = { triangles: mesh.triangles, loops: boundaryLoops(mesh) };
    const loop = known.loops.find((_, i) => boundaryOfFile(cage, taken, i + 1) === boundary) ?? [];
    return Uint32Array.from(loop.flatMap((vertex, i) => [vertex, loop[(i + 1) % loop.length]]));
  };
}
