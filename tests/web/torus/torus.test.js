// SPDX-License-Identifier: MIT
/**
 * @file The torus page without a browser: its view model against the closed forms, its state, and its mesh.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load, torusEnergies, torusMinimizer } from '../../../wasm/umbilic.js';
import { parseTorusAddress } from '../../../web/address/torus.js';
import { createEffects } from '../../../web/pages/torus/effects.js';
import {
  CLIFFORD,
  blendOf,
  blendedEnergy,
  drawnRatio,
  namedWeights,
  printed,
  ratios,
  shareOf,
  shares,
  torusInvariants,
  weightsOf,
} from '../../../web/pages/torus/family.js';
import { torusMesh } from '../../../web/pages/torus/mesh.js';
import { initialState, reduce } from '../../../web/pages/torus/reduce.js';
import { invariants as invariantWords } from '../../../web/words/invariants.js';

/** @typedef {import('../../../web/pages/torus/types.js').Action} Action */
/** @typedef {import('../../../web/pages/torus/types.js').State} State */

beforeAll(() => load());

/** A page without a browser, on the real core. @param {string} search */
function page(search) {
  let state = initialState('system', parseTorusAddress(search));
  /** @type {string[]} */
  const addresses = [];
  const effects = createEffects({
    dispatch,
    energiesOf: async (asked) => asked.map(torusEnergies),
    minimizersOf: async (asked) => asked.map(torusMinimizer),
    setAddress: (address) => addresses.push(address),
  });
  /** @param {Action} action */
  function dispatch(action) {
    state = reduce(state, action);
    effects(state);
  }
  effects(state);
  return { addresses, dispatch, now: () => state, settled: () => sleep(20) };
}

/** w2/w1 whose minimizing ratio is a. @param {number} a */
const quotient = (a) => ((1 - a ** 2) * (1 - 2 * a ** 2)) / (6 * Math.PI ** 2 * a ** 3);

test.each([0.3, 0.7])('the invariants of a torus of ratio %p are the limit of those of its meshes', (a) => {
  /** @param {number} segments */
  const errors = (segments) => {
    const minimizer = new Minimizer({
      cage: { generator: 'torus', ratio: a, segments: [segments, segments] },
      terms: { bending: 1 },
      options: { levels: [0, 0], max_iterations: 0 },
    });
    while (!minimizer.step(10));
    const { invariants } = minimizer.energies;
    minimizer.dispose();
    const exact = torusInvariants(a);
    // Relative to the largest of each order: J₄ has a zero at 1/√3.
    const sizes = { ...exact, variation_form: exact.gradient_form };
    return invariantWords.map(({ id }) => ((invariants?.[id] ?? NaN) - exact[id]) / sizes[id]);
  };
  const [coarse, fine] = [96, 192].map(errors);
  // They fall as the square of the mesh width, from 0.06 at most, so that this is what is left of them in the limit.
  fine.forEach((error, i) => expect(Math.abs((4 * error - coarse[i]) / 3)).toBeLessThan(5e-4));
});

describe('the least torus of a blend', () => {
  test.each([
    ['bending:1,mvs_cross:1', 0.2413],
    ['bending:0.95,mvs_cross:0.05', 0.4966],
    ['bending:3,mvs_cross:0.001', 0.7],
  ])('of %s solves the closed form, and its energy is the sum of the closed forms', async (weights, about) => {
    const { now, settled } = page(`?weights=${weights}`);
    await settled();
    const { blend, least } = now();
    const a = least?.minimizer.ratio ?? NaN;
    expect(a).toBeCloseTo(about, about === 0.7 ? 1 : 4);
    expect(quotient(a) / (blend.weights[1] / blend.weights[0])).toBeCloseTo(1, 9);
    const bending = (4 * Math.PI ** 2) / (a * Math.sqrt(1 - a ** 2));
    const cross = 8 * Math.PI ** 4 * (1 - a ** 2) ** -1.5;
    expect(least?.minimizer.energy).toBeCloseTo(blend.weights[0] * bending + blend.weights[1] * cross, 8);
    expect(least?.energies?.bending).toBeCloseTo(bending, 8);
  });

  test('is Clifford’s without the second, none without the first, and any without both', async () => {
    const clifford = page('?weights=bending:1,mvs_cross:0');
    const thin = page('?weights=bending:0,mvs_cross:1');
    const any = page('?weights=mvs:1,mvs_cross:0');
    await Promise.all([clifford, thin, any].map(({ settled }) => settled()));
    expect(clifford.now().least?.minimizer.ratio).toBeCloseTo(CLIFFORD, 12);
    expect(thin.now().least).toMatchObject({ minimizer: { ratio: 0, attained: false }, energies: null });
    expect(thin.now().least?.minimizer.energy).toBeCloseTo(8 * Math.PI ** 4, 10);
    expect(any.now().least?.minimizer).toMatchObject({ ratio: NaN, energy: 0 });
    expect([CLIFFORD, 0, NaN].map(drawnRatio)).toEqual([CLIFFORD, 0.02, CLIFFORD]);
  });

  test('lies nowhere above the family’s energies, and moves from Clifford’s to the thin torus with the share', async () => {
    const { now, settled } = page('?weights=bending:1,mvs_cross:1');
    await settled();
    const { family, blend, least, path } = now();
    expect(family?.energies).toHaveLength(ratios.length);
    for (const energies of family?.energies ?? []) {
      expect(blendedEnergy(blend, energies)).toBeGreaterThanOrEqual(least?.minimizer.energy ?? NaN);
    }
    expect(path).toHaveLength(shares.length);
    for (let i = 1; i < path.length; i++) expect(path[i].ratio).toBeLessThanOrEqual(path[i - 1].ratio + 1e-12);
    expect(path[0].ratio).toBeCloseTo(CLIFFORD, 12);
    expect(path.at(-1)?.ratio).toBe(0);
    // The paper's figure 5, to its rounding.
    const [equal, little] = printed.map(({ weights }) => path[shares.indexOf(shareOf(weights))].ratio);
    expect(equal).toBeCloseTo(0.2413, 4);
    expect(little).toBeCloseTo(0.4966, 4);
  });
});

