// SPDX-License-Identifier: MIT
/**
 * @file Where meshes cross themselves: known circles of spheres and surfaces of revolution, and real surfaces.
 */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';
import { crossingsOf } from '../../web/worker/crossings.js';
import { cubes, figureEightTube } from '../browser/cubes.js';

beforeAll(() => load());

/**
 * A closed grid of points, u × v, as triangles.
 * @param {number} m
 * @param {number} n
 * @param {(u: number, v: number) => number[]} point of angles
 */
function closedGrid(m, n, point) {
  const angle = (/** @type {number} */ i, /** @type {number} */ of) => (2 * Math.PI * i) / of;
  const positions = Float32Array.from(
    Array.from({ length: m * n }, (_, i) => point(angle(Math.floor(i / n), m), angle(i % n, n))).flat(),
  );
  const at = (/** @type {number} */ i, /** @type {number} */ j) => (i % m) * n + (j % n);
  const triangles = Uint32Array.from(
    Array.from({ length: m * n }, (_, i) => {
      const [u, v] = [Math.floor(i / n), i % n];
      const corners = [at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)];
      return [corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]];
    }).flat(),
  );
  return { positions, triangles };
}

/** Several meshes as one. @param {...{positions: Float32Array, triangles: Uint32Array}} meshes */
function together(...meshes) {
  let vertices = 0;
  const triangles = meshes.flatMap((mesh) => {
    const moved = [...mesh.triangles].map((vertex) => vertex + vertices);
    vertices += mesh.positions.length / 3;
    return moved;
  });
  return {
    positions: Float32Array.from(meshes.flatMap(({ positions }) => [...positions])),
    triangles: Uint32Array.from(triangles),
  };
}

/** A torus of radii 1 and r about the z axis, moved along x. @param {number} r @param {number} [shift] */
const torus = (r, shift = 0) =>
  closedGrid(96, 48, (u, v) => {
    const out = 1 + r * Math.cos(v);
    return [out * Math.cos(u) + shift, out * Math.sin(u), r * Math.sin(v)];
  });

/** A figure eight in the half-plane through the z axis, turned about it: it crosses itself in the circle of radius 2. */
const figureEight = (m = 60, n = 50) =>
  closedGrid(m, n, (u, v) => {
    const out = 2 + Math.sin(v);
    return [out * Math.cos(u), out * Math.sin(u), Math.sin(2 * v) / 2];
  });

/** @param {Float32Array} segments */
function points(segments) {
  return Array.from({ length: segments.length / 3 }, (_, i) => [...segments.subarray(3 * i, 3 * i + 3)]);
}

/** @param {Float32Array} segments */
const lengthOf = (segments) =>
  Array.from({ length: segments.length / 6 }, (_, i) =>
    Math.hypot(...[0, 1, 2].map((axis) => segments[6 * i + axis] - segments[6 * i + 3 + axis])),
  ).reduce((sum, length) => sum + length, 0);

