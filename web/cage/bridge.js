// SPDX-License-Identifier: MIT
/** @file Joins two faces, or two boundaries, by a tube of quads. */
import { accepted, boundaryLoops, copied, distance, refuse } from './polygons.js';

/** @import {Edited, PolygonCage, Refused, Selection} from './polygons.js' */

/** The rings of corners to join, and the faces that they close now. @typedef {{rings: [number[], number[]], closed: number[]}} Ends */

/** @param {PolygonCage} cage @param {Selection} selection @returns {Ends | Refused} */
function endsOf({ faces }, { points, faces: chosen }) {
  if (chosen.length) {
    if (chosen.length !== 2) return refuse('Select two faces to bridge, or points of two boundaries.');
    return { rings: [faces[chosen[0]], faces[chosen[1]]], closed: chosen };
  }
  const own = new Set(points);
  const loops = boundaryLoops(faces).filter((loop) => loop.some((v) => own.has(v)));
  if (loops.length !== 2) return refuse('Select two faces to bridge, or points of two boundaries.');
  return { rings: [loops[0], loops[1]], closed: [] };
}

/**
 * How far the second ring is turned where the edges that join the two are shortest: corner i of the first is joined to corner
 * turn - i of the second, which runs the other way.
 * @param {PolygonCage['points']} points
 * @param {[number[], number[]]} rings
 */
function shortestTurn(points, [one, other]) {
  const lengths = other.map((_, turn) =>
    one.reduce((sum, v, i) => sum + distance(points[v], points[other.at((turn - i) % other.length) ?? v]) ** 2, 0),
  );
  return lengths.indexOf(Math.min(...lengths));
}

/**
 * Takes away two faces, or takes two boundaries, of as many corners each, and joins them by quads.
 * @param {PolygonCage} cage
 * @param {Selection} selection
 * @returns {Edited | Refused}
 */
export function bridge(cage, selection) {
  const ends = endsOf(cage, selection);
  if ('refused' in ends) return ends;
  const { rings, closed } = ends;
  const [one, other] = rings;
  if (one.length !== other.length) return refuse(`One has ${one.length} corners, the other ${other.length}.`);
  const shared = one.find((v) => other.includes(v));
  if (shared !== undefined) return refuse(`Both have vertex ${shared + 1}; only ones apart can be bridged.`);
  const turn = shortestTurn(cage.points, rings);
  const partner = one.map((_, i) => /** @type {number} */ (other.at((turn - i) % other.length)));
  const joined = one.findIndex((v, i) =>
    cage.faces.some((face) => {
      const at = face.indexOf(v);
      return at >= 0 && [face.at(at - 1), face[(at + 1) % face.length]].includes(partner[i]);
    }),
  );
  if (joined >= 0) {
    const names = `${one[joined] + 1} and ${partner[joined] + 1}`;
    return refuse(
      `An edge joins vertices ${names} already, so that the tube would touch the surface. Split or extrude first.`,
    );
  }
  const kept = [...cage.faces.keys()].filter((f) => !closed.includes(f));
  const quads = one.map((v, i) => {
    const next = (i + 1) % one.length;
    return [v, one[next], partner[next], partner[i]];
  });
  const faceOrigins = [...kept, ...quads.map(() => -1)];
  return accepted(cage, {
    ...copied(cage),
    faces: [...kept.map((f) => cage.faces[f]), ...quads],
    faceOrigins,
    like: faceOrigins,
    selected: { points: [], faces: quads.map((_, i) => kept.length + i) },
  });
}
