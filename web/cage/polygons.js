// SPDX-License-Identifier: MIT
/**
 * @file A control cage as a polygon mesh, and whether it is one that can be subdivided: what an edit begins with, and what
 * its result is checked against. Pure, as all of cage/.
 */

/** @typedef {[number, number, number]} Point */

/**
 * The corners of each face are numbers of points, from 0, counterclockwise as seen from outside. The faces of a group are
 * numbers from 0, ascending; a face may be in several groups.
 * @typedef {object} PolygonCage
 * @property {Point[]} points
 * @property {number[][]} faces
 * @property {Array<{name: string, faces: number[]}>} groups
 */

/** Points and faces that are chosen, by their numbers from 0, ascending. @typedef {{points: number[], faces: number[]}} Selection */

/**
 * What an edit makes. `pointOrigins` and `faceOrigins` have for each point and face the one of the cage before that it is, or
 * -1 if it is new; `selected` is what to choose next.
 * @typedef {object} Edited
 * @property {PolygonCage} cage
 * @property {number[]} pointOrigins
 * @property {number[]} faceOrigins
 * @property {Selection} selected
 */

/** Why an edit is impossible, in a sentence. Numbers in it count from 1, as in files. @typedef {{refused: string}} Refused */

/** The area vector of a face relative to the square of its perimeter below which it has no area. */
const NO_AREA = 1e-12;

/** @param {string} sentence @returns {Refused} */
export const refuse = (sentence) => ({ refused: sentence });

/** The name of a directed edge. @param {number} from @param {number} to */
export const edgeName = (from, to) => `${from} ${to}`;

/** The directed edges of a face. @param {number[]} face @returns {Array<[number, number]>} */
export const edgesOf = (face) => face.map((from, i) => [from, face[(i + 1) % face.length]]);

/** The face to which each directed edge belongs. @param {number[][]} faces @returns {Map<string, number>} */
export function facesByEdge(faces) {
  /** @type {Map<string, number>} */
  const owners = new Map();
  faces.forEach((face, f) => edgesOf(face).forEach(([from, to]) => owners.set(edgeName(from, to), f)));
  return owners;
}

/**
 * The boundaries, each as the corners of the face that would close it.
 * @param {number[][]} faces
 * @returns {number[][]}
 */
export function boundaryLoops(faces) {
  const owners = facesByEdge(faces);
  /** @type {Map<number, number>} */
  const next = new Map();
  for (const face of faces) {
    for (const [from, to] of edgesOf(face)) if (!owners.has(edgeName(to, from))) next.set(to, from);
  }
  const loops = [];
  for (const first of next.keys()) {
    const loop = [];
    for (let at = /** @type {number | undefined} */ (first); at !== undefined && next.has(at);) {
      loop.push(at);
      const to = next.get(at);
      next.delete(at);
      at = to;
    }
    if (loop.length) loops.push(loop);
  }
  return loops;
}

/** Vertices - edges + faces. Points that no face has do not count. @param {PolygonCage} cage */
export function eulerCharacteristic({ faces }) {
  const edges = new Set(
    faces.flatMap((face) => edgesOf(face).map(([a, b]) => edgeName(Math.min(a, b), Math.max(a, b)))),
  );
  return new Set(faces.flat()).size - edges.size + faces.length;
}

/**
 * The vector normal to a face that is as long as the face is large; of one that is not flat, the mean over all planes. Newell's
 * formula.
 * @param {Point[]} points
 * @param {number[]} face
 * @returns {Point}
 */
export function areaVector(points, face) {
  /** @type {Point} */
  const sum = [0, 0, 0];
  const [ox, oy, oz] = points[face[0]]; // near the face, so that one far from the origin keeps its digits
  for (const [from, to] of edgesOf(face)) {
    const [ax, ay, az] = [points[from][0] - ox, points[from][1] - oy, points[from][2] - oz];
    const [bx, by, bz] = [points[to][0] - ox, points[to][1] - oy, points[to][2] - oz];
    sum[0] += (ay * bz - az * by) / 2;
    sum[1] += (az * bx - ax * bz) / 2;
    sum[2] += (ax * by - ay * bx) / 2;
  }
  return sum;
}

/** The mean of some points. @param {Point[]} points @param {number[]} chosen @returns {Point} */
export function middleOf(points, chosen) {
  /** @type {Point} */
  const sum = [0, 0, 0];
  for (const v of chosen) points[v].forEach((x, axis) => (sum[axis] += x / chosen.length));
  return sum;
}

