// SPDX-License-Identifier: MIT
/**
 * @file What is held, and how strongly it pulls, in tables and reports.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
beforeAll(() => {
  outputOf(['cage', 'cube', '-o', 'cube.obj'], scratch);
});
afterAll(scratch.dispose);

describe('a pin of the cube', () => {
  const line = ['optimize', 'cube.obj', '--functional', 'mvs_cross', '--levels', '0..1', '-q', '--pin', '1@-1,-1,-1'];

  test('leaves the symmetry that keeps it', () => {
    expect(outputOf(line, scratch)).toContain('\nminimized mvs_cross, cap smooth, symmetry C3v, order 6\n');
  });

  test('keeps all of the symmetry with its copies, which pull as it does', () => {
    const out = outputOf([...line, '--hold-symmetric'], scratch);
    expect(out).toContain('\nminimized mvs_cross, cap smooth, symmetry Oh, order 48\n');
    expect(out).toMatch(/^ {2}pin 1 at \(-1, -1, -1\): pulls with /m);
    expect(out).toMatch(/^ {2}pin 1, copy 7, at \(.*\): pulls with /m);
    const { problem, constraints } = jsonOf([...line, '--hold-symmetric', '--report', '-'], scratch);
    expect(problem.constraints.symmetric).toBe(true);
    expect(constraints.pins.map((/** @type {{copy?: number}} */ { copy }) => copy)).toEqual([
      undefined,
      1,
      2,
      3,
      4,
      5,
      6,
      7,
    ]);
    const [{ strength }] = constraints.pins;
    for (const pin of constraints.pins) expect(Math.abs(pin.strength / strength - 1)).toBeLessThan(1e-9);
  });

  test('goes on from its report with its copies', () => {
    const report = jsonOf([...line, '--hold-symmetric', '--report', '-'], scratch);
    const again = jsonOf(['optimize', '-', '-q', '--max-iterations', '0', '--report', '-'], {
      input: JSON.stringify(report),
    });
    expect(again.group).toEqual({ name: 'Oh', order: 48 });
    const [first, second] = [report, again].map(({ levels }) => levels.at(-1).energy_reported);
    expect(Math.abs(second / first - 1)).toBeLessThan(1e-10);
  });

  test('cannot hold single coordinates over a symmetry that mixes them', () => {
    const problem = {
      umbilic: 'problem',
      version: 1,
      cage: { generator: 'two-3' },
      terms: { bending: 1 },
      constraints: { pins: [{ vertex: 1, at: [0.5, null, null] }], symmetric: true },
    };
    const { code, err } = umbilic(['optimize', '-', '-q'], { input: JSON.stringify(problem) });
    expect(code).toBe(3);
    expect(err).toContain('constraints.pins[0].at: only some coordinates are held, which the cage');
  });
});

describe('the boundaries of a clamped tube', () => {
  const problem = (/** @type {object} */ constraints) =>
    JSON.stringify({
      umbilic: 'problem',
      version: 1,
      cage: { generator: 'cylinder', segments: [16, 6] },
      terms: { willmore: 1 },
      constraints,
      options: { levels: [0, 0] },
    });

  test('pull against one another', () => {
    const out = outputOf(['optimize', '-', '-q'], { input: problem({}) });
    expect(out).toMatch(
      /^ {2}boundary 2: pulls with 1\.5\d* per length, \(.*\); 2\.1\d* without regard to direction$/m,
    );
    const { boundaries } = jsonOf(['optimize', '-', '-q', '--report', '-'], { input: problem({}) }).constraints;
    const [lower, upper] = boundaries;
    expect([lower.boundary, upper.boundary]).toEqual([1, 2]);
    expect(lower.center[2]).toBeCloseTo(-1, 12);
    for (let axis = 0; axis < 3; axis++) expect(lower.pull[axis]).toBeCloseTo(-upper.pull[axis], 6);
    expect(upper.pull[2]).toBeGreaterThan(1);
    expect(upper.total).toBeGreaterThan(upper.strength);
  });

  test('do not where they are free', () => {
    const input = problem({ boundary: { loops: [{ loop: 1, condition: 'free' }] } });
    const { boundaries } = jsonOf(['optimize', '-', '-q', '--report', '-'], { input }).constraints;
    expect(boundaries.map((/** @type {{boundary: number}} */ { boundary }) => boundary)).toEqual([2]);
  });
});
