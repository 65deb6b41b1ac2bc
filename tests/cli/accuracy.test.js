// SPDX-License-Identifier: MIT
/**
 * @file An accuracy instead of levels: as many as it takes, and one sentence that says what was reached.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);
outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);

/** @param {string[]} args */
const run = (...args) => outputOf(['optimize', 'frame.obj', '--functional', 'bending', '-q', ...args], scratch);

describe('an accuracy', () => {
  test.each([
    ['draft', 5],
    ['good', 1],
    ['0.02%', 0.02],
  ])('%s is reached and said', (accuracy, percent) => {
    const out = run('--accuracy', accuracy);
    const [, energy, within] = /^(\d+\.\d), within (\S+) %$/m.exec(out) ?? [];
    expect(Number(within)).toBeLessThanOrEqual(percent);
    expect(Math.abs(Number(energy) / 112.7668 - 1)).toBeLessThan(Number(within) / 100 + 1e-3);
  });

  test('that is not reached says what the levels tell', () => {
    expect(run('--accuracy', '1%', '--max-iterations', '1')).toMatch(/^not within 1 %: the levels tell no limit$/m);
  });

  test('is a part of the problem, and takes the place of the last level', () => {
    const problem = jsonOf(
      ['optimize', 'frame.obj', '--functional', 'bending', '--accuracy', 'fine', '--levels', '0..0', '--print-problem'],
      scratch,
    );
    expect(problem.options).toMatchObject({ accuracy: 0.003, levels: [0, 0] });
    const report = jsonOf(['optimize', '-', '-q', '--report', '-'], { input: JSON.stringify(problem) });
    expect(report.levels.length).toBeGreaterThanOrEqual(3);
    expect(report.limit.error / report.limit.energy).toBeLessThanOrEqual(0.003);
  });

  test.each(['best', '5', '0%', '100%', '-1%', 'nan%'])('%s is refused', (accuracy) => {
    const { code, err } = umbilic(
      ['optimize', 'frame.obj', '--functional', 'bending', '--accuracy', accuracy],
      scratch,
    );
    expect(code).toBe(2);
    expect(err).toContain('is none of draft, good, fine, nor a percentage');
  });
});
