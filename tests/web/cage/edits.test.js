// SPDX-License-Identifier: MIT
/** @file Edits of polygon cages against closed forms: Euler characteristics, volumes, symmetries; and hostile selections. */
import { expect, test } from '@jest/globals';
import { bridge } from '../../../web/cage/bridge.js';
import { mirror } from '../../../web/cage/mirror.js';
import { boundaryLoops, eulerCharacteristic } from '../../../web/cage/polygons.js';
import { grown, looped } from '../../../web/cage/select.js';
import { extrude, move, remove } from '../../../web/cage/shape.js';
import { split } from '../../../web/cage/split.js';
import { box, done, faceAt, isClosed, pointAt, refusal, volume } from './cages.js';

/** @import {Selection} from '../../../web/cage/polygons.js' */

/** @param {...number} chosen @returns {Selection} */
const faces = (...chosen) => ({ points: [], faces: chosen });
/** @param {...number} chosen @returns {Selection} */
const points = (...chosen) => ({ points: chosen, faces: [] });

const cube = box(1);
const fine = box(3);
const top = faceAt(fine, [1.5, 1.5, 3]);
const bottom = faceAt(fine, [1.5, 1.5, 0]);
/** With one face taken away at the bottom and one at the top. */
const open = done(remove(fine, faces(bottom, top))).cage;

test('a moved corner of the unit cube changes the volume by a sixth of the areas that it spans, and nothing else', () => {
  const corner = pointAt(cube, [1, 1, 1]);
  const { cage } = done(move(cube, points(corner), [0, 0, 0.5]));
  expect(cage.points[corner]).toEqual([1, 1, 1.5]);
  expect(cage.faces).toEqual(cube.faces);
  expect(cage.points.filter((point, v) => point.some((x, axis) => x !== cube.points[v][axis]))).toHaveLength(1);
  expect(volume(done(move(cube, faces(faceAt(cube, [0.5, 0.5, 1])), [0, 0, 0.5])).cage)).toBeCloseTo(1.5, 12);
});

test('a box that a face is extruded from has as much more volume as the face sweeps, and the same Euler characteristic', () => {
  const { cage, selected } = done(extrude(fine, faces(top), 0.75));
  expect(volume(cage)).toBeCloseTo(27 + 0.75, 12);
  expect(volume(done(extrude(fine, faces(top), -0.75)).cage)).toBeCloseTo(27 - 0.75, 12);
  expect(eulerCharacteristic(cage)).toBe(2);
  expect(isClosed(cage)).toBe(true);
  expect(cage.faces).toHaveLength(fine.faces.length + 4);
  expect(selected.faces).toEqual([top]);
  expect(cage.faces[top].map((v) => cage.points[v][2])).toEqual([3.75, 3.75, 3.75, 3.75]);
});

test('faces that share edges are extruded as one, those apart each along its own normal', () => {
  const pair = faces(top, faceAt(fine, [0.5, 1.5, 3]));
  const together = done(extrude(fine, pair, 0.5)).cage;
  expect(together.faces).toHaveLength(fine.faces.length + 6);
  expect(volume(together)).toBeCloseTo(27 + 2 * 0.5, 12);
  const apart = done(extrude(fine, faces(top, bottom), 0.5)).cage;
  expect(apart.faces).toHaveLength(fine.faces.length + 8);
  expect(volume(apart)).toBeCloseTo(27 + 2 * 0.5, 12);
  expect(eulerCharacteristic(apart)).toBe(2);
});

test('a face at a boundary is extruded too, and leaves one boundary', () => {
  const next = faceAt(open, [0.5, 1.5, 3]);
  const { cage } = done(extrude(open, faces(next), 0.5));
  expect(boundaryLoops(cage.faces)).toHaveLength(2);
  expect(eulerCharacteristic(cage)).toBe(eulerCharacteristic(open));
});

test('each deleted face apart lowers the Euler characteristic by one, and leaves a boundary of its corners', () => {
  expect(eulerCharacteristic(open)).toBe(0);
  expect(boundaryLoops(open.faces).map((loop) => loop.length)).toEqual([4, 4]);
  const { cage, pointOrigins } = done(remove(cube, faces(1, 2, 3, 4, 5)));
  expect(cage.points).toHaveLength(4);
  expect(pointOrigins.map((v) => cube.points[v])).toEqual(cage.points);
});

test('a bridge between two faces of one part adds a handle, and takes the volume of a straight tube away', () => {
  const { cage, selected } = done(bridge(fine, faces(bottom, top)));
  expect(eulerCharacteristic(cage)).toBe(0);
  expect(isClosed(cage)).toBe(true);
  expect(volume(cage)).toBeCloseTo(27 - 3, 12);
  expect(selected.faces).toHaveLength(4);
});

