// SPDX-License-Identifier: MIT
/**
 * @file Sections of meshes and their curvature, against circles and the curves of a torus.
 */
import { describe, expect, test } from '@jest/globals';
import { combOf, planeAcross, sectionOf } from '../../web/scene/section.js';

/** @typedef {import('../../web/scene/section.js').Triple} Triple */

/** A torus of radii 2 and 1 about the z axis. @param {number} [m] points around the axis @param {number} [n] around the tube */
function torus(m = 192, n = 96) {
  const angle = (/** @type {number} */ i, /** @type {number} */ of) => (2 * Math.PI * (i + 0.3)) / of;
  const rows = Array.from({ length: m * n }, (_, i) => [angle(Math.floor(i / n), m), angle(i % n, n)]);
  const normals = rows.map(([u, v]) => [Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v)]);
  const positions = rows.map(([u], i) => [
    2 * Math.cos(u) + normals[i][0],
    2 * Math.sin(u) + normals[i][1],
    normals[i][2],
  ]);
  const at = (/** @type {number} */ i, /** @type {number} */ j) => (i % m) * n + (j % n);
  const triangles = rows.flatMap((_, i) => {
    const [u, v] = [Math.floor(i / n), i % n];
    const [a, b, c, d] = [at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)];
    return [a, b, c, a, c, d];
  });
  return {
    positions: Float32Array.from(positions.flat()),
    normals: Float32Array.from(normals.flat()),
    triangles: Uint32Array.from(triangles),
  };
}

