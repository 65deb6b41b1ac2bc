// SPDX-License-Identifier: MIT
/**
 * @file Surfaces that are kept as the control points of one vertex of each orbit, and come back.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Cage, InputError, Minimizer, load } from '../../wasm/umbilic.js';

beforeAll(() => load());

/** @param {Cage} cage @param {Partial<import('../../wasm/types.js').MinimizerOptions>} options */
function minimized(cage, options) {
  const minimizer = new Minimizer(cage, { weights: { mvs_cross: 1 }, ...options });
  while (!minimizer.step(50));
  return minimizer;
}

describe('a refined cage', () => {
  test.each([
    ['two-3', 'flag', 2],
    ['cube-frame', 'hub', 1],
    ['cube', 'flag', 1],
    ['torus', 'flag', 0],
  ])('of %s (%s) at level %i has the surface that its orbit points were taken from', (name, family, level) => {
    const cage = Cage.generate(name, { family: /** @type {'hub' | 'flag'} */ (family) });
    const minimizer = minimized(cage, { levels: [0, level], maxIterations: 10 });
    const points = minimizer.orbitPoints();
    const refined = cage.refined(level, points);
    const again = new Minimizer(refined, { weights: { mvs_cross: 1 }, levels: [0, 0] });

    const positions = (/** @type {string} */ obj) => [...obj.matchAll(/^v (.*)$/gm)].flatMap(([, v]) => v.split(' ').map(Number)); // prettier-ignore
    const [before, after] = [positions(minimizer.controlObj()), positions(refined.obj())];
    expect(after).toHaveLength(before.length);
    expect(Math.max(...after.map((x, i) => Math.abs(x - before[i])))).toBeLessThan(1e-14);
    expect(refined.obj().match(/^f .*$/gm)).toEqual(minimizer.controlObj().match(/^f .*$/gm));
    expect(again.group).toEqual(minimizer.group);
    for (const [functional, energy] of Object.entries(minimizer.energies)) {
      if (functional === 'quadratureError') continue;
      const other = /** @type {Record<string, number>} */ (again.energies)[functional];
      expect(Math.abs(other - energy)).toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(energy)));
    }
    expect(again.orbitPoints()).toHaveLength(points.length);
    // As those of a cage read from a file.
    const read = Cage.read(refined.obj());
    expect(refined.counts).toEqual(read.counts);
    for (const handle of [minimizer, again, refined, read, cage]) handle.dispose();
  });

  test('takes one point for each orbit', () => {
    const cage = Cage.generate('two-3');
    const minimizer = new Minimizer(cage, { weights: { bending: 1 }, levels: [0, 0] });
    const points = [...minimizer.orbitPoints()];
    expect(() => cage.refined(1, points)).toThrow(InputError);
    expect(() => cage.refined(1, points)).toThrow(/expected \d+, one for each orbit of vertices at level 1/);
    expect(() => cage.refined(0, points.slice(1))).toThrow('the number of points');
    expect(() => cage.refined(-1, points)).toThrow('level -1');
    expect(() => cage.refined(0, points.with(4, NaN))).toThrow('point 2 is not finite');
    minimizer.dispose();
    cage.dispose();
  });
});
