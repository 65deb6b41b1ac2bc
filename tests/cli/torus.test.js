// SPDX-License-Identifier: MIT
/**
 * @file The exact torus on the command line.
 */
import { describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, umbilic } from './program.js';

const pi = Math.PI;
/** Of digits that are printed in full. @param {number} value @param {number} exact */
const expectExact = (value, exact) => expect(Math.abs(value - exact)).toBeLessThanOrEqual(1e-10 * Math.abs(exact));

describe('torus', () => {
  test('gives the closed forms of a ratio to 1e-10', () => {
    for (const a of [0.05, 0.5, 0.9]) {
      const [{ ratio, energies }] = jsonOf(['torus', '--ratio', String(a), '--json']).tori;
      expect(ratio).toBe(a);
      const bending = (4 * pi ** 2) / (a * Math.sqrt(1 - a ** 2));
      const cross = 8 * pi ** 4 * (1 - a ** 2) ** -1.5;
      expectExact(energies.bending, bending);
      expectExact(energies.willmore, bending / 4);
      expect(energies.mvs).toBe(0);
      expectExact(energies.mvs_cross, cross);
      expectExact(energies.mehlum_tarrou, (9 * cross) / 16);
      expectExact(energies.second_form_variation, 3 * cross);
      expectExact(energies.mean_curvature_variation, cross);
      expectExact(energies.curvedness_variation, 8 * pi ** 6 * a * (1 + 4 * a ** 2) * (1 - a ** 2) ** -3.5);
    }
  });

  test('finds the ratio of a blend, from the equation that the paper solves numerically', () => {
    for (const [bending, cross, paper] of [
      [1, 1, 0.2413],
      [0.95, 0.05, 0.4966],
    ]) {
      const weights = `bending=${bending},mvs_cross=${cross}`;
      const { ratio: a, energy, attained } = jsonOf(['torus', '--weights', weights, '--json']).minimizer;
      expect(attained).toBe(true);
      expect(a).toBeCloseTo(paper, 4);
      expectExact(((1 - a ** 2) * (1 - 2 * a ** 2)) / (6 * pi ** 2 * a ** 3), cross / bending);
      const { energies } = jsonOf(['torus', '--ratio', String(a), '--json']).tori[0];
      expectExact(energy, bending * energies.bending + cross * energies.mvs_cross);
    }
  });

  test('marks the Clifford torus, the limit of thin tori and the minimizing ratio in its table', () => {
    const table = outputOf(['torus', '--weights', 'bending=1,mvs_cross=1']);
    expect(table).toMatch(/^ *0\.0000 .* 779\.2727283 .* limit of thin tori, 8 pi\^4 for mvs_cross$/m);
    expect(table).toMatch(/^ *0\.7071 +78\.956835 .* Clifford torus$/m);
    expect(table).toMatch(/^ *0\.2413 .* minimizes 1 bending \+ 1 mvs_cross$/m);
    expect(table).toContain('is least, 1021.23580895, at r/R = 0.241308912');
  });

  test('says where no torus or every torus attains the infimum', () => {
    expect(outputOf(['torus', '--functional', 'mvs_cross'])).toContain(
      'mvs_cross has the infimum 779.272728272 as r/R -> 0, which no torus attains',
    );
    expect(outputOf(['torus', '--functional', 'curvedness_variation'])).toContain(
      'curvedness_variation has the infimum 0 as r/R -> 0, which no torus attains',
    );
    expect(outputOf(['torus', '--functional', 'mvs'])).toContain('mvs is 0 on every torus');
    const { minimizer } = jsonOf(['torus', '--functional', 'mvs', '--json']);
    expect(minimizer).toEqual({ ratio: null, energy: 0, attained: true });
  });

  test.each(['0', '1', '-0.5', 'x'])('refuses the ratio %s', (ratio) => {
    const { code, out, err } = umbilic(['torus', '--ratio', ratio]);
    expect({ code, out }).toEqual({ code: 2, out: '' });
    expect(err).toContain(`'${ratio}' is not`);
  });
});
