// SPDX-License-Identifier: MIT
/**
 * @file Every number of threads gives the same results, to the last digit.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { outputOf, scratchFolder, start, umbilic } from './program.js';

const scratch = scratchFolder();
beforeAll(() => {
  const lines = outputOf(['cage', 'two-3'])
    .split('\n')
    .map((line, i) => {
      const [kind, ...numbers] = line.split(' ');
      if (kind !== 'v') return line;
      return ['v', ...numbers.map((x, c) => Number(x) + 0.1 * Math.sin(7 * i + 3 * c))].join(' ');
    });
  scratch.write('moved.obj', lines.join('\n'));
});
afterAll(scratch.dispose);

/** @param {string} report @returns {string} without the time that each level took */
const timeless = (report) => report.replace(/"seconds": *[^,}]*/g, '"seconds": null');

/**
 * @param {string} input a file, or - for a problem
 * @param {string[]} args
 * @param {number} threads
 * @param {object} [problem]
 * @returns {string[]} the report, the control mesh and the limit mesh
 */
function results(input, args, threads, problem) {
  const outputs = ['--report', 'report.json', '-o', 'control.obj', '--limit-mesh', 'limit.obj', '--density', '3'];
  const line = ['optimize', input, ...args, ...outputs, '-q', '--threads', String(threads)];
  outputOf(line, { folder: scratch.folder, input: JSON.stringify(problem ?? {}) });
  return [timeless(scratch.read('report.json')), scratch.read('control.obj'), scratch.read('limit.obj')];
}

/** @type {Record<string, { input: string, args: string[], problem?: object }>} */
const runs = {
  'a symmetric surface': {
    input: '-',
    args: [],
    problem: {
      ...{ umbilic: 'problem', version: 1, cage: { generator: 'two-3' } },
      ...{ terms: { mvs_cross: 1 }, options: { levels: [0, 3] } },
    },
  },
  'a surface without symmetry': {
    input: 'moved.obj',
    args: ['--functional', 'mvs_cross', '--levels', '1..2', '--max-iterations', '12', '--certify'],
  },
  "a surface without symmetry, in Newton's metric": {
    input: 'moved.obj',
    args: ['--functional', 'mvs_cross', '--levels', '1', '--max-iterations', '8', '--metric', 'newton'],
  },
  'a surface without symmetry, in the Sobolev metric, with flat caps': {
    input: 'moved.obj',
    args: ['--functional', 'bending', '--levels', '2', '--max-iterations', '12', '--cap', 'flat'],
  },
  'an open surface whose boundary is held': {
    input: '-',
    args: ['--boundary', 'tangent', '--max-iterations', '10'],
    problem: {
      ...{ umbilic: 'problem', version: 1, cage: { generator: 'cylinder', segments: [16, 4] } },
      ...{ terms: { bending: 1, mvs_cross: 0.01 }, options: { levels: [0, 1] } },
    },
  },
};

describe.each(Object.entries(runs))('%s', (_, { input, args, problem }) => {
  test('has the same report and the same meshes from any number of threads', () => {
    const [report, control, limit] = results(input, args, 1, problem);
    expect(JSON.parse(report).levels.length).toBeGreaterThan(0);
    for (const threads of [2, 3, 7]) {
      const others = results(input, args, threads, problem);
      expect(others[0]).toBe(report);
      expect(others[1] === control && others[2] === limit).toBe(true);
    }
  });
});

test('the energies of a cage are the same from any number of threads', () => {
  const energies = (/** @type {number} */ threads) =>
    outputOf(['evaluate', 'moved.obj', '--levels', '3', '--json', '--threads', String(threads)], scratch);
  for (const threads of [2, 3, 7]) expect(energies(threads)).toBe(energies(1));
});

test('numbers of threads that cannot be are refused', () => {
  for (const count of ['0', '257', '-1', 'all']) {
    const { code, err } = umbilic(['evaluate', 'moved.obj', '--threads', count], scratch);
    expect(code).toBe(2);
    expect(err).toContain(`--threads: '${count}' is not an integer from 1 to 256`);
  }
});

test('a run on several threads ends when it is interrupted, and keeps what it has', async () => {
  const line = ['optimize', 'moved.obj', '--functional', 'mvs_cross', '--levels', '1..3', '--threads', '3'];
  const run = start([...line, '-o', 'interrupted.obj'], scratch.folder);
  await run.says(/level 1/);
  run.child.kill('SIGINT');
  expect(await run.ended).toEqual({ code: 130, signal: null });
  expect(scratch.read('interrupted.obj')).toMatch(/^v .*\nv /m);
});
