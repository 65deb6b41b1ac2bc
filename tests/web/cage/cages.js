// SPDX-License-Identifier: MIT
/** @file Cages for the tests of edits, and what is known of them in closed form. */
import { edgeName, edgesOf, problemOfCage } from '../../../web/cage/polygons.js';

/** @import {Mesh} from '../../../wasm/types.js' */
/** @import {Edited, Point, PolygonCage, Refused} from '../../../web/cage/polygons.js' */

/**
 * The surface of a box of n × n × n cells with side 1 each, from the origin: 6 n² squares, outward.
 * @param {number} n
 * @returns {PolygonCage}
 */
export function box(n) {
  /** @type {Map<string, number>} */
  const numbers = new Map();
  /** @type {Point[]} */
  const points = [];
  /** @param {number[]} at */
  function numberOf(at) {
    const known = numbers.get(at.join());
    if (known !== undefined) return known;
    numbers.set(at.join(), points.length);
    return points.push([at[0], at[1], at[2]]) - 1;
  }
  /** @type {number[][]} */
  const faces = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [0, n]) {
      for (let i = 0; i < n * n; i++) {
        const [u, v] = [i % n, Math.floor(i / n)];
        const square = [
          [u, v],
          [u + 1, v],
          [u + 1, v + 1],
          [u, v + 1],
        ].map(([a, b]) => {
          const at = [0, 0, 0];
          [at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]] = [side, a, b];
          return numberOf(at);
        });
        faces.push(side ? square : square.reverse());
      }
    }
  }
  return { points, faces, groups: [] };
}

/** The face whose corners have this mean. @param {PolygonCage} cage @param {number[]} middle */
export const faceAt = ({ points, faces }, middle) =>
  faces.findIndex((face) =>
    middle.every((x, axis) => Math.abs(face.reduce((sum, v) => sum + points[v][axis], 0) / face.length - x) < 1e-9),
  );

/** @param {PolygonCage} cage @param {number[]} place */
export const pointAt = ({ points }, place) =>
  points.findIndex((point) => point.every((x, axis) => Math.abs(x - place[axis]) < 1e-9));

/** The volume inside a closed cage of flat faces: fans of tetrahedra from the origin. @param {PolygonCage} cage */
export function volume({ points, faces }) {
  let sum = 0;
  for (const face of faces) {
    for (let i = 1; i + 1 < face.length; i++) {
      const [[a, b, c], [d, e, f], [g, h, k]] = [face[0], face[i], face[i + 1]].map((v) => points[v]);
      sum += (a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g)) / 6;
    }
  }
  return sum;
}

/** Whether every edge has two faces that run along it in opposite directions. @param {PolygonCage} cage */
export function isClosed({ faces }) {
  const edges = faces.flatMap(edgesOf).map(([from, to]) => edgeName(from, to));
  const known = new Set(edges);
  return known.size === edges.length && faces.flatMap(edgesOf).every(([from, to]) => known.has(edgeName(to, from)));
}

/** What an edit made, which must be a cage. @param {Edited | Refused} made @returns {Edited} */
export function done(made) {
  if ('refused' in made) throw new Error(made.refused);
  const problem = problemOfCage(made.cage);
  if (problem) throw new Error(problem);
  if (made.pointOrigins.length !== made.cage.points.length) throw new Error('not one origin for each point');
  if (made.faceOrigins.length !== made.cage.faces.length) throw new Error('not one origin for each face');
  return made;
}

/** @param {Edited | PolygonCage | Refused | null} made @returns {string} the sentence of a refusal */
export const refusal = (made) => (made && 'refused' in made ? made.refused : 'it was not refused');

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
 * The cage that a mesh of the core stands for, which is to be that of its text.
 * @param {Pick<Mesh, 'centre' | 'positions' | 'triangles' | 'faces'>} mesh of a cage, each face a fan of triangles
 * @returns {PolygonCage}
 */
export function cageOfMesh({ centre, positions, triangles, faces: owners }) {
  /** @type {Point[]} */
  const points = [];
  for (let i = 0; i < positions.length; i += 3) {
    points.push([positions[i] + centre[0], positions[i + 1] + centre[1], positions[i + 2] + centre[2]]);
  }
  /** @type {number[][]} */
  const corners = [];
  owners.forEach((face, t) => (corners[face] ??= []).push(...triangles.subarray(3 * t, 3 * t + 3)));
  const faces = Array.from(corners, (own) => outline(own ?? []));
  const cage = { points, faces, groups: [] };
  const problem = problemOfCage(cage);
  if (problem) throw new Error(problem);
  return cage;
}
