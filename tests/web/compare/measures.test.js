// SPDX-License-Identifier: MIT
/**
 * @file What makes surfaces comparable: one size, and energies side by side.
 */
import { describe, expect, test } from '@jest/globals';
import { energyTable } from '../../../web/pages/compare/energies.js';
import { areaOf, withUnitArea } from '../../../web/pages/compare/equal_area.js';
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
      positions: Float32Array.from([3, 0, 0, -3, 0, 0, 0, 3, 0, 0, -3, 0, 0, 0, 3, 0, 0, -3]),
      normals: new Float32Array(),
      curvatures: new Float32Array(12).fill(1 / 3),
      triangles: Uint32Array.from([0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5]),
      edges: new Uint32Array(),
    };
    const area = areaOf(octahedron);
    expect(area).toBeCloseTo(9 * 4 * Math.sqrt(3), 4); // 2 √3 edge², edge = 3 √2
    const expected = (1 / 3) * Math.sqrt(area / (4 * Math.PI));
    expect(withUnitArea(octahedron).curvatures[0]).toBeCloseTo(expected, 6);
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

  test('are both the least where they are the same to round-off', () => {
    const [first] = energyTable([
      entry('a', 'b', { energies: { ...energies, bending: 100 } }),
      entry('a', 'c', { energies: { ...energies, bending: 100 * (1 + 1e-12) } }),
      entry('a', 'd', { energies: { ...energies, bending: 100 * (1 + 1e-6) } }),
    ]);
    expect(first.cells.map(({ least }) => least)).toEqual([true, true, false]);
  });
});