test('a bridge between faces of two parts joins them to one sphere', () => {
  const shifted = cube.points.map(([x, y, z]) => /** @type {[number, number, number]} */ ([x + 3, y, z]));
  const two = {
    points: [...cube.points, ...shifted],
    faces: [...cube.faces, ...cube.faces.map((face) => face.map((v) => v + 8))],
    groups: [],
  };
  const { cage } = done(bridge(two, faces(faceAt(two, [1, 0.5, 0.5]), faceAt(two, [3, 0.5, 0.5]))));
  expect(eulerCharacteristic(two)).toBe(4);
  expect(eulerCharacteristic(cage)).toBe(2);
  expect(isClosed(cage)).toBe(true);
  expect(volume(cage)).toBeCloseTo(4, 12);
});

test('two boundaries are bridged by a point of each, as the faces that closed them', () => {
  const { cage } = done(bridge(open, points(pointAt(open, [1, 1, 0]), pointAt(open, [2, 1, 3]))));
  expect(isClosed(cage)).toBe(true);
  expect(eulerCharacteristic(cage)).toBe(0);
  expect(volume(cage)).toBeCloseTo(24, 12);
});

test('a ring splits the faces that it crosses, and leaves volume and Euler characteristic', () => {
  const edge = points(pointAt(cube, [0, 0, 0]), pointAt(cube, [0, 0, 1]));
  const { cage, selected } = done(split(cube, edge, 0.25));
  expect(cage.faces).toHaveLength(6 + 4);
  expect(isClosed(cage)).toBe(true);
  expect(eulerCharacteristic(cage)).toBe(2);
  expect(volume(cage)).toBeCloseTo(1, 12);
  // The part counts from the end where the strip's first face begins the edge.
  const heights = selected.points.map((v) => cage.points[v][2]);
  expect(new Set(heights).size).toBe(1);
  expect([0.25, 0.75]).toContain(heights[0]);
});

test('two adjacent faces name the edge between them; a strip of an open cage ends at its boundaries', () => {
  const pair = faces(faceAt(open, [0.5, 1.5, 3]), faceAt(open, [0.5, 0.5, 3]));
  const closed = done(split(open, pair)).cage;
  expect(closed.faces).toHaveLength(open.faces.length + 12);
  const edge = points(pointAt(open, [0, 1, 3]), pointAt(open, [0, 2, 3]));
  const { cage } = done(split(open, edge));
  // The strip goes down one side to the middle of the bottom, where the other boundary is: 1 + 3 + 1 faces.
  expect(cage.faces).toHaveLength(open.faces.length + 5);
  expect(boundaryLoops(cage.faces).map((loop) => loop.length)).toEqual([5, 5]);
  expect(eulerCharacteristic(cage)).toBe(0);
});

test('a strip that ends at a triangle gives it a corner', () => {
  /** A prism over a triangle: three quads and two triangles. */
  const prism = {
    points: /** @type {Array<[number, number, number]>} */ ([
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 1],
      [0, 1, 1],
    ]),
    faces: [
      [0, 2, 1],
      [3, 4, 5],
      [0, 1, 4, 3],
      [1, 2, 5, 4],
      [2, 0, 3, 5],
    ],
    groups: [],
  };
  const { cage } = done(split(prism, points(0, 1)));
  expect(cage.faces.map((face) => face.length).sort()).toEqual([4, 4, 4, 4, 4, 4]);
  expect(isClosed(cage)).toBe(true);
  expect(volume(cage)).toBeCloseTo(0.5, 12);
});

test('a mirrored half is symmetric, closed and outward; what was on the other side is gone', () => {
  const lower = fine.points.map(([x, y, z]) => /** @type {[number, number, number]} */ ([x - 1, y, z * (1 + x / 7)]));
  const { cage } = done(mirror({ ...fine, points: lower }, 0, 1));
  expect(isClosed(cage)).toBe(true);
  expect(eulerCharacteristic(cage)).toBe(2);
  expect(volume(cage)).toBeGreaterThan(0);
  const places = new Set(cage.points.map(String));
  for (const [x, y, z] of cage.points) expect(places.has(String([x === 0 ? 0 : -x, y, z]))).toBe(true);
  const again = done(mirror(cage, 0, -1)).cage;
  expect(new Set(again.points.map(String))).toEqual(places);
});

test('points within the tolerance of the plane are welded on it', () => {
  const off = cube.points.map(([x, y, z]) => /** @type {[number, number, number]} */ ([x || 1e-3, y, z]));
  const near = done(mirror({ ...cube, points: off }, 0, 1, 1e-2)).cage;
  expect(eulerCharacteristic(near)).toBe(2);
  expect(near.points).toHaveLength(12);
  expect(volume(near)).toBeCloseTo(2, 12);
  // Points that are not welded leave two cubes.
  expect(eulerCharacteristic(done(mirror({ ...cube, points: off }, 0, 1, 1e-6)).cage)).toBe(4);
});

