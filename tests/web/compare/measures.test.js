// SPDX-License-Identifier: MIT
/**
 * @file What makes surfaces comparable: one size, and energies side by side.
 */
import { describe, expect, test } from '@jest/globals';
import { energyTable } from '../../../web/pages/compare/energies.js';
import { areaOf, spreadCurvatures, withUnitArea } from '../../../web/pages/compare/equal_area.js';
import { torusMesh } from '../../../web/pages/torus/mesh.js';
import { entry } from '../catalog.js';

/** @param {import('../../../wasm/types.js').Mesh} mesh @param {number} scale @param {number} shift */
function moved(mesh, scale, shift) {
  return {
    ...mesh,
    positions: mesh.positions.map((value) => scale * value + shift),
    curvatures: mesh.curvatures.map((value) => value / scale),
  };
}

describe('a surface of unit size', () => {
  test('has the area of the unit sphere, whatever its size and place, and the same curvatures', () => {
    const mesh = torusMesh(0.4);
    const [one, other] = [withUnitArea(moved(mesh, 1, 0)), withUnitArea(moved(mesh, 7, 3))];
    // Floats: seven digits, less what the shift by 3 takes.
    for (const { positions, triangles } of [one, other])
      expect(areaOf({ positions, triangles })).toBeCloseTo(4 * Math.PI, 4);
    for (let i = 0; i < 200; i++) expect(other.curvatures[i]).toBeCloseTo(one.curvatures[i], 4);
    for (let i = 0; i < 300; i++) expect(other.positions[i]).toBeCloseTo(one.positions[i], 4);
  });

  test('has curvature 1 where it is a sphere', () => {
    const octahedron = {
      centre: new Float64Array(3),
      positions: Float32Array.from([3, 0, 0, -3, 0, 0, 0, 3, 0, 0, -3, 0, 0, 0, 3, 0, 0, -3]),
      normals: new Float32Array(),
      curvatures: new Float32Array(12).fill(1 / 3),
      triangles: Uint32Array.from([0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5]),
      faces: new Uint32Array(0),
      edges: new Uint32Array(),
    };
    const area = areaOf(octahedron);
    expect(area).toBeCloseTo(9 * 4 * Math.sqrt(3), 4); // 2 √3 edge², edge = 3 √2
    const expected = (1 / 3) * Math.sqrt(area / (4 * Math.PI));
    expect(withUnitArea(octahedron).curvatures[0]).toBeCloseTo(expected, 6);
  });
});

describe('curvatures spread over a surface', () => {
  test('are as many as its parts have area, however many vertices these have', () => {
    // A square of 1000 thin strips with curvature 1 beside one of two triangles with curvature 5.
    const strips = 1000;
    const points = Array.from({ length: strips + 1 }, (_, i) => [i / strips, 0, 0, i / strips, 1, 0]).flat();
    const fine = Array.from({ length: strips }, (_, i) => [
      2 * i,
      2 * i + 2,
      2 * i + 1,
      2 * i + 1,
      2 * i + 2,
      2 * i + 3,
    ]);
    const count = points.length / 3;
    const mesh = {
      centre: new Float64Array(3),
      positions: Float32Array.from([...points, 2, 0, 0, 3, 0, 0, 3, 1, 0, 2, 1, 0]),
      normals: new Float32Array(),
      curvatures: new Float32Array(2 * (count + 4)).fill(1).fill(5, 2 * count),
      triangles: Uint32Array.from([...fine.flat(), count, count + 1, count + 2, count, count + 2, count + 3]),
      faces: new Uint32Array(0),
      edges: new Uint32Array(),
    };
    const spread = spreadCurvatures(mesh);
    const part = spread.filter((value) => value === 5).length / spread.length;
    expect(part).toBeCloseTo(0.5, 2);
  });

  test('have the mean of κ₂ over a torus, which is 0', () => {
    const mesh = torusMesh(0.3);
    const values = [...spreadCurvatures(mesh)].filter((_, i) => i % 2);
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    // ∫ κ₂ dA = ∫∫ cos θ / (R + r cos θ) · r (R + r cos θ) dθ dφ = 0; 2048 points leave their spacing.
    expect(Math.abs(mean)).toBeLessThan(0.02);
  });
});

describe('energies side by side', () => {
  const energies = entry('a', 'b').energies;

  test('have their least marked in each row; what diverges or is not there is not compared', () => {
    const table = energyTable([
      entry('a', 'bending', { energies: { ...energies, bending: 1, mvs: 5 } }),
      entry('a', 'mvs', { energies: { ...energies, bending: 2, mvs: 4, second_form_variation: 7 } }),
      entry('a', 'none', { minimizer: null }),
      null,
    ]);
    /** @param {string} id */
    const row = (id) =>
      table.find(({ functional }) => functional === id)?.cells.map(({ value, least }) => [value, least]);
    expect(table).toHaveLength(6);
    expect(row('bending')).toEqual([
      [1, true],
      [2, false],
      [null, false],
      [null, false],
    ]);
    expect(row('mvs')?.map(([, least]) => least)).toEqual([false, true, false, false]);
    // Only one of them is known: nothing to compare.
    expect(row('second_form_variation')).toEqual([
      [null, false],
      [7, false],
      [null, false],
      [null, false],
    ]);
  });

  test('have no row for a functional that is newer than all entries', () => {
    const old = entry('a', 'bending');
    const rows = (/** @type {Array<typeof old>} */ ...entries) =>
      energyTable(entries).filter(({ functional }) => functional === 'curvedness_variation');
    expect(rows(old, old)).toEqual([]);
    const now = entry('a', 'mvs', { energies: { ...energies, curvedness_variation: 7 } });
    expect(rows(old, now)[0].cells.map(({ value }) => value)).toEqual([null, 7]);
  });

  test('are both the least where they are the same to round-off', () => {
    const [first] = energyTable([
      entry('a', 'b', { energies: { ...energies, bending: 100 } }),
      entry('a', 'c', { energies: { ...energies, bending: 100 * (1 + 1e-12) } }),
      entry('a', 'd', { energies: { ...energies, bending: 100 * (1 + 1e-6) } }),
    ]);
    expect(first.cells.map(({ least }) => least)).toEqual([true, true, false]);
  });
});
