// SPDX-License-Identifier: MIT
/**
 * @file Runs with and without symmetry and in every metric: their groups, their unknowns, the same energies; and what
 * their levels say about the limit.
 */
import { afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { InputError, Minimizer, load } from '../../wasm/umbilic.js';

beforeAll(() => load());

/** @type {Minimizer[]} */
const held = [];
afterEach(() => held.splice(0).forEach((minimizer) => minimizer.dispose()));

/** @param {string} generator @param {import('../../wasm/types.js').Options} [options] */
function minimizerOf(generator, options = {}) {
  const minimizer = new Minimizer({
    cage: { generator },
    terms: { bending: 1 },
    options: { levels: [1, 1], ...options },
  });
  held.push(minimizer);
  return minimizer;
}

/** @param {Parameters<typeof minimizerOf>} cageAndOptions */
function minimized(...cageAndOptions) {
  const minimizer = minimizerOf(...cageAndOptions);
  while (!minimizer.step(20));
  return minimizer;
}

describe('symmetry', () => {
  test.each([
    ['cube', 'Oh', 48],
    ['torus', 'D6h', 24],
    ['two-3', 'D3h', 12],
    ['two-4', 'D4h', 16],
    ['tetrahedron-frame', 'Td', 24],
  ])('of %s is %s, of order %i, and known before the first step', (cage, name, order) => {
    expect(minimizerOf(cage).group).toEqual({ name, order });
    expect(minimizerOf(cage, { symmetry: false }).group).toEqual({ name: 'C1', order: 1 });
  });

  test('leaves fewer unknowns and the same energy', () => {
    const [symmetric, free] = [true, false].map((symmetry) => minimized('cube', { symmetry }).levels[0]);
    expect(free.unknowns).toBe(3 * 26);
    expect(symmetric.unknowns).toBe(3);
    // Both converged to a relative 1e-6, and this minimum is one among all surfaces, symmetric or not.
    expect(Math.abs(symmetric.energy_reported / free.energy_reported - 1)).toBeLessThan(1e-5);
  });
});

describe('a metric', () => {
  test.each(
    /** @type {Array<[import('../../wasm/types.js').MetricName, string]>} */ ([
      ['auto', 'hessian'],
      ['hessian', 'hessian'],
      ['newton', 'newton'],
      ['sobolev', 'sobolev'],
      ['identity', 'identity'],
    ]),
  )('%s is reported as %s and leads to the same minimum', (metric, name) => {
    const [level] = minimized('cube', { metric }).levels;
    expect(level.metric).toBe(name);
    expect(level.metrics > 0).toBe(metric !== 'identity');
    expect(level.evaluable).toBe(true);
    expect(level.energy).toBeCloseTo(25.20481, 3); // the cube's minimum at level 1, whatever the metric
  });

  test('that is unknown is refused', () => {
    // @ts-expect-error: only those of the type are known
    expect(() => minimizerOf('cube', { metric: 'euclidean' })).toThrow(InputError);
    // @ts-expect-error: only those of the type are known
    expect(() => minimizerOf('cube', { metric: 'euclidean' })).toThrow(/euclidean/);
  });
});

test('level 0 of a cage that is too coarse moves its own points on a finer mesh, and says that it only prepares', () => {
  const { levels } = minimized('cube', { levels: [0, 1], symmetry: false });
  expect(levels.map(({ level }) => level)).toEqual([0, 1]);
  expect(levels.map(({ patches }) => patches)).toEqual([24, 24]);
  expect(levels.map(({ unknowns }) => unknowns)).toEqual([3 * 8, 3 * 26]);
  expect(levels.map(({ evaluable }) => evaluable)).toEqual([false, true]);
  expect(levels[1].energy).toBeLessThanOrEqual(levels[0].energy);
});

describe('the limit', () => {
  test('of the torus in bending is Clifford’s, 8π², within its error', () => {
    const { limit } = minimized('torus', { levels: [0, 2] });
    expect(limit.status).toBe('converging');
    expect(limit.order).toBeGreaterThan(3);
    expect(limit.error).toBeGreaterThan(0);
    expect(limit.error).toBeLessThan(0.01);
    expect(Math.abs(limit.energy - 8 * Math.PI ** 2)).toBeLessThanOrEqual(limit.error);
  });

  test('is not told by two levels', () => {
    const { limit, levels } = minimized('torus', { levels: [0, 1] });
    const energy = levels[1].energy_reported;
    expect(limit).toEqual({
      status: 'too_few_levels',
      energy,
      order: NaN,
      error: NaN,
      lower: NaN,
      caps_included: false,
    });
  });

  test('is not told by levels that were not minimized', () => {
    const { limit } = minimized('torus', { levels: [0, 2], max_iterations: 2 });
    expect(limit.status).toBe('not_minimized');
    expect(limit.error).toBeNaN();
  });
});
