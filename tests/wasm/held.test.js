// SPDX-License-Identifier: MIT
/**
 * @file A surface that is held in parts has one energy, whether the command line or WebAssembly fairs and evaluates it.
 */
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';

/** @import { Problem } from '../../wasm/types.js' */

const path = (/** @type {string} */ file) => fileURLToPath(new URL(`../../${file}`, import.meta.url));
const fish = readFileSync(path('web/samples/fish.obj'), 'utf8');

beforeAll(() => load());

/** @param {Problem} problem @returns {any} the report of the command line */
const native = (problem) =>
  JSON.parse(
    execFileSync(path('build/native/umbilic'), ['optimize', '-', '-q', '--report', '-'], {
      input: JSON.stringify({ umbilic: 'problem', version: 1, ...problem }),
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    }),
  );

/** @param {Problem} problem @returns {any} the report of WebAssembly */
function inWebAssembly(problem) {
  const minimizer = new Minimizer(problem);
  while (!minimizer.step(100));
  const report = JSON.parse(minimizer.report());
  minimizer.dispose();
  return report;
}

/** @param {number} a @param {number} b @returns {number} */
const difference = (a, b) => Math.abs(a - b) / Math.abs(b);

/** All energies, but for what is only the difference of two rules. @param {any} energies @returns {[string, number][]} */
const numbersOf = ({ free, ...whole }) =>
  /** @type {[string, any][]} */ ([
    ...Object.entries(whole),
    ...Object.entries(free ?? {}).map(([k, v]) => [`free ${k}`, v]),
  ]).filter(([name, value]) => typeof value === 'number' && name !== 'quadrature_error');

describe.each(
  /** @type {[string, Problem['terms'], Problem['constraints']][]} */ ([
    ['bending, its body held', { bending: 1 }, { hold: { groups: ['body'] }, closeness: { weight: 8000 } }],
    ['mvs_cross, its head free', { mvs_cross: 1 }, { free: { groups: ['head'] }, closeness: { weight: 3000 } }],
  ]),
)('a fish, minimizing %s', (_, terms, constraints) => {
  /** @type {Problem} */
  const problem = {
    cage: { name: 'fish.obj', text: fish },
    terms,
    constraints,
    options: { levels: [1, 2], tolerance: 1e-7 },
  };
  /** @type {Record<'native' | 'webAssembly', any>} */
  let reports;
  beforeAll(() => {
    reports = { native: native(problem), webAssembly: inWebAssembly(problem) };
  });

  // On the finer level the parametrization has several local minima, between which rounding decides: of mvs_cross 9990.64,
  // 9992.15 and 9992.54 were found, by instruction set and tolerance.
  test('has one least energy: to 1e-5 on the first level, and to 5e-4 on the next', () => {
    const [here, there] = [reports.native, reports.webAssembly].map(({ levels }) => levels);
    [1e-5, 5e-4].forEach((most, i) => {
      expect(here[i].stop).toBe('converged');
      expect(difference(here[i].energy_reported, there[i].energy_reported)).toBeLessThan(most);
    });
  });

  test.each(/** @type {const} */ (['native', 'webAssembly']))('that %s has written has one energy, to 1e-10', (by) => {
    /** @type {Problem} */
    const written = {
      ...reports[by].problem,
      start: reports[by].surface,
      options: { ...reports[by].problem.options, max_iterations: 0 },
    };
    const [here, there] = [native(written), inWebAssembly(written)];
    expect(here.levels.at(-1).level).toBe(2);
    const expected = new Map(numbersOf(there.energies));
    expect(expected.has('free bending')).toBe(true);
    for (const [name, value] of numbersOf(here.energies)) {
      expect([name, difference(value, /** @type {number} */ (expected.get(name))) <= 1e-10]).toEqual([name, true]);
    }
    // And it is that of the surface when it was written.
    expect(difference(here.levels.at(-1).energy_reported, reports[by].levels.at(-1).energy_reported)).toBeLessThan(
      1e-10,
    );
    expect(here.constraints.held_faces).toBe(there.constraints.held_faces);
  });
});