/** @param {Point} one @param {Point} other */
export const distance = (one, other) => Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);

/** @param {PolygonCage} cage @param {number} f @returns {string | null} */
function problemOfFace({ points, faces }, f) {
  const face = faces[f];
  if (face.length < 3) return `Face ${f + 1} would have ${face.length} corners.`;
  if (new Set(face).size < face.length) return `Face ${f + 1} would have a vertex twice.`;
  const outside = face.find((v) => !points[v]);
  if (outside !== undefined) return `Face ${f + 1} names vertex ${outside + 1}, which does not exist.`;
  const perimeter = edgesOf(face).reduce((sum, [from, to]) => sum + distance(points[from], points[to]), 0);
  if (!(Math.hypot(...areaVector(points, face)) > NO_AREA * perimeter ** 2)) return `Face ${f + 1} would have no area.`;
  return null;
}

/**
 * A vertex whose faces do not form one fan, each sharing an edge at the vertex with the next one.
 * @param {number[][]} faces
 * @returns {number} from 0; -1 if there is none
 */
function pinchedVertex(faces) {
  /** For each vertex from the corner before it in a face to the one after. @type {Map<number, Map<number, number>>} */
  const around = new Map();
  for (const face of faces) {
    face.forEach((v, i) => {
      const turns = around.get(v) ?? new Map();
      around.set(v, turns.set(face.at(i - 1), face[(i + 1) % face.length]));
    });
  }
  for (const [v, turns] of around) {
    // One fan is one path or one cycle of turns.
    const targets = new Set(turns.values());
    const first = [...turns.keys()].find((corner) => !targets.has(corner)) ?? [...turns.keys()][0];
    let [at, seen] = [first, 0];
    do {
      at = turns.get(at) ?? -1;
      seen++;
    } while (at !== first && turns.has(at));
    if (seen < turns.size) return v;
  }
  return -1;
}

/**
 * Says what keeps a cage from being an oriented surface with or without boundary.
 * @param {PolygonCage} cage
 * @returns {string | null} a sentence; null if it is one
 */
export function problemOfCage(cage) {
  const { points, faces } = cage;
  if (!faces.length) return 'No face would be left.';
  const lost = points.findIndex((point) => !point.every(Number.isFinite));
  if (lost >= 0) return `Vertex ${lost + 1} would have no place.`;
  for (let f = 0; f < faces.length; f++) {
    const problem = problemOfFace(cage, f);
    if (problem) return problem;
  }
  /** @type {Set<string>} */
  const known = new Set();
  for (const [from, to] of faces.flatMap(edgesOf)) {
    if (known.has(edgeName(from, to))) {
      return `More than two faces would meet at the edge between vertices ${from + 1} and ${to + 1}.`;
    }
    known.add(edgeName(from, to));
  }
  const pinched = pinchedVertex(faces);
  return pinched < 0 ? null : `The surface would touch itself at vertex ${pinched + 1}.`;
}

/**
 * A cage whose faces are given by origin: drops points that no face has, and checks what is left.
 * @param {PolygonCage} before gives the groups
 * @param {{points: Point[], pointOrigins: number[], faces: number[][], faceOrigins: number[], like: number[],
 *   selected: Selection}} made `like` has for each face the one before whose groups it joins, or -1
 * @returns {Edited | Refused}
 */
export function accepted(before, { points, pointOrigins, faces, faceOrigins, like, selected }) {
  const used = new Set(faces.flat());
  const kept = points.map((_, v) => v).filter((v) => used.has(v));
  const renumbered = new Map(kept.map((v, i) => [v, i]));
  /** @param {number[]} chosen */
  const renumber = (chosen) => chosen.flatMap((v) => renumbered.get(v) ?? []);
  const cage = {
    points: kept.map((v) => points[v]),
    faces: faces.map(renumber),
    groups: before.groups.flatMap(({ name, faces: members }) => {
      const own = new Set(members);
      const now = [...faces.keys()].filter((f) => own.has(like[f]));
      return now.length ? [{ name, faces: now }] : [];
    }),
  };
  const problem = problemOfCage(cage);
  if (problem) return refuse(problem);
  const chosen = { points: renumber(selected.points), faces: selected.faces };
  return { cage, pointOrigins: kept.map((v) => pointOrigins[v]), faceOrigins, selected: chosen };
}

/** The points of a cage as an edit begins with them. @param {PolygonCage} cage */
export const copied = ({ points }) => ({
  points: points.map((point) => /** @type {Point} */ ([...point])),
  pointOrigins: points.map((_, v) => v),
});