describe('the state', () => {
  test('keeps the weights of the address, and shares to a thousandth', async () => {
    const { addresses, dispatch, now } = page('?weights=bending:2,mvs_cross:6');
    expect(shareOf(now().blend.weights)).toBe(0.75);
    dispatch({ type: 'shareChosen', share: 0.123456 });
    expect(now().blend.weights).toEqual([0.877, 0.123]);
    dispatch({ type: 'weightsChosen', weights: [0.95, 0.05] });
    dispatch({ type: 'ratioPointed', index: 5 });
    expect(addresses).toEqual([
      '?weights=bending:2,mvs_cross:6',
      '?weights=bending:0.877,mvs_cross:0.123',
      '?weights=bending:0.95,mvs_cross:0.05',
    ]);
    for (const share of [0, 0.001, 0.3, 0.999, 1]) {
      const [first, second] = weightsOf(share);
      expect(first + second).toBe(1);
    }
  });

  test('swaps two functionals where one is chosen twice, and drops what was of another pair', async () => {
    const { dispatch, now, settled } = page('?weights=bending:3,mvs_cross:1');
    await settled();
    const old = now();
    dispatch({ type: 'functionalChosen', index: 0, name: 'mvs_cross' });
    expect(now().blend).toEqual({ names: ['mvs_cross', 'bending'], weights: [1, 3] });
    expect(now()).toMatchObject({ least: null, path: [] });
    dispatch({ type: 'functionalChosen', index: 1, name: 'willmore' });
    expect(now().blend.names).toEqual(['mvs_cross', 'willmore']);
    // Answers about the pair of before come late.
    const late = /** @type {Action[]} */ ([
      { type: 'leastComputed', blend: old.blend, least: old.least },
      { type: 'pathComputed', names: old.blend.names, path: old.path },
    ]);
    expect(late.reduce(reduce, now())).toBe(now());
    await settled();
    expect(now().path).toHaveLength(shares.length);
  });

  test('points at ratios that there are', () => {
    const state = initialState();
    expect(reduce(state, { type: 'ratioPointed', index: -3 }).pointed).toBe(0);
    expect(reduce(state, { type: 'ratioPointed', index: 1e6 }).pointed).toBe(ratios.length - 1);
    expect(reduce(state, { type: 'ratioPointed', index: null }).pointed).toBe(null);
  });

  test('has its blend in the address and back', () => {
    const blend = blendOf({ bending: 1, mvs: 0.5 });
    expect(namedWeights(blend)).toEqual({ bending: 1, mvs: 0.5 });
    expect(Object.keys(namedWeights(blendOf({ mvs: 1, bending: 2 })))).toEqual(['mvs', 'bending']);
  });

  test('tells once that nothing can be computed', () => {
    const failed = /** @type {Action} */ ({ type: 'computationFailed', message: 'no WebAssembly' });
    expect([failed, failed].reduce(reduce, initialState()).notices).toEqual(['no WebAssembly']);
  });
});

describe('the mesh of a torus', () => {
  test.each([0.1, 0.2413, CLIFFORD, 0.95])(
    'of ratio %f has the area of the unit sphere and the torus’s bending energy',
    (ratio) => {
      const { positions, normals, curvatures, triangles } = torusMesh(ratio);
      let [area, bending, inward] = [0, 0, 0];
      /** @param {number} vertex */
      const at = (vertex) => positions.subarray(3 * vertex, 3 * vertex + 3);
      for (let i = 0; i < triangles.length; i += 3) {
        const [p, q, r] = [0, 1, 2].map((k) => at(triangles[i + k]));
        const [u, v] = [q, r].map((end) => [0, 1, 2].map((k) => end[k] - p[k]));
        const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        const outward = normals.subarray(3 * triangles[i], 3 * triangles[i] + 3);
        if (!(cross[0] * outward[0] + cross[1] * outward[1] + cross[2] * outward[2] > 0)) inward++;
        const part = Math.hypot(...cross) / 2;
        area += part;
        for (let k = 0; k < 3; k++) {
          const vertex = triangles[i + k];
          bending += (part / 3) * (curvatures[2 * vertex] ** 2 + curvatures[2 * vertex + 1] ** 2);
        }
      }
      expect(inward).toBe(0);
      // 192 by 64 facets: (π/64)² of the area is lost at most.
      expect(area / (4 * Math.PI)).toBeCloseTo(1, 2);
      expect(bending / torusEnergies(ratio).bending).toBeCloseTo(1, ratio > 0.9 ? 1 : 2);
      expect(curvatures.every((value, i) => i % 2 === 0 || value <= curvatures[i - 1])).toBe(true);
    },
  );
});
