// SPDX-License-Identifier: MIT
/**
 * @file A run whose cage moves ends where one of the moved cage does, and its report has that cage.
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { beforeAll, expect, test } from '@jest/globals';
import { Cage, InputError, Minimizer, load } from '../../wasm/umbilic.js';

/** @import { Problem } from '../../wasm/types.js' */

const fish = readFileSync(fileURLToPath(new URL('../../web/samples/fish.obj', import.meta.url)), 'utf8');

beforeAll(() => load());

/** @type {Problem} */
const problem = {
  cage: { name: 'fish.obj', text: fish },
  terms: { bending: 1 },
  constraints: { hold: { groups: ['body'] }, closeness: { weight: 8000 } },
  options: { levels: [1, 1], tolerance: 1e-9 },
};

/** @param {Minimizer} minimizer @returns {number} */
function ended(minimizer) {
  while (!minimizer.step(100));
  return minimizer.levels[0].energy;
}

/** A cage as the core reads it. @param {string} text @returns {string} */
function objOf(text) {
  const cage = Cage.read(text);
  const obj = cage.obj();
  cage.dispose();
  return obj;
}

/** @param {string} obj */
const pointsOf = (obj) =>
  obj
    .split('\n')
    .filter((line) => line.startsWith('v '))
    .map((line) => line.trim().split(' ').slice(1).map(Number));

/** The cage's points, those at one end moved to the side. @param {string} obj @returns {Float64Array} */
function bent(obj) {
  const points = pointsOf(obj);
  const least = Math.min(...points.map(([x]) => x));
  return Float64Array.from(points.flatMap(([x, y, z]) => [x, y + 0.1 * Math.exp(least - x), z]));
}

test('a held fish follows its cage', () => {
  const minimizer = new Minimizer(problem);
  const before = ended(minimizer);
  const points = bent(objOf(fish));
  minimizer.retarget({ points });
  const energy = ended(minimizer);
  expect(energy).not.toBeCloseTo(before, 5);

  const { cage } = minimizer.problem;
  if (!('text' in cage)) throw new Error('not a text');
  expect(cage.name).toBe('fish.obj');
  const fresh = new Minimizer({ ...problem, cage });
  expect(energy / ended(fresh)).toBeCloseTo(1, 6);
  expect(pointsOf(objOf(String(cage.text))).flat()).toEqual([...points]);
  for (const one of [minimizer, fresh]) one.dispose();
});

test('points that do not fit are refused', () => {
  const minimizer = new Minimizer(problem);
  minimizer.step(5);
  expect(() => minimizer.retarget({ points: [0, 0, 0] })).toThrow(InputError);
  expect(() => minimizer.retarget({ points: [0, 0] })).toThrow(/points/);
  expect(minimizer.problem.cage).toMatchObject({ text: fish });
  minimizer.dispose();
});
