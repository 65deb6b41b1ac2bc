// SPDX-License-Identifier: MIT
/**
 * @file The curves in which a plane cuts a triangle mesh, and their curvature.
 *
 * The normal of such a curve within the plane is the projection of the surface's normal, which the mesh has from the limit
 * surface itself. The curvature is how far that normal turns per length, so only first differences are taken, over a window of
 * some triangles. It is positive where the curve bends away from the outward normal, as a circle does; by Meusnier it is the
 * surface's normal curvature divided by the cosine between both normals.
 */

/** @import {Mesh} from '../../wasm/types.js' */

/** @typedef {[number, number, number]} Triple */
/** The points x with normal · x = offset; the normal has length 1. @typedef {{normal: Triple, offset: number}} Plane */

/**
 * Points in order, with the outward normals of length 1 in the plane. Seen with the plane's normal towards the viewer, the
 * inside is on the left. A closed curve does not repeat its first point.
 * @typedef {{points: Triple[], normals: Triple[], closed: boolean}} Curve
 */

/** Points of a curve at equal distances, with normals and curvatures. @typedef {Curve & {curvatures: number[]}} Comb */

/** The length over which the normal's turn is measured, in segments of the curve on average. */
const WINDOW = 4;

/** @param {Triple} a @param {Triple} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Triple} a @param {Triple} b @param {number} t @returns {Triple} */
const between = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
/** @param {Triple} a @param {Triple} b @returns {Triple} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Triple} a @returns {Triple} */
function unit(a) {
  const length = Math.hypot(...a);
  return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : a;
}

/**
 * The plane across a direction of length 1, from the end of the mesh against it (-1) to the one along it (1).
 * @param {Pick<Mesh, 'positions'>} mesh
 * @param {Triple} direction
 * @param {number} position
 * @returns {Plane}
 */
export function planeAcross({ positions }, direction, position) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const height = dot(direction, [positions[i], positions[i + 1], positions[i + 2]]);
    low = Math.min(low, height);
    high = Math.max(high, height);
  }
  return { normal: direction, offset: (low + high) / 2 + (position * (high - low)) / 2 };
}

/**
 * @param {Pick<Mesh, 'positions' | 'normals' | 'triangles'>} mesh
 * @param {Plane} plane in the mesh's own coordinates
 * @returns {Curve[]}
 */
export function sectionOf({ positions, normals, triangles }, { normal, offset }) {
  const count = positions.length / 3;
  /** @param {Float32Array} array @param {number} vertex @returns {Triple} */
  const row = (array, vertex) => [array[3 * vertex], array[3 * vertex + 1], array[3 * vertex + 2]];
  // A vertex in the plane counts as above it, so that each triangle is cut in a segment or not at all.
  const heights = Float64Array.from({ length: count }, (_, vertex) => dot(normal, row(positions, vertex)) - offset);
  const next = segmentsOf(triangles, heights);

  /** The point of an edge that is cut. @param {number} edge */
  function pointOf(edge) {
    const [a, b] = [Math.floor(edge / count), edge % count];
    const t = heights[a] / (heights[a] - heights[b]);
    const n = between(row(normals, a), row(normals, b), t);
    const along = dot(n, normal);
    const inPlane = unit([n[0] - along * normal[0], n[1] - along * normal[1], n[2] - along * normal[2]]);
    return { point: between(row(positions, a), row(positions, b), t), normal: inPlane };
  }

  /** @param {number} first @returns {Curve} the curve from an edge on, whose segments are taken away */
  function follow(first) {
    const edges = [first];
    let edge = next.get(first);
    for (let from = first; edge !== undefined; edge = next.get(from)) {
      next.delete(from);
      if (edge === first) break;
      edges.push(edge);
      from = edge;
    }
    const found = edges.map(pointOf);
    return {
      points: found.map((one) => one.point),
      normals: found.map((one) => one.normal),
      closed: edge === first,
    };
  }

  const reached = new Set(next.values());
  const starts = [...next.keys()].filter((edge) => !reached.has(edge));
  const curves = starts.map(follow); // open ones first, from their beginnings
  for (const edge of next.keys()) if (next.has(edge)) curves.push(follow(edge));
  return curves;
}

