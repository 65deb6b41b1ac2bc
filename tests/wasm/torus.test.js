// SPDX-License-Identifier: MIT
/**
 * @file The exact torus through WebAssembly.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { InputError, functionalNames, load, torusEnergies, torusMinimizer } from '../../wasm/umbilic.js';

beforeAll(() => load());

/** @param {number} value @param {number} exact */
const expectExact = (value, exact) => expect(Math.abs(value - exact)).toBeLessThanOrEqual(1e-13 * Math.abs(exact));

describe('the torus', () => {
  test('has the closed forms of all functionals', () => {
    for (const a of [1e-3, 0.3, 0.95]) {
      const energies = torusEnergies(a);
      expect(Object.keys(energies)).toEqual(functionalNames());
      const cross = 8 * Math.PI ** 4 * (1 - a ** 2) ** -1.5;
      expectExact(energies.bending, (4 * Math.PI ** 2) / (a * Math.sqrt(1 - a ** 2)));
      expectExact(energies.willmore, energies.bending / 4);
      expect(energies.mvs).toBe(0);
      expectExact(energies.mvs_cross, cross);
      expectExact(energies.mehlum_tarrou, (9 / 16) * cross);
      expectExact(energies.second_form_variation, 3 * cross);
      expectExact(energies.mean_curvature_variation, cross);
      expectExact(energies.curvedness_variation, 8 * Math.PI ** 6 * a * (1 + 4 * a ** 2) * (1 - a ** 2) ** -3.5);
    }
  });

  test('of least energy is the Clifford torus, one between, none, or any', () => {
    const clifford = torusMinimizer({ bending: 1 });
    expect(clifford.attained).toBe(true);
    expectExact(clifford.ratio, Math.SQRT1_2);
    expectExact(clifford.energy, 8 * Math.PI ** 2);

    const blend = torusMinimizer({ bending: 1, mvs_cross: 1 });
    const { bending, mvs_cross } = torusEnergies(blend.ratio);
    expect(blend.ratio).toBeCloseTo(0.2413, 4);
    expectExact(blend.energy, bending + mvs_cross);

    const thin = torusMinimizer({ mvs_cross: 1 });
    expectExact(thin.energy, 8 * Math.PI ** 4);
    expect(thin).toMatchObject({ ratio: 0, attained: false });
    expect(torusMinimizer({ mvs: 1 })).toEqual({ ratio: NaN, energy: 0, attained: true });
  });

  test.each([0, 1, -1, NaN])('has no ratio %p', (ratio) => {
    expect(() => torusEnergies(ratio)).toThrow(InputError);
  });

  test('refuses weights of no functional', () => {
    expect(() => torusMinimizer({})).toThrow('all weights are zero');
    expect(() => torusMinimizer({ bending: -1 })).toThrow(InputError);
    // @ts-expect-error there is no such functional
    expect(() => torusMinimizer({ elastic: 1 })).toThrow("'elastic': no functional; known are bending");
  });
});
