// SPDX-License-Identifier: MIT
/** @file The polygon cage that a triangle mesh stands for, whose triangles tell the face of the cage that they belong to. */
import { edgeName, problemOfCage, refuse } from './polygons.js';

/** @import {FaceGroup, Mesh} from '../../wasm/types.js' */
/** @import {Point, PolygonCage, Refused} from './polygons.js' */

/** The corners of the polygon that triangles cover: the cycle of the edges that only one of them has. @param {number[]} corners 3 of each */
function outline(corners) {
  /** @type {Map<string, [number, number]>} */
  const edges = new Map();
  corners.forEach((from, i) => {
    const to = corners[i % 3 === 2 ? i - 2 : i + 1];
    if (!edges.delete(edgeName(to, from))) edges.set(edgeName(from, to), [from, to]);
  });
  const next = new Map(edges.values());
  const face = [];
  for (let at = corners[0]; next.has(at);) {
    face.push(at);
    const to = /** @type {number} */ (next.get(at));
    next.delete(at);
    at = to;
  }
  return face;
}

/**
 * @param {Pick<Mesh, 'centre' | 'positions' | 'triangles' | 'faces'>} mesh of a cage, each face a fan of triangles
 * @param {FaceGroup[]} [groups] whose faces count from 1
 * @returns {PolygonCage | Refused}
 */
export function cageOfMesh({ centre, positions, triangles, faces: owners }, groups = []) {
  /** @type {Point[]} */
  const points = [];
  for (let i = 0; i < positions.length; i += 3) {
    points.push([positions[i] + centre[0], positions[i + 1] + centre[1], positions[i + 2] + centre[2]]);
  }
  /** @type {number[][]} */
  const corners = [];
  owners.forEach((face, t) => (corners[face] ??= []).push(...triangles.subarray(3 * t, 3 * t + 3)));
  const faces = Array.from(corners, (own) => outline(own ?? []));
  const cage = { points, faces, groups: groups.map((group) => ({ ...group, faces: group.faces.map((f) => f - 1) })) };
  const problem = problemOfCage(cage);
  return problem ? refuse(problem) : cage;
}
