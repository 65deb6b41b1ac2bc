// SPDX-License-Identifier: MIT
/**
 * @file `umbilic optimize --estimate`, and what reports say that a run was expected to take. How near it comes, the
 * bench measures.
 */
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { existsSync } from 'node:fs';
import { jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

beforeAll(() => {
  outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);
  outputOf(['cage', 'dodecahedron-frame', '-o', 'large.obj'], scratch);
});

const DURATION = String.raw`(a second|about (\d+ (s|min|h|days)|a minute|an hour))`;

/** @param {...string} args */
const estimate = (...args) => umbilic(['optimize', ...args, '--estimate'], { folder: scratch.folder });

test('tells each level and all of them, and runs nothing', () => {
  const { code, out, err } = estimate('frame.obj', '--functional', 'bending', '--levels', '0..2', '-o', 'out.obj');
  expect(code).toBe(0);
  expect(err).toBe('');
  const lines = out.trimEnd().split('\n');
  expect(lines[0]).toMatch(/^ +level +patches +unknowns +evaluations +memory +time$/);
  const rows = lines.slice(1, -1).map((line) => line.trim().split(/\s+/));
  expect(rows.map(([level, patches]) => [level, patches])).toEqual([
    ['0', '24'],
    ['1', '96'],
    ['2', '384'],
  ]);
  for (const line of lines.slice(1, -1)) expect(line).toMatch(new RegExp(` [MG]B +${DURATION}$`));
  expect(lines.at(-1)).toMatch(new RegExp(`^in all ${DURATION}, \\d+ MB; half or twice as long is usual$`));
  expect(existsSync(scratch.path('out.obj'))).toBe(false);
});

test('warns of a run that takes long, and names its longest level', () => {
  const { code, out } = estimate('large.obj', '--functional', 'mvs_cross', '--levels', '0..5', '--no-symmetry');
  expect(code).toBe(0);
  expect(out).toMatch(
    /^note: this will take about (\d+ (min|h)|an hour), of which level 5 takes about (\d+ (min|h)|an hour)$/m,
  );
});

test('refuses what does not fit into memory, as a run would', () => {
  const args = ['frame.obj', '--functional', 'bending', '--levels', '0..7', '--no-symmetry', '--metric', 'hessian'];
  const { code, err } = estimate(...args);
  expect(code).not.toBe(0);
  expect(err).toMatch(/level \d would take \d+ GB; at most level \d fits/);
});

test('a report tells what its run was expected to take, level by level', () => {
  const report = jsonOf(
    ['optimize', 'frame.obj', '--functional', 'bending', '--levels', '0..1', '--report', '-', '-q'],
    scratch,
  );
  expect(report.estimate.levels.map((/** @type {any} */ { level }) => level)).toEqual([0, 1]);
  const sum = report.estimate.levels.reduce(
    (/** @type {number} */ all, /** @type {any} */ { seconds }) => all + seconds,
    0,
  );
  expect(report.estimate.seconds).toBeCloseTo(sum, 12);
  expect(report.estimate.bytes).toBe(Math.max(...report.estimate.levels.map((/** @type {any} */ { bytes }) => bytes)));
});
