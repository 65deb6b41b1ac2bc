// SPDX-License-Identifier: MIT
/**
 * @file The same cage has the same energies in WebAssembly and in the native program.
 */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { vertexAreas } from '../../web/colour/histogram.js';

const program = fileURLToPath(new URL('../../build/native/umbilic', import.meta.url));
const folder = mkdtempSync(path.join(os.tmpdir(), 'umbilic-'));

beforeAll(() => load());
afterAll(() => rmSync(folder, { recursive: true }));

/**
 * @param {string} file
 * @param {string} cap
 * @param {number} levels
 */
function nativeReport(file, cap, levels) {
  const output = execFileSync(program, ['evaluate', file, '--cap', cap, '--levels', String(levels), '--json'], {
    encoding: 'utf8',
  });
  return JSON.parse(output);
}

test.each(
  /** @type {Array<[string, 'hub' | 'flag', 'smooth' | 'flat' | 'none', number]>} */ ([
    ['cube', 'flag', 'smooth', 2],
    ['two-3', 'flag', 'smooth', 1],
    ['two-3', 'flag', 'flat', 1],
    ['two-3', 'hub', 'none', 1],
    ['tetrahedron-frame', 'hub', 'smooth', 2],
    ['octahedron-frame', 'flag', 'flat', 1],
  ]),
)('%s (%s), cap %s, level %i: all energies agree to 1e-10', (name, family, cap, level) => {
  const cage = Cage.generate(name, { family });
  const file = path.join(folder, `${name}-${family}.obj`);
  writeFileSync(file, cage.obj());
  const native = nativeReport(file, cap, level);

  const minimizer = new Minimizer({
    cage: cage.input,
    terms: { bending: 1 },
    options: { cap, levels: [level, level], max_iterations: 0 },
  });
  while (!minimizer.step(10));
  const { energies } = minimizer;
  const { quadrature_error } = energies;
  expect(Object.keys(native.energies)).toEqual(Object.keys(energies));
  const flat = (/** @type {any} */ { invariants, ...others }) => ({ ...others, ...invariants });
  expect(Object.keys(flat(native.energies))).toEqual(Object.keys(flat(energies)));
  for (const [name, value] of Object.entries(flat(energies))) {
    const expected = flat(native.energies)[name];
    if (name === 'quadrature_error') continue;
    if (expected === null) expect(value).toBeNaN();
    else if (typeof value !== 'number') expect(value).toEqual(expected);
    else expect(Math.abs(value - expected)).toBeLessThanOrEqual(1e-10 * Math.abs(expected));
  }
  // A difference of two energies, so it agrees to their last digits only.
  expect(Math.abs(quadrature_error - native.energies.quadrature_error)).toBeLessThanOrEqual(1e-10 * energies.bending);
  minimizer.dispose();
  cage.dispose();
});

test('the first ten energies of L-BFGS agree to 1e-8', () => {
  const cage = Cage.generate('two-3');
  const file = path.join(folder, 'two-3.obj');
  writeFileSync(file, cage.obj());
  for (let iterations = 0; iterations <= 10; iterations++) {
    const args = ['--functional', 'mvs_cross', '--levels', '1', '--max-iterations', String(iterations)];
    const native = JSON.parse(
      execFileSync(program, ['optimize', file, ...args, '--quiet', '--report', '-'], { encoding: 'utf8' }),
    );
    const minimizer = new Minimizer({
      cage: cage.input,
      terms: { mvs_cross: 1 },
      options: { levels: [1, 1], max_iterations: iterations },
    });
    while (!minimizer.step(10));
    const [level] = minimizer.levels;
    expect(level.iterations).toBe(iterations);
    expect(level.evaluations).toBe(native.levels[0].evaluations);
    expect(Math.abs(level.energy - native.levels[0].energy)).toBeLessThanOrEqual(1e-8 * level.energy);
    minimizer.dispose();
  }
  cage.dispose();
});

test.each(
  /** @type {import('../../wasm/types.js').FunctionalName[]} */ (['bending', 'mvs_cross', 'curvedness_variation']),
)('the density of %s integrates in WebAssembly to the energy of the native program', (name) => {
  const cage = Cage.generate('two-3');
  const file = path.join(folder, 'density.obj');
  writeFileSync(file, cage.obj());
  const minimizer = new Minimizer({
    cage: cage.input,
    terms: { bending: 1 },
    options: { levels: [1, 1], max_iterations: 0 },
  });
  const mesh = minimizer.limitMeshWithDensities(32, { [name]: 1 });
  const areas = vertexAreas(mesh.positions, mesh.triangles);
  const integral = areas.reduce((sum, area, vertex) => sum + area * mesh.densities[vertex], 0);
  // The error falls with the square of the spacing.
  expect(Math.abs(integral / nativeReport(file, 'smooth', 1).energies[name] - 1)).toBeLessThan(0.01);
  expect(() => minimizer.limitMeshWithDensities(2, /** @type {any} */ ({ nothing: 1 }))).toThrow('nothing');
  minimizer.dispose();
  cage.dispose();
});
