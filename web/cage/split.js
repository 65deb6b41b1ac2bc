// SPDX-License-Identifier: MIT
/** @file Splits a strip of quads along its middle, by a ring of new edges across the edges that it consists of. */
import { accepted, copied, edgeName, edgesOf, refuse } from './polygons.js';
import { edgeOf, ringThrough } from './select.js';

/** @import {Edited, Point, PolygonCage, Refused, Selection} from './polygons.js' */

/** The corners of a face with a new one on each edge that has one. @param {number[]} face @param {Map<string, number>} middles */
const withMiddles = (face, middles) =>
  edgesOf(face).flatMap(([from, to]) => {
    const middle = middles.get(edgeName(from, to)) ?? middles.get(edgeName(to, from));
    return middle === undefined ? [from] : [from, middle];
  });

/** The two parts of a quad that has new corners on two opposite edges. @param {number[]} corners six @param {number} first a new one */
function halves(corners, first) {
  const i = corners.indexOf(first);
  const turned = [...corners.slice(i), ...corners.slice(0, i)];
  return [turned.slice(0, 4), [...turned.slice(3), turned[0]]];
}

/**
 * Puts a ring of edges through the strip of quads that the chosen edge crosses: two points with an edge between them, or the
 * edge between two faces. Where the strip ends at a face of another size, that gets a corner more.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @param {number} [part] where on each edge the new points are, between 0 and 1
 * @returns {Edited | Refused}
 */
export function split(cage, selection, part = 0.5) {
  const edge = edgeOf(cage, selection);
  if (!edge) return refuse('Select two vertices with an edge between them, or two faces that share one, to split.');
  if (!(part > 0 && part < 1)) return refuse('The part is a number between 0 and 1.');
  const strip = ringThrough(cage.faces, edge);
  if (!strip.faces.length) return refuse('No face with four corners has this edge.');
  const crossed = strip.faces.find((f, i) => strip.faces.indexOf(f) < i);
  if (crossed !== undefined) return refuse(`The strip crosses itself in face ${crossed + 1}.`);
  const { points, pointOrigins } = copied(cage);
  /** @type {Map<string, number>} */
  const middles = new Map();
  for (const [from, to] of strip.edges) {
    middles.set(edgeName(from, to), points.length);
    points.push(
      /** @type {Point} */ (cage.points[from].map((x, axis) => (1 - part) * x + part * cage.points[to][axis])),
    );
    pointOrigins.push(-1);
  }
  const fresh = [...middles.values()];
  const own = new Set(strip.faces);
  const faces = cage.faces.map((face) => withMiddles(face, middles));
  const faceOrigins = [...faces.keys()];
  const like = [...faces.keys()];
  for (const f of own) {
    const first = faces[f].find((v) => v >= cage.points.length) ?? -1;
    const [kept, added] = halves(faces[f], first);
    faces[f] = kept;
    faces.push(added);
    faceOrigins.push(-1);
    like.push(f);
  }
  // A face of other size that got a corner is not what it was; neither is a half.
  cage.faces.forEach((face, f) => (own.has(f) || faces[f].length > face.length) && (faceOrigins[f] = -1));
  return accepted(cage, { points, pointOrigins, faces, faceOrigins, like, selected: { points: fresh, faces: [] } });
}
