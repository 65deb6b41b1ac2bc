// SPDX-License-Identifier: MIT
/**
 * @file Problems as files: printed, read, gone on from, and the schema that describes them and reports.
 */
import Ajv from 'ajv';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

beforeAll(() => {
  outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);
});

const two3 = {
  umbilic: 'problem',
  version: 1,
  cage: { generator: 'two-3' },
  terms: { bending: 1 },
  options: { levels: [0, 1] },
};

/** @param {any} problem @param {string[]} args @returns {any} the report of its run */
const reportOf = (problem, ...args) =>
  jsonOf(['optimize', '-', '-q', '--report', '-', ...args], { input: JSON.stringify(problem), folder: scratch.folder });

describe('a problem', () => {
  test('printed from flags is what the flags ask', () => {
    const line = 'optimize frame.obj --weights bending=0.95,mvs_cross=0.05 --levels 1..3 --cap flat --no-symmetry';
    const printed = jsonOf([...line.split(' '), '--metric', 'sobolev', '--print-problem'], scratch);
    expect(printed).toEqual({
      umbilic: 'problem',
      version: 1,
      cage: { name: 'frame.obj', text: scratch.read('frame.obj') },
      terms: { bending: 0.95, mvs_cross: 0.05 },
      constraints: {},
      options: {
        cap: 'flat',
        cap_rings: 4,
        levels: [1, 3],
        max_iterations: 1000,
        tolerance: 1e-6,
        symmetry: false,
        metric: 'sobolev',
      },
    });
  });

  test('printed from a problem is the same problem, to the byte', () => {
    const once = outputOf(['optimize', 'frame.obj', '--functional', 'mvs', '--print-problem'], scratch);
    expect(outputOf(['optimize', '-', '--print-problem'], { input: once })).toBe(once);
  });

  test('from a file has the result that its flags have', () => {
    const flags = 'optimize frame.obj --functional bending --levels 0..1 -q --report -';
    scratch.write('problem.json', JSON.stringify({ ...two3, cage: { file: 'frame.obj' } }));
    const timeless = (/** @type {any} */ report) => report.levels.map((/** @type {any} */ l) => ({ ...l, seconds: 0 }));
    const [asked, flagged] = ['optimize problem.json -q --report -', flags].map((line) =>
      jsonOf(line.split(' '), scratch),
    );
    expect(timeless(asked)).toEqual(timeless(flagged));
    expect(asked.energies).toEqual(flagged.energies);
    expect(asked.surface).toEqual(flagged.surface);
  });

  test('names its cage’s file from its own folder', () => {
    const here = scratch.write('elsewhere.json', JSON.stringify({ ...two3, cage: { file: 'frame.obj' } }));
    expect(jsonOf(['optimize', here, '--print-problem']).cage.text).toBe(scratch.read('frame.obj'));
    scratch.write('lost.json', JSON.stringify({ ...two3, cage: { file: 'nowhere.obj' } }));
    expect(umbilic(['optimize', 'lost.json'], scratch)).toMatchObject({
      code: 3,
      err: 'umbilic: lost.json: cannot read nowhere.obj: No such file or directory\n',
    });
  });

  test('is changed by flags', () => {
    const report = reportOf(two3, '--levels', '1', '--max-iterations', '0');
    expect(report.problem.options).toMatchObject({ levels: [1, 1], max_iterations: 0 });
    expect(report.levels).toHaveLength(1);
  });

  test.each([
    ['{"umbilic": "problem",}', 'standard input: line 1, column 23: this is no JSON'],
    [JSON.stringify({ ...two3, version: 2 }), 'version: 2 is not known to this program, which reads versions up to 1'],
    [JSON.stringify({ ...two3, options: { levels: [2, 1] } }), 'options.levels[1]: 1 is below levels[0], 2'],
    [JSON.stringify({ ...two3, termz: {} }), "'termz': unknown; known are umbilic, version, cage, terms"],
    [JSON.stringify({ ...two3, cage: { text: 'v 0 0 0\nf 1 1' } }), 'line 2: face 1 names vertex 1 twice'],
    [JSON.stringify({ ...two3, cage: { generator: 'two-2' } }), 'there is no cage called two-2'],
  ])('that cannot be read ends with 3 and names the member: %s', (input, words) => {
    const { code, out, err } = umbilic(['optimize', '-'], { input });
    expect(err).toContain(words);
    expect({ code, out }).toEqual({ code: 3, out: '' });
  });
});