/** A sphere of radius 2 about the origin: an octahedron whose faces are divided. @param {number} n divisions of an edge */
function sphere(n) {
  /** @type {Map<string, number>} */
  const known = new Map();
  /** @type {number[][]} */
  const normals = [];
  const vertex = (/** @type {number[]} */ x) => {
    const key = x.join();
    if (!known.has(key)) {
      known.set(key, normals.length);
      const length = Math.hypot(...x);
      normals.push(x.map((value) => value / length));
    }
    return Number(known.get(key));
  };
  /** @type {number[]} */
  const triangles = [];
  for (const [sx, sy, sz] of [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [1 - 2 * (k & 1), 1 - (k & 2), 1 - (k & 4) / 2])) {
    const at = (/** @type {number} */ i, /** @type {number} */ j) => vertex([sx * i, sy * j, sz * (n - i - j)]);
    const add = (/** @type {number[]} */ [a, b, c]) => triangles.push(...(sx * sy * sz > 0 ? [a, b, c] : [a, c, b]));
    for (let i = 0; i < n; i++) {
      for (let j = 0; i + j < n; j++) {
        add([at(i, j), at(i + 1, j), at(i, j + 1)]);
        if (i + j < n - 1) add([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
      }
    }
  }
  return {
    positions: Float32Array.from(normals.flat(), (x) => 2 * x),
    normals: Float32Array.from(normals.flat()),
    triangles: Uint32Array.from(triangles),
  };
}

const directions = /** @type {Triple[]} */ ([
  [0, 0, 1],
  [1, 0, 0],
  [0.6, 0, -0.8],
  [2 / 3, -1 / 3, 2 / 3],
]);

describe('a sphere', () => {
  test.each(directions)('cut across (%d, %d, %d) has circles, whose curvature is that of their radius', (...normal) => {
    for (const offset of [-1.2, 0, 0.3, 1.6]) {
      const curves = sectionOf(sphere(40), { normal, offset });
      expect(curves).toHaveLength(1);
      const [curve] = curves;
      expect(curve.closed).toBe(true);
      const radius = Math.sqrt(4 - offset ** 2);
      for (const [i, point] of curve.points.entries()) {
        expect(point.reduce((sum, x, axis) => sum + x * normal[axis], 0)).toBeCloseTo(offset, 5);
        // The mesh is inside of the sphere by at most h²/8r, with h = 0.08 the longest edge.
        expect(Math.abs(Math.hypot(...point) - 2)).toBeLessThan(0.001);
        expect(Math.hypot(...curve.normals[i])).toBeCloseTo(1, 6);
      }
      const { curvatures } = combOf(curve, normal, 100);
      expect(curvatures).toHaveLength(100);
      for (const curvature of curvatures) expect(Math.abs(curvature * radius - 1)).toBeLessThan(0.03);
    }
  });

  test('is not cut by a plane beside it, and in its vertices as everywhere', () => {
    expect(sectionOf(sphere(8), { normal: [0, 0, 1], offset: 2.1 })).toEqual([]);
    // All four corners of the octahedron's equator and all vertices between them lie in this plane.
    const [curve, ...others] = sectionOf(sphere(8), { normal: [0, 0, 1], offset: 0 });
    expect(others).toEqual([]);
    expect(curve.points.every(([, , z]) => z === 0)).toBe(true);
    expect(combOf(curve, [0, 0, 1], 50).curvatures.every(Number.isFinite)).toBe(true);
  });
});

test('a plane goes from one end of a mesh along a direction to the other', () => {
  for (const direction of directions) {
    const [first, middle, last] = [-1, 0, 1].map((position) => planeAcross(sphere(24), direction, position));
    expect(first.normal).toEqual(direction);
    expect(first.offset).toBeCloseTo(-2, 1);
    expect(middle.offset).toBeCloseTo(0, 1);
    expect(last.offset).toBeCloseTo(2, 1);
  }
});

describe('a torus', () => {
  test('is cut through its axis in two circles of the tube, and across it in two of which one bends the other way', () => {
    for (const curve of sectionOf(torus(), { normal: [0, 1, 0], offset: 0 })) {
      for (const one of combOf(curve, [0, 1, 0], 40).curvatures) expect(Math.abs(one - 1)).toBeLessThan(0.01);
    }
    const height = 0.5;
    const curves = sectionOf(torus(), { normal: [0, 0, 1], offset: height });
    const found = curves.map((curve) => combOf(curve, [0, 0, 1], 40).curvatures[0]).sort((a, b) => a - b);
    const wide = Math.sqrt(1 - height ** 2);
    expect(Math.abs(found[0] * (2 - wide) + 1)).toBeLessThan(0.01); // the inner one, seen from the solid
    expect(Math.abs(found[1] * (2 + wide) - 1)).toBeLessThan(0.01);
  });

  test('is cut in a curve whose curvature is that of the level set, by Meusnier and by implicit differentiation', () => {
    // Seen along x: F(y, z) = (√(a² + y²) - 2)² + z² - 1 with the plane x = a.
    const a = 1.5;
    const force = (/** @type {number} */ y, /** @type {number} */ z) => (Math.hypot(a, y) - 2) ** 2 + z ** 2 - 1;
    const h = 1e-4;
    const curves = sectionOf(torus(), { normal: [1, 0, 0], offset: a });
    expect(curves).toHaveLength(1);
    const { points, curvatures } = combOf(curves[0], [1, 0, 0], 80);
    for (const [i, [x, y, z]] of points.entries()) {
      expect(x).toBeCloseTo(a, 5);
      const fy = (force(y + h, z) - force(y - h, z)) / (2 * h);
      const fz = (force(y, z + h) - force(y, z - h)) / (2 * h);
      const fyy = (force(y + h, z) - 2 * force(y, z) + force(y - h, z)) / h ** 2;
      const fzz = (force(y, z + h) - 2 * force(y, z) + force(y, z - h)) / h ** 2;
      const expected = (fyy * fz ** 2 + fzz * fy ** 2) / Math.hypot(fy, fz) ** 3; // F has no mixed derivative
      expect(Math.abs(curvatures[i] - expected)).toBeLessThan(0.06 * (1 + Math.abs(expected)));
    }
  });

  test('of which a part is missing has open curves, in order', () => {
    const mesh = torus();
    const kept = mesh.triangles.subarray(0, (mesh.triangles.length * 3) / 4);
    const curves = sectionOf({ ...mesh, triangles: kept }, { normal: [0, 0, 1], offset: 0.2 });
    expect(curves.map(({ closed }) => closed)).toEqual([false, false]);
    for (const { points } of curves) {
      const steps = points.slice(1).map((point, i) => Math.hypot(...point.map((x, axis) => x - points[i][axis])));
      expect(Math.max(...steps)).toBeLessThan(0.15);
      expect(points.length).toBeGreaterThan(200);
    }
    const { curvatures } = combOf(curves[0], [0, 0, 1], 30);
    expect(Math.abs(Math.abs(curvatures[0] / curvatures[29]) - 1)).toBeLessThan(0.02);
  });
});
