// SPDX-License-Identifier: MIT
/** @file Which points and faces of a cage belong to a selection, and how it grows. */
import { edgeName, edgesOf, facesByEdge } from './polygons.js';

/** @import {PolygonCage, Selection} from './polygons.js' */

/** @param {Iterable<number>} numbers */
const ascending = (numbers) => [...new Set(numbers)].sort((a, b) => a - b);

/** The points that a move takes along: those chosen, and the corners of the faces chosen. @param {PolygonCage} cage @param {Selection} selection */
export const movedPoints = ({ faces }, { points, faces: chosen }) =>
  ascending([...points, ...chosen.flatMap((f) => faces[f])]);

/** Without numbers that the cage does not have. @param {PolygonCage} cage @param {Selection} selection @returns {Selection} */
export const within = ({ points, faces }, selection) => ({
  points: ascending(selection.points.filter((v) => v in points)),
  faces: ascending(selection.faces.filter((f) => f in faces)),
});

/**
 * With the faces that share a point with one that is chosen, and the points that share an edge with one.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @returns {Selection}
 */
export function grown({ faces }, { points, faces: chosen }) {
  const near = new Set(chosen.flatMap((f) => faces[f]));
  const own = new Set(points);
  const more = faces.flatMap(edgesOf).filter(([from, to]) => own.has(from) || own.has(to));
  return {
    points: ascending([...points, ...more.flat()]),
    faces: ascending([...chosen, ...[...faces.keys()].filter((f) => faces[f].some((v) => near.has(v)))]),
  };
}

/** The edge opposite in a face of four corners, as the face on its other side runs along it. @param {number[]} face @param {number} from a corner of it */
function across(face, from) {
  const i = face.indexOf(from);
  return /** @type {[number, number]} */ ([face[(i + 3) % 4], face[(i + 2) % 4]]);
}

/**
 * The edges that a ring crosses, from one edge through faces of four corners on both sides until it closes or ends. All
 * edges point to the same side of the ring.
 * @param {number[][]} faces
 * @param {[number, number]} edge
 * @returns {{edges: Array<[number, number]>, faces: number[]}}
 */
export function ringThrough(faces, edge) {
  const owners = facesByEdge(faces);
  /** @type {Array<[number, number]>} */
  const edges = [edge];
  /** @type {number[]} */
  const strip = [];
  /** @param {[number, number]} start @param {(edge: [number, number]) => [number, number]} turned @param {(one: [number, number]) => void} add */
  function walk(start, turned, add) {
    for (let at = start; ;) {
      const [from, to] = turned(at);
      const f = owners.get(edgeName(from, to));
      if (f === undefined || faces[f].length !== 4) return false;
      strip.push(f);
      const next = across(faces[f], from);
      at = turned(next);
      if (edgeName(...at) === edgeName(...start)) return true;
      add(at);
    }
  }
  const closed = walk(
    edge,
    (one) => one,
    (one) => edges.push(one),
  );
  if (!closed) {
    walk(
      edge,
      ([from, to]) => [to, from],
      (one) => edges.unshift(one),
    );
  }
  return { edges, faces: strip };
}

/** The edge that two faces share, as the first runs along it. @param {number[][]} faces @param {number} one @param {number} other @returns {[number, number] | null} */
export function sharedEdge(faces, one, other) {
  const theirs = new Set(edgesOf(faces[other]).map(([from, to]) => edgeName(to, from)));
  return edgesOf(faces[one]).find((edge) => theirs.has(edgeName(...edge))) ?? null;
}

/** The edge that a selection names: by its two ends, or as that between two faces. @param {PolygonCage} cage @param {Selection} selection @returns {[number, number] | null} */
export function edgeOf({ faces }, { points, faces: chosen }) {
  if (chosen.length === 2 && !points.length) return sharedEdge(faces, chosen[0], chosen[1]);
  if (points.length !== 2 || chosen.length) return null;
  const [a, b] = points;
  const owners = facesByEdge(faces);
  if (owners.has(edgeName(a, b))) return [a, b];
  return owners.has(edgeName(b, a)) ? [b, a] : null;
}

/**
 * The line of edges that goes straight on from an edge on both sides, over points at which four faces meet.
 * @param {number[][]} faces
 * @param {[number, number]} edge
 */
function lineThrough(faces, edge) {
  const owners = facesByEdge(faces);
  const valences = new Map();
  for (const v of faces.flat()) valences.set(v, (valences.get(v) ?? 0) + 1);
  /** The edge straight ahead over four faces: the one after next around the point. @param {[number, number]} at @returns {[number, number] | null} */
  function ahead([from, to]) {
    if (valences.get(to) !== 4) return null;
    let came = from;
    for (let i = 0; i < 2; i++) {
      const face = faces[owners.get(edgeName(came, to)) ?? -1];
      if (!face) return null;
      came = face[(face.indexOf(to) + 1) % face.length];
    }
    return [to, came];
  }
  const line = new Set(edge);
  for (const start of [edge, /** @type {[number, number]} */ ([edge[1], edge[0]])]) {
    for (let at = ahead(start); at && !line.has(at[1]); at = ahead(at)) line.add(at[1]);
  }
  return [...line];
}

/**
 * The strip of faces that two adjacent faces begin, or the line of edges that two adjacent points begin.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @returns {Selection | null} null if it begins neither
 */
export function looped(cage, selection) {
  const edge = edgeOf(cage, selection);
  if (!edge) return null;
  if (selection.points.length) return { points: ascending(lineThrough(cage.faces, edge)), faces: [] };
  const { faces } = ringThrough(cage.faces, edge);
  return faces.length ? { points: [], faces: ascending(faces) } : null;
}