describe('a report', () => {
  test('of a run that was cut short goes on where it ended, level and surface', () => {
    const cut = reportOf({ ...two3, options: { levels: [1, 2], max_iterations: 2 } }, '--levels', '1');
    expect(cut.levels[0].stop).toBe('max_iterations');
    const still = reportOf(cut, '--max-iterations', '0');
    expect(Math.abs(still.energies.bending / cut.energies.bending - 1)).toBeLessThan(1e-12);
    const done = reportOf(cut, '--max-iterations', '1000', '--levels', '0..2');
    expect(done.levels.map((/** @type {any} */ l) => [l.level, l.stop])).toEqual([
      [1, 'converged'],
      [2, 'converged'],
    ]);
    const whole = reportOf({ ...two3, options: { levels: [1, 2] } });
    // Both have converged to 1e-6.
    expect(Math.abs(done.energies.bending / whole.energies.bending - 1)).toBeLessThan(2e-6);
  });

  test('holds a cage that may be gone', () => {
    outputOf(['cage', 'cube', '-o', 'gone.obj'], scratch);
    const report = jsonOf('optimize gone.obj --functional bending --levels 1 -q --report -'.split(' '), scratch);
    scratch.write('gone.obj', '');
    expect(reportOf(report).cage).toEqual(report.cage);
  });
});

describe('the schema', () => {
  const schema = jsonOf(['optimize', '--print-schema']);
  const validate = new Ajv({ allErrors: true }).compile(schema);
  /** @param {any} document @returns {string} what is wrong with it */
  const faults = (document) => (validate(document) ? '' : JSON.stringify(validate.errors));

  test('has words for every member', () => {
    /** @param {any} node @param {string} place */
    const visit = (node, place) => {
      for (const [name, member] of Object.entries(node.properties ?? {})) {
        const known = name === 'umbilic' || name === 'version' || place.endsWith('terms');
        if (!known) expect([place, name, member.description]).toEqual([place, name, expect.stringMatching(/\w{3}/)]);
        visit(member, `${place}.${name}`);
      }
      for (const part of [node.items, ...(node.oneOf ?? [])]) if (part) visit(part, place);
    };
    visit(schema, '');
  });

  test('holds for problems and reports that the program prints', () => {
    const problem = jsonOf(['optimize', 'frame.obj', '--functional', 'mvs', '--print-problem'], scratch);
    expect(faults(problem)).toBe('');
    expect(faults(two3)).toBe('');
    const torus = { ...two3, cage: { generator: 'torus', segments: [5, 4] } };
    expect(faults(torus)).toBe('');
    const report = reportOf(torus, '--certify', '--cap', 'none', '--levels', '0', '--max-iterations', '3');
    expect(report.limit.error).toBeNull();
    expect(faults(report)).toBe('');
    expect(faults({ ...problem, start: report.surface })).toBe('');
  });

  test.each([
    [{ ...two3, version: 2 }],
    [{ ...two3, terms: { bend: 1 } }],
    [{ ...two3, terms: { bending: -1 } }],
    [{ ...two3, options: { cap: 'round' } }],
    [{ ...two3, options: { levels: [1] } }],
    [{ ...two3, options: { levels: [0, 1], speed: 3 } }],
    [{ ...two3, cage: { generator: 'cube', text: '' } }],
    [{ ...two3, cage: {} }],
    [{ ...two3, start: { level: 1 } }],
  ])('refuses %j, as the program does', (problem) => {
    expect(faults(problem)).not.toBe('');
    expect(umbilic(['optimize', '-'], { input: JSON.stringify(problem) }).code).toBe(3);
  });
});
