// SPDX-License-Identifier: MIT
/**
 * @file The problems with a known least energy, the truths that are computed here, and what the table says of a run.
 */
import { expect, test } from '@jest/globals';
import { blends, knownLimits } from './known_limits.js';
import { conclusion, tables } from './limits.js';
import { leastProfile, profileEnergies } from './profiles.js';

test('there are sixty problems and more, no two alike, each with one truth for all cages that hold the same', () => {
  expect(knownLimits.length).toBeGreaterThanOrEqual(60);
  expect(new Set(knownLimits.map(({ problem }) => JSON.stringify(problem))).size).toBe(knownLimits.length);
  /** @type {Map<string, number>} */
  const truths = new Map();
  for (const { what, truth, problem } of knownLimits) {
    const { half_angle, height, radius } = /** @type {any} */ (problem.cage);
    const around = problem.constraints ? /** @type {any} */ (problem.cage).segments[0] : null;
    const key = JSON.stringify([what, problem.terms, half_angle, height, radius, around]);
    expect(truths.get(key) ?? truth).toBe(truth);
    truths.set(key, truth);
  }
});

test('profiles have the energies of tori whose tubes are circles', () => {
  const terms = 16;
  const circle = Array.from({ length: 2 * terms + 1 }, (_, i) => (i === 0 ? 2 : i === 1 || i === terms + 1 ? 1 : 0));
  const { bending, mvs_cross } = profileEnergies(terms)(circle);
  expect(bending).toBeCloseTo((4 * Math.PI ** 2) / (0.5 * Math.sqrt(0.75)), 9);
  expect(mvs_cross).toBeCloseTo(8 * Math.PI ** 4 * 0.75 ** -1.5, 8);
});

test('the least bending of a profile is the Clifford torus, that of blends is below all circles', () => {
  expect(leastProfile({ bending: 1, mvs_cross: 0 }, 6).value).toBeCloseTo(8 * Math.PI ** 2, 7);
  for (const [bending, cross, energy] of blends) {
    const { value } = leastProfile({ bending, mvs_cross: cross }, 8);
    expect(Math.abs(value / energy - 1)).toBeLessThan(1e-8);
  }
});

const row = {
  ...{
    what: 'sphere',
    cage: 'cube',
    cap: 'smooth',
    functional: 'bending',
    levels: '0 to 3',
    doubt: 0.5,
    lower: 0,
    seconds: 1,
  },
};

test('a row is inside where bar and doubt together reach the truth, and without a limit it has no bar', () => {
  const rows = [
    { ...row, status: /** @type {const} */ ('converging'), value: 12, bar: 1, truth: 10.5 },
    { ...row, status: /** @type {const} */ ('converging'), value: 12, bar: 1, truth: 10 },
    { ...row, status: /** @type {const} */ ('converging'), value: 12, bar: 2, truth: 10.5 },
    { ...row, status: /** @type {const} */ ('too_few_levels'), value: 12, bar: null, truth: 10 },
  ];
  expect(tables(rows)[0].rows.map((cells) => cells.at(-1))).toEqual(['yes', '**no**', 'yes', 'too few levels']);
  const held =
    '3 have a bar, and 2 of these hold the truth. The median of bar / true error is 1.0, of the 3 whose error is known.';
  expect(conclusion(rows)).toBe(`4 rows; ${held} All with the usual tolerance: ${held}`);
});

test('the median counts exact limits as infinitely good, and leaves out errors below what is not known of the truth', () => {
  const converging = /** @type {const} */ ({ ...row, status: 'converging', value: 12, bar: 1 });
  const rows = [
    { ...converging, truth: 11.5, usual: { ...converging, bar: 4, truth: 10.5 } },
    { ...converging, truth: 12, doubt: 0 },
    { ...converging, truth: 11, bar: 2 },
    { ...converging, truth: 11, bar: 1 },
  ];
  expect(conclusion(rows)).toBe(
    '4 rows; 4 have a bar, and 4 of these hold the truth. The median of bar / true error is 4.0, of the 3 whose error is known. ' +
      'All with the usual tolerance: 4 have a bar, and 4 of these hold the truth. ' +
      'The median of bar / true error is 4.0, of the 4 whose error is known.',
  );
});