describe('a mesh', () => {
  test('that is embedded does not cross itself, nor do two that lie apart or in one another', () => {
    expect(crossingsOf(torus(0.4))).toMatchObject({ places: 0, segments: new Float32Array(0), triangles: 9216 });
    expect(crossingsOf(together(torus(0.2), torus(0.4))).places).toBe(0);
    expect(crossingsOf(together(torus(0.2), torus(0.2, 2.6))).places).toBe(0);
  });

  test('a figure eight turned about an axis crosses itself in one circle, even where its vertices lie on it', () => {
    for (const n of [50, 48]) {
      const { segments, places } = crossingsOf(figureEight(60, n)); // n/2 is a vertex of the crossing, if n is even
      expect(places).toBe(1);
      for (const [x, y, z] of points(segments)) {
        // The chords of 60 points of a circle of radius 2 are inside of it by 2 (1 - cos(π/60)) = 0.0027.
        expect(Math.abs(Math.hypot(x, y) - 2)).toBeLessThan(0.004);
        expect(Math.abs(z)).toBeLessThan(1e-3);
      }
      expect(Math.abs(lengthOf(segments) / (4 * Math.PI) - 1)).toBeLessThan(0.003);
    }
  });

  test('a thin torus that pierces a thick one in two places meets it in four curves, which lie on both', () => {
    const { segments, places } = crossingsOf(together(torus(0.2), torus(0.1, 1.5)));
    expect(places).toBe(4);
    for (const [x, y, z] of points(segments)) {
      // A mesh is inside of its torus by at most 1.2 (π/96)²/2 + 0.2 (π/48)²/2 = 0.0011.
      expect(Math.abs(Math.hypot(Math.hypot(x, y) - 1, z) - 0.2)).toBeLessThan(0.0012);
      expect(Math.abs(Math.hypot(Math.hypot(x - 1.5, y) - 1, z) - 0.1)).toBeLessThan(0.0012);
    }
  });

  test('has the same crossings in any order of its triangles, and none where nothing is', () => {
    const { positions, triangles } = figureEight();
    const found = crossingsOf({ positions, triangles });
    const reversed = Uint32Array.from(triangles).reverse();
    const again = crossingsOf({ positions, triangles: reversed });
    expect(again.places).toBe(found.places);
    expect(lengthOf(again.segments)).toBeCloseTo(lengthOf(found.segments), 4);
    expect(crossingsOf({ positions: new Float32Array(0), triangles: new Uint32Array(0) }).places).toBe(0);
  });
});

/** The limit mesh of a cage's own surface. @param {import('../../wasm/types.js').CageInput} cage @param {number} density */
function limitOf(cage, density) {
  const minimizer = new Minimizer({ cage, terms: { bending: 1 }, options: { levels: [2, 2] } });
  const mesh = minimizer.limitMesh(density);
  minimizer.dispose();
  return mesh;
}

describe('a limit surface', () => {
  test.each(['two-3', 'tetrahedron-frame', 'torus'])('of the generated cage %s is embedded', (generator) => {
    expect(crossingsOf(limitOf({ generator }, 4)).places).toBe(0);
  });

  test.each(['cube-frame.mvs_cross', 'tetrahedron-frame.bending'])(
    'of the catalog’s minimizer %s is embedded',
    (name) => {
      const file = new URL(`../../web/catalog/${name}.json`, import.meta.url);
      const minimizer = new Minimizer(readFileSync(file, 'utf8'));
      const { edges } = minimizer.controlMesh();
      const density = Math.max(1, Math.floor(Math.sqrt(10_000 / (edges.length / 4)))); // about 20 000 triangles
      expect(crossingsOf(minimizer.limitMesh(density)).places).toBe(0);
      minimizer.dispose();
    },
  );

  test('of two cubes that interpenetrate crosses itself in one curve, half way between them', () => {
    const mesh = limitOf({ name: 'cubes.obj', text: cubes(0.9) }, 6);
    const { segments, places } = crossingsOf(mesh);
    expect(places).toBe(1);
    for (const [x] of points(segments)) expect(Math.abs(x)).toBeLessThan(0.02); // from the centre of both
    expect(crossingsOf(limitOf({ name: 'cubes.obj', text: cubes(3) }, 4)).places).toBe(0);
  });

  test('of a tube whose section is a figure eight crosses itself in one curve around its axis', () => {
    const { segments, places } = crossingsOf(limitOf({ name: 'eight.obj', text: figureEightTube(12, 8) }, 4));
    expect(places).toBe(1);
    for (const [, , z] of points(segments)) expect(Math.abs(z)).toBeLessThan(1e-3);
  });

  test('of as many triangles as are shown at rest is searched within seconds', () => {
    const mesh = limitOf({ generator: 'two-3' }, 12);
    expect(mesh.triangles.length / 3).toBeGreaterThan(100_000);
    const start = process.cpuUsage();
    expect(crossingsOf(mesh).places).toBe(0);
    expect(process.cpuUsage(start).user).toBeLessThan(10e6); // microseconds; about 1e6 outside of Jest
  }, 30_000);
});