test('groups stay with their faces, and what grows out of a face joins its groups', () => {
  const grouped = {
    ...fine,
    groups: [
      { name: 'cap', faces: [top] },
      { name: 'rest', faces: [bottom] },
    ],
  };
  const extruded = done(extrude(grouped, faces(top), 1)).cage;
  expect(extruded.groups[0].faces).toEqual([top, 54, 55, 56, 57]);
  const without = done(remove(grouped, faces(top, 0))).cage;
  expect(without.groups).toEqual([{ name: 'rest', faces: [faceAt(without, [1.5, 1.5, 0])] }]);
});

test('a selection grows by what touches it; two neighbours begin a strip or a line', () => {
  expect(grown(fine, faces(top)).faces).toHaveLength(9);
  expect(grown(fine, points(pointAt(fine, [0, 0, 0]))).points).toHaveLength(4);
  const strip = looped(fine, faces(top, faceAt(fine, [0.5, 1.5, 3])));
  expect(strip?.faces).toHaveLength(12);
  const line = looped(fine, points(pointAt(fine, [1, 1, 3]), pointAt(fine, [1, 2, 3])));
  // Once around the box: four sides of three edges.
  expect(line?.points).toHaveLength(12);
  expect(looped(fine, faces(top, bottom))).toBeNull();
});

test('what cannot be edited is refused with a sentence that says why', () => {
  const opposite = faces(faceAt(cube, [0.5, 0.5, 0]), faceAt(cube, [0.5, 0.5, 1]));
  expect(refusal(bridge(cube, opposite))).toMatch(/^An edge joins vertices \d and \d already/);
  expect(refusal(bridge(fine, faces(top, faceAt(fine, [0.5, 1.5, 3]))))).toMatch(/^Both have vertex \d+;/);
  expect(refusal(bridge(fine, faces(top)))).toMatch(/^Select two faces/);
  expect(refusal(bridge(open, points(0)))).toMatch(/^Select two faces/);
  const five = done(split(open, points(pointAt(open, [0, 1, 3]), pointAt(open, [0, 2, 3])))).cage;
  const uneven = done(remove(five, faces(faceAt(five, [3, 1.5, 1.5])))).cage;
  const [one, , other] = boundaryLoops(uneven.faces);
  expect(refusal(bridge(uneven, points(one[0], other[0])))).toMatch(/^One has \d corners, the other \d\.$/);
  expect(refusal(extrude(cube, faces(...cube.faces.keys()), 1))).toMatch(/whole part|no normal/);
  expect(refusal(extrude(cube, faces(0), 0))).toBe('The distance is a number other than 0.');
  expect(refusal(extrude(cube, faces(0), NaN))).toBe('The distance is a number other than 0.');
  expect(refusal(extrude(cube, faces(), 1))).toBe('Select the faces to extrude.');
  expect(refusal(remove(cube, faces(...cube.faces.keys())))).toBe('No face would be left.');
  expect(refusal(remove(fine, faces(top, faceAt(fine, [0.5, 0.5, 3]))))).toMatch(/^The surface would touch itself at/);
  expect(refusal(move(cube, points(0), [NaN, 0, 0]))).toBe('Vertex 1 would have no place.');
  expect(refusal(move(cube, points(0), [Infinity, 0, 0]))).toBe('Vertex 1 would have no place.');
  expect(refusal(move(cube, points(), [1, 0, 0]))).toBe('Nothing is selected to move.');
  const onto = cube.faces[0].map((v) => cube.points[v]);
  const middle = /** @type {[number, number, number]} */ (
    [0, 1, 2].map((i) => (onto[1][i] + onto[3][i]) / 2 - onto[0][i])
  );
  expect(
    refusal(
      move({ ...cube, faces: [[...cube.faces[0].slice(0, 2), cube.faces[0][3]]] }, points(cube.faces[0][0]), middle),
    ),
  ).toBe('Face 1 would have no area.');
  expect(refusal(split(cube, points(0)))).toMatch(/^Select two vertices/);
  expect(refusal(split(cube, points(pointAt(cube, [0, 0, 0]), pointAt(cube, [1, 1, 1]))))).toMatch(
    /^Select two vertices/,
  );
  expect(refusal(mirror(fine, 0, -1))).toMatch(/^No face lies on that side of the plane x = 0\.$/);
  const across = { ...cube, points: cube.points.map(([x, y, z]) => /** @type {any} */ ([x, y, z - 0.5])) };
  expect(refusal(mirror(across, 2, 1))).toMatch(/^Face \d lies on both sides of the plane z = 0\./);
});
