// SPDX-License-Identifier: MIT
/** @file Edits of a cage that need no other part of it: points moved, faces pushed out, faces taken away. */
import { accepted, areaVector, copied, edgeName, edgesOf, refuse } from './polygons.js';
import { movedPoints } from './select.js';

/** @import {Edited, Point, PolygonCage, Refused, Selection} from './polygons.js' */

/**
 * Moves the chosen points and the corners of the chosen faces by a vector.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @param {Point} by
 * @returns {Edited | Refused}
 */
export function move(cage, selection, by) {
  const moved = movedPoints(cage, selection);
  if (!moved.length) return refuse('Nothing is selected to move.');
  const made = copied(cage);
  for (const v of moved) made.points[v] = /** @type {Point} */ (cage.points[v].map((x, axis) => x + by[axis]));
  const same = [...cage.faces.keys()];
  return accepted(cage, { ...made, faces: cage.faces, faceOrigins: same, like: same, selected: selection });
}

/**
 * Takes the chosen faces away, and with them the points that no other face has.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @returns {Edited | Refused}
 */
export function remove(cage, { faces: chosen }) {
  if (!chosen.length) return refuse('Select the faces to delete.');
  const gone = new Set(chosen);
  const kept = [...cage.faces.keys()].filter((f) => !gone.has(f));
  const faces = kept.map((f) => cage.faces[f]);
  return accepted(cage, { ...copied(cage), faces, faceOrigins: kept, like: kept, selected: { points: [], faces: [] } });
}

/** The chosen faces, those together that share edges. @param {number[][]} faces @param {number[]} chosen @returns {number[][]} */
function regionsOf(faces, chosen) {
  const owners = new Map(chosen.flatMap((f) => edgesOf(faces[f]).map(([from, to]) => [edgeName(from, to), f])));
  const left = new Set(chosen);
  const regions = [];
  for (const first of chosen) {
    if (!left.delete(first)) continue;
    const region = [first];
    for (const f of region) {
      for (const [from, to] of edgesOf(faces[f])) {
        const next = owners.get(edgeName(to, from));
        if (next !== undefined && left.delete(next)) region.push(next);
      }
    }
    regions.push(region);
  }
  return regions;
}

/** The unit normal that faces have on average, by area. @param {PolygonCage} cage @param {number[]} region @returns {Point | null} null if they have none */
function averageNormal({ points, faces }, region) {
  /** @type {Point} */
  const sum = [0, 0, 0];
  let area = 0;
  for (const f of region) {
    const vector = areaVector(points, faces[f]);
    area += Math.hypot(...vector);
    vector.forEach((x, axis) => (sum[axis] += x));
  }
  const length = Math.hypot(...sum);
  return length > 1e-9 * area ? /** @type {Point} */ (sum.map((x) => x / length)) : null;
}

/**
 * Pushes each connected set of the chosen faces out along its average normal, and puts quads around it.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @param {number} by how far; inwards if negative
 * @returns {Edited | Refused}
 */
export function extrude(cage, { faces: chosen }, by) {
  if (!chosen.length) return refuse('Select the faces to extrude.');
  if (!Number.isFinite(by) || by === 0) return refuse('The distance is a number other than 0.');
  const { points, pointOrigins } = copied(cage);
  const faces = cage.faces.map((face) => face);
  const faceOrigins = [...faces.keys()];
  const like = [...faces.keys()];
  for (const region of regionsOf(cage.faces, chosen)) {
    const normal = averageNormal(cage, region);
    if (!normal) return refuse(`The faces around face ${region[0] + 1} have no normal on average; select fewer.`);
    const inside = new Set(region.flatMap((f) => edgesOf(cage.faces[f]).map((edge) => edgeName(...edge))));
    const rim = region.flatMap((f) =>
      edgesOf(cage.faces[f])
        .filter(([from, to]) => !inside.has(edgeName(to, from)))
        .map((edge) => ({ f, edge })),
    );
    if (!rim.length) return refuse('A whole part is selected, which has no side to extrude from; select fewer faces.');
    /** The points that stay have a copy that moves. @type {Map<number, number>} */
    const copies = new Map();
    for (const v of new Set(rim.flatMap(({ edge }) => edge))) {
      copies.set(v, points.length);
      points.push([...cage.points[v]]);
      pointOrigins.push(-1);
    }
    /** @param {number} v */
    const top = (v) => copies.get(v) ?? v;
    for (const v of new Set(region.flatMap((f) => cage.faces[f].map(top)))) {
      normal.forEach((x, axis) => (points[v][axis] += by * x));
    }
    for (const f of region) faces[f] = cage.faces[f].map(top);
    for (const { f, edge } of rim) {
      faces.push([edge[0], edge[1], top(edge[1]), top(edge[0])]);
      faceOrigins.push(-1);
      like.push(f);
    }
  }
  return accepted(cage, { points, pointOrigins, faces, faceOrigins, like, selected: { points: [], faces: chosen } });
}
