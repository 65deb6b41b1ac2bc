// SPDX-License-Identifier: MIT
/** @file Makes a cage symmetric: keeps its part on one side of a coordinate plane, and adds the image of that. */
import { accepted, copied, refuse } from './polygons.js';

/** @import {Edited, Point, PolygonCage, Refused} from './polygons.js' */

/** How near to the plane points are welded, as a part of the longest side of the cage. */
const NEAR = 1e-6;

/** @param {Point[]} points */
function longestSide(points) {
  const sides = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return values.reduce((a, b) => Math.max(a, b), -Infinity) - values.reduce((a, b) => Math.min(a, b), Infinity);
  });
  return Math.max(...sides);
}

/**
 * Points near the plane are put on it and shared by both parts; faces on it are taken away, since they would lie inside.
 * @param {PolygonCage} cage
 * @param {0 | 1 | 2} axis normal to the plane, which goes through the origin
 * @param {1 | -1} side that is kept
 * @param {number} [tolerance] how near to the plane a point counts as on it
 * @returns {Edited | Refused}
 */
export function mirror(cage, axis, side, tolerance = NEAR * longestSide(cage.points)) {
  const name = 'xyz'[axis];
  const { points, pointOrigins } = copied(cage);
  const sides = cage.points.map((point) => (Math.abs(point[axis]) <= tolerance ? 0 : Math.sign(side * point[axis])));
  const crossing = cage.faces.findIndex((face) => face.some((v) => sides[v] > 0) && face.some((v) => sides[v] < 0));
  if (crossing >= 0) {
    return refuse(`Face ${crossing + 1} lies on both sides of the plane ${name} = 0. Split it there, or delete it.`);
  }
  const kept = [...cage.faces.keys()].filter((f) => cage.faces[f].some((v) => sides[v] > 0));
  if (!kept.length) return refuse(`No face lies on that side of the plane ${name} = 0.`);
  const images = sides.map((at, v) => {
    if (at === 0) {
      points[v][axis] = 0;
      return v;
    }
    pointOrigins.push(-1);
    return points.push(/** @type {Point} */ (cage.points[v].map((x, i) => (i === axis ? -x : x)))) - 1;
  });
  const mirrored = kept.map((f) => cage.faces[f].map((v) => images[v]).reverse());
  return accepted(cage, {
    points,
    pointOrigins,
    faces: [...kept.map((f) => cage.faces[f]), ...mirrored],
    faceOrigins: [...kept, ...kept.map(() => -1)],
    like: [...kept, ...kept],
    selected: { points: [], faces: [] },
  });
}