/**
 * From each edge that is cut to the next one of its curve. An edge is the number lower vertex * vertices + higher vertex. A
 * triangle, counterclockwise from outside, is entered through its edge that leads down and left through the one that leads up.
 * @param {Uint32Array} triangles
 * @param {Float64Array} heights of the vertices above the plane
 * @returns {Map<number, number>}
 */
function segmentsOf(triangles, heights) {
  const next = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    let [entry, exit] = [-1, -1];
    for (let i = 0; i < 3; i++) {
      const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
      const [above, ends] = [heights[a] >= 0, heights[b] >= 0];
      if (above === ends) continue;
      const edge = Math.min(a, b) * heights.length + Math.max(a, b);
      if (above) entry = edge;
      else exit = edge;
    }
    if (entry >= 0) next.set(entry, exit);
  }
  return next;
}

/**
 * A curve's curvature at about `count` points of equal distance.
 * @param {Curve} curve
 * @param {Triple} normal of the plane
 * @param {number} count at least 2
 * @returns {Comb}
 */
export function combOf(curve, normal, count) {
  const { closed } = curve;
  const { lengths, angles } = unrolled(curve, normal);
  const whole = lengths[lengths.length - 1];
  const turn = angles[angles.length - 1] - angles[0];
  /** The number of a point at a length, and the fraction to the next one. @param {number} s */
  function place(s) {
    let [low, high] = [0, lengths.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (lengths[middle] <= s) low = middle;
      else high = middle;
    }
    const step = lengths[high] - lengths[low];
    return { i: low, t: step > 0 ? Math.min(1, Math.max(0, (s - lengths[low]) / step)) : 0 };
  }
  /** @param {number} s also beyond the ends of a closed curve */
  function angleAt(s) {
    const rounds = closed ? Math.floor(s / whole) : 0;
    const { i, t } = place(s - rounds * whole);
    return angles[i] + t * (angles[i + 1] - angles[i]) + rounds * turn;
  }
  const window = Math.min(whole / 4, (WINDOW * whole) / (lengths.length - 1));
  const teeth = closed ? count : count - 1;
  /** @type {Comb} */
  const comb = { points: [], normals: [], curvatures: [], closed };
  if (!(whole > 0)) return comb;
  for (let k = 0; k < count; k++) {
    const s = (whole * k) / teeth;
    const { i, t } = place(s);
    const j = (i + 1) % curve.points.length;
    const [from, to] = closed
      ? [s - window / 2, s + window / 2]
      : [Math.max(0, s - window / 2), Math.min(whole, s + window / 2)];
    comb.points.push(between(curve.points[i], curve.points[j], t));
    comb.normals.push(unit(between(curve.normals[i], curve.normals[j], t)));
    comb.curvatures.push((angleAt(to) - angleAt(from)) / (to - from));
  }
  return comb;
}

/**
 * The lengths up to each point and the angles of the normals there, without jumps; a closed curve's first point again at the end.
 * @param {Curve} curve
 * @param {Triple} normal
 */
function unrolled({ points, normals, closed }, normal) {
  const first = unit(cross(normal, Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
  const second = cross(normal, first);
  const count = points.length + (closed ? 1 : 0);
  const [lengths, angles] = [new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < count; i++) {
    const at = i % points.length;
    const angle = Math.atan2(dot(normals[at], second), dot(normals[at], first));
    const before = i > 0 ? angles[i - 1] : angle;
    angles[i] = angle + 2 * Math.PI * Math.round((before - angle) / (2 * Math.PI));
    const [a, b] = [points[Math.max(0, i - 1)], points[at]];
    lengths[i] = i > 0 ? lengths[i - 1] + Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : 0;
  }
  return { lengths, angles };
}
