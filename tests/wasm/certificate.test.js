// SPDX-License-Identifier: MIT
/**
 * @file Certificates of a minimum, of a surface that is one only within its symmetry, and of what cannot be certified.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { InputError, Minimizer, load } from '../../wasm/umbilic.js';

beforeAll(() => load());

/**
 * @param {string} generator
 * @param {import('../../wasm/types.js').Options & {terms?: import('../../wasm/types.js').Terms}} [asked]
 */
function minimized(generator, { terms = { bending: 1 }, ...options } = {}) {
  const minimizer = new Minimizer({ cage: { generator }, terms, options: { levels: [0, 1], ...options } });
  while (!minimizer.step(20));
  return minimizer;
}

/** @param {Minimizer} minimizer */
function certified(minimizer) {
  const certificate = minimizer.certify();
  while (!certificate.step(10));
  const { report } = certificate;
  certificate.dispose();
  return report;
}

test('the genus-2 minimizer of bending is a local minimum among all surfaces, by its full Hessian', () => {
  const minimizer = minimized('two-3', { levels: [0, 2] });
  const full = 3 * (minimizer.controlMesh().positions.length / 3);
  expect(certified(minimizer)).toEqual({ level: 2, unknowns: full, gauge: 10, tau: 1e-3, negative: 0 });
  minimizer.dispose();
});

test('the genus-2 minimizer of MVS_cross on a coarse mesh is one only within its symmetry', () => {
  const minimizer = minimized('two-3', { terms: { mvs_cross: 1 } });
  const { negative, gauge } = certified(minimizer);
  expect(negative).toBeGreaterThan(0);
  expect(gauge).toBe(7); // no special conformal maps: it is of third order
  minimizer.dispose();
});

test('progress rises from 0 to 1, and the surface is neither moved nor needed', () => {
  const minimizer = minimized('cube');
  const { energies } = minimizer;
  const certificate = minimizer.certify();
  certificate.step(1);
  expect(minimizer.energies).toEqual(energies);
  minimizer.dispose();
  let before = 0;
  for (let done = false; !done;) {
    done = certificate.step(1);
    expect(certificate.progress).toBeGreaterThanOrEqual(before);
    before = certificate.progress;
    expect(before === 1).toBe(done);
  }
  expect(certificate.step(1)).toBe(true);
  certificate.dispose();
  certificate.dispose();
  expect(() => certificate.step(1)).toThrow(/disposed/);
});

test('flat caps and meshes with too many patches are refused with the reason', () => {
  const flat = minimized('cube', { cap: 'flat', max_iterations: 0 });
  expect(() => flat.certify()).toThrow(InputError);
  expect(() => flat.certify()).toThrow(/flat/);
  flat.dispose();
  const large = minimized('cube', { levels: [6, 6], max_iterations: 0 });
  expect(() => large.certify()).toThrow(/24576 patches; at most 10000/);
  large.dispose();
});
