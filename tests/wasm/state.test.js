// SPDX-License-Identifier: MIT
/**
 * @file Surfaces that are kept as the control points of one vertex of each orbit, and come back.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { InputError, Minimizer, load } from '../../wasm/umbilic.js';

/** @import {Options, Problem} from '../../wasm/types.js' */

beforeAll(() => load());

/** @param {string} generator @param {'hub' | 'flag'} family @param {Options} options @returns {Problem} */
const problemOf = (generator, family, options) => ({ cage: { generator, family }, terms: { mvs_cross: 1 }, options });

describe('the state of a run', () => {
  test.each([
    ['two-3', 'flag', 2],
    ['cube-frame', 'hub', 1],
    ['cube', 'flag', 1],
    ['torus', 'flag', 0],
  ])('of %s (%s) at level %i brings its surface back', (name, family, level) => {
    const problem = problemOf(name, /** @type {'hub' | 'flag'} */ (family), { levels: [0, level], max_iterations: 10 });
    const minimizer = new Minimizer(problem);
    while (!minimizer.step(50));
    const { state } = minimizer;
    expect(state.level).toBe(level);
    const again = new Minimizer({ ...problem, start: state });

    const positions = (/** @type {string} */ obj) => [...obj.matchAll(/^v (.*)$/gm)].flatMap(([, v]) => v.split(' ').map(Number)); // prettier-ignore
    const [before, after] = [positions(minimizer.controlObj()), positions(again.controlObj())];
    expect(after).toHaveLength(before.length);
    expect(Math.max(...after.map((x, i) => Math.abs(x - before[i])))).toBeLessThan(1e-14);
    expect(again.controlObj().match(/^f .*$/gm)).toEqual(minimizer.controlObj().match(/^f .*$/gm));
    expect(again.group).toEqual(minimizer.group);
    expect(again.progress.level).toBe(level);
    for (const [functional, energy] of Object.entries(minimizer.energies)) {
      if (['quadrature_error', 'resolved', 'invariants'].includes(functional)) continue;
      const other = Number(/** @type {Record<string, unknown>} */ (again.energies)[functional]);
      expect(Math.abs(other - Number(energy))).toBeLessThanOrEqual(1e-12 * Math.max(1, Math.abs(Number(energy))));
    }
    expect(again.state.points).toHaveLength(state.points.length);
    for (const handle of [minimizer, again]) handle.dispose();
  });

  test('takes one point for each orbit', () => {
    const problem = problemOf('two-3', 'flag', { levels: [0, 0] });
    const minimizer = new Minimizer(problem);
    const { points } = minimizer.state;
    /** @param {number} level @param {Float64Array} these */
    const from = (level, these) => () => new Minimizer({ ...problem, start: { level, points: these } });
    expect(from(1, points)).toThrow(InputError);
    expect(from(1, points)).toThrow(/start: \d+ points: expected \d+, one for each orbit of vertices at level 1/);
    expect(from(0, points.slice(1))).toThrow('start.points: 17 numbers, not three for each point');
    expect(from(-1, points)).toThrow('start.level: -1 is negative');
    expect(from(0, points.with(4, NaN))).toThrow('point 2 is not finite');
    minimizer.dispose();
  });
});
