// SPDX-License-Identifier: MIT
/**
 * @file `umbilic optimize`: results, reports, progress, and runs that are cut short.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { existsSync, readdirSync } from 'node:fs';
import { jsonOf, outputOf, scratchFolder, shell, start, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

beforeAll(() => {
  outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);
  outputOf(['cage', 'cube', '-o', 'cube.obj'], scratch);
  outputOf(['cage', 'dodecahedron-frame', '-o', 'large.obj'], scratch);
});

describe('a run', () => {
  /** @type {any} */
  let report;
  let table = '';
  let progress = '';

  beforeAll(() => {
    const line =
      'optimize frame.obj --functional bending --levels 0..1 -o out.obj --limit-mesh limit.obj --report report.json';
    const { code, out, err } = umbilic(line.split(' '), { folder: scratch.folder });
    expect(code).toBe(0);
    table = out;
    progress = err;
    report = JSON.parse(scratch.read('report.json'));
  });

  test('reports input, functional, cap, energies and levels', () => {
    expect(Object.keys(report)).toEqual([
      'umbilic',
      'version',
      'program',
      'instruction_set',
      'problem',
      'cage',
      'group',
      'estimate',
      'levels',
      'limit',
      'energies',
      'surface',
    ]);
    expect(report).toMatchObject({
      umbilic: 'report',
      version: 1,
      problem: {
        cage: { name: 'frame.obj', text: scratch.read('frame.obj') },
        terms: { bending: 1 },
        constraints: {},
        options: {
          cap: 'smooth',
          levels: [0, 1],
          max_iterations: 1000,
          tolerance: 1e-6,
          symmetry: true,
          metric: 'auto',
        },
      },
      cage: { vertices: 22, faces: 24, genus: 2 },
      surface: { level: 1 },
    });
    const level = {
      level: expect.any(Number),
      patches: expect.any(Number),
      unknowns: expect.any(Number),
      energy: expect.any(Number),
      energy_reported: expect.any(Number),
      iterations: expect.any(Number),
      evaluations: expect.any(Number),
      seconds: expect.any(Number),
      stop: expect.stringMatching(/^(converged|round_off)$/),
      metric: 'hessian',
      metrics: expect.any(Number),
      factorizations: expect.any(Number),
      parametrization_stages: 0,
      quadrature: 0,
      evaluable: true,
      cap_rings: expect.any(Number),
      narrower_caps_energy: null,
      narrower_caps_evaluations: 0,
      credible: true,
      thickened: false,
      predicted_decrease: expect.any(Number),
    };
    expect(report.levels).toEqual([level, level]);
    expect(report.levels).toMatchObject([
      { level: 0, patches: 24, unknowns: 8 },
      { level: 1, patches: 96, unknowns: 29 },
    ]);
  });

  test('lowers the energy, and reports the last level', () => {
    const before = jsonOf(['evaluate', 'frame.obj', '--json', '--levels', '1'], scratch).energies.bending;
    expect(report.energies.bending).toBeLessThan(0.9 * before);
    expect(report.energies.bending).toBe(report.levels[1].energy_reported);
    const error = Math.abs(report.levels[1].energy - report.levels[1].energy_reported);
    expect(report.energies.quadrature_error).toBeCloseTo(error, 12);
  });

  test('writes a control mesh that evaluates to the reported energies', () => {
    const evaluated = jsonOf(['evaluate', 'out.obj', '--levels', '0', '--json'], scratch);
    expect(evaluated).toMatchObject({ level: 0, patches: 96 });
    const flat = (/** @type {any} */ { invariants, ...energies }) => ({ ...energies, ...invariants });
    const again = flat(evaluated.energies);
    for (const [name, value] of Object.entries(flat(report.energies))) {
      if (typeof value === 'boolean') expect(again[name]).toBe(value);
      else if (name !== 'quadrature_error') expect(Math.abs(again[name] / value - 1)).toBeLessThan(1e-12);
    }
  });

  test('writes the limit surface as a closed mesh of its genus, with unit normals that point outward', () => {
    const info = jsonOf(['info', 'limit.obj', '--json'], scratch);
    expect(info).toMatchObject({ cage: { faces: 96 * 4 * 4, genus: 2 }, face_sizes: { 4: 96 * 4 * 4 } });
    const rows = (/** @type {string} */ keyword) =>
      [...scratch.read('limit.obj').matchAll(new RegExp(`^${keyword} (.*)$`, 'gm'))].map(([, row]) => row.split(' '));
    const positions = rows('v').map((row) => row.map(Number));
    const normals = rows('vn').map((row) => row.map(Number));
    expect(normals).toHaveLength(positions.length);
    for (const normal of normals) expect(Math.abs(Math.hypot(...normal) - 1)).toBeLessThan(1e-12);
    for (const corners of rows('f')) {
      const [a, b, c, d] = corners.map((corner) => {
        const [vertex, texture, normal] = corner.split('/');
        expect([texture, normal]).toEqual(['', vertex]);
        return Number(vertex) - 1;
      });
      const side = (/** @type {number} */ from, /** @type {number} */ to) =>
        positions[to].map((x, axis) => x - positions[from][axis]);
      const [u, v] = [side(a, c), side(b, d)];
      const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const along = cross.reduce((sum, x, axis) => sum + x * normals[a][axis], 0);
      expect(along / Math.hypot(...cross)).toBeGreaterThan(0.5);
    }
  });

  test('shows levels and energies in a table', () => {
    expect(table).toMatch(
      /^frame.obj: 22 vertices, 48 edges, 24 faces, genus 2\nminimized bending, cap smooth, symmetry D3h, order 12\n {2}level {2}patches/,
    );
    for (const { level, patches, unknowns, metric, stop } of report.levels) {
      expect(table).toMatch(new RegExp(`^ +${level} +${patches} +${unknowns} .*  ${metric} +${stop}$`, 'm'));
    }
    expect(table).toContain('energies of the last level\n  bending ');
  });

  test('tells each level on standard error when that is no terminal', () => {
    expect(progress.split('\n')).toEqual([
      expect.stringMatching(/^level 0: 24 patches, \d+ evaluations, energy 1\d\d\.\d+, \w+ after [\d.]+ s$/),
      expect.stringMatching(/^level 1: 96 patches, \d+ evaluations, energy 11\d\.\d+, \w+ after [\d.]+ s$/),
      '',
    ]);
  });
});

describe('options', () => {
  test('--quiet leaves standard error empty', () => {
    const { code, err } = umbilic(['optimize', 'cube.obj', '--functional', 'willmore', '-q', '--levels', '1'], {
      folder: scratch.folder,
    });
    expect({ code, err }).toEqual({ code: 0, err: '' });
  });

  test('--weights are terms of the problem', () => {
    const line = 'optimize frame.obj --weights bending=0.95,mvs_cross=0.05 --levels 0 --max-iterations 3 --report -';
    const report = jsonOf(line.split(' '), scratch);
    expect(report.problem.terms).toEqual({ bending: 0.95, mvs_cross: 0.05 });
    const { bending, mvs_cross } = report.energies;
    expect(report.levels[0].energy_reported).toBeCloseTo(0.95 * bending + 0.05 * mvs_cross, 6);
    expect(report.levels[0]).toMatchObject({ iterations: 3, stop: 'max_iterations' });
  });

  test('a level that went on with finer quadrature rules says by how many steps', () => {
    outputOf(['cage', 'dodecahedron-frame', '-o', 'dodecahedron.obj'], scratch);
    const line = 'optimize dodecahedron.obj --functional bending --levels 0..2 --report -';
    const { levels } = jsonOf(line.split(' '), scratch);
    expect(levels.map((/** @type {any} */ l) => l.quadrature)).toEqual([0, 0, 1]);
    expect(levels[2].stop).toBe('converged');
    expect(Math.abs(levels[2].energy / levels[2].energy_reported - 1)).toBeLessThan(1e-4);
  });

  test('--max-iterations 0 evaluates only', () => {
    const line = 'optimize frame.obj --functional bending --levels 1 --max-iterations 0 --report -';
    const { energies } = jsonOf(line.split(' '), scratch);
    const evaluated = jsonOf(['evaluate', 'frame.obj', '--levels', '1', '--json'], scratch).energies;
    expect(Math.abs(energies.bending / evaluated.bending - 1)).toBeLessThan(1e-12);
  });

  test('--levels counts from the cage, whose points move on the first mesh that can be evaluated', () => {
    const levels = (/** @type {string} */ range) =>
      jsonOf(
        [
          'optimize',
          'cube.obj',
          '--functional',
          'bending',
          '--levels',
          range,
          '--max-iterations',
          '1',
          '--report',
          '-',
        ],
        scratch,
      ).levels.map((/** @type {any} */ l) => [l.level, l.patches, l.evaluable]);
    expect(levels('0')).toEqual([[0, 24, false]]);
    expect(levels('0..2')).toEqual([
      [0, 24, false],
      [1, 24, true],
      [2, 96, true],
    ]);
    expect(levels('2')).toEqual([[2, 96, true]]);
  });

  test('a looser --tolerance ends earlier', () => {
    const evaluations = (/** @type {string} */ tolerance) =>
      jsonOf(
        [
          'optimize',
          'frame.obj',
          '--functional',
          'bending',
          '--levels',
          '1',
          '--tolerance',
          tolerance,
          '--report',
          '-',
        ],
        scratch,
      ).levels[0].evaluations;
    expect(evaluations('1e-1')).toBeLessThan(evaluations('1e-6'));
  });

  test('-o - writes the control mesh and nothing else to standard output', () => {
    const text = outputOf(['optimize', 'cube.obj', '--functional', 'bending', '--levels', '1', '-o', '-'], scratch);
    expect(text).toMatch(/^v /);
    expect(jsonOf(['info', '-', '--json'], { input: text }).cage).toMatchObject({ faces: 24, genus: 0 });
  });

  test('--density refines the limit mesh', () => {
    outputOf(
      'optimize cube.obj --functional bending --levels 1 --limit-mesh dense.obj --density 7'.split(' '),
      scratch,
    );
    expect(jsonOf(['info', 'dense.obj', '--json'], scratch).cage.faces).toBe(24 * 49);
  });
});

describe('a terminal', () => {
  const command = '$UMBILIC optimize frame.obj --functional mvs_cross --no-symmetry --levels 2';

  test('shows one line that updates', () => {
    const { code, out } = shell(`script -qec "${command}" /dev/null < /dev/null`, scratch.folder);
    expect(code).toBe(0);
    expect(out).toContain('\rlevel 2: ');
    expect(out).toMatch(
      /\rlevel 2: \d+ evaluations, energy [\d.]+, to gain [-+\de.]+, \d+ % done, (a second|about \d+ s|about \d+ min) left/,
    );
    expect(out.split('\r').filter((line) => line.startsWith('level 2: ')).length).toBeGreaterThan(2);
    expect(out).toContain('\r\x1b[Klevel 2: 384 patches');
  });
});

describe('Ctrl-C', () => {
  test('ends the run, keeps the results and has a code of its own', async () => {
    const line = 'optimize large.obj --functional mvs_cross --levels 0..4 -o kept.obj --report kept.json';
    const running = start(line.split(' '), scratch.folder);
    await running.says(/^level 0: .*\n/);
    running.child.kill('SIGINT');
    expect(await running.ended).toEqual({ code: 130, signal: null });
    const report = JSON.parse(scratch.read('kept.json'));
    expect(report.levels.at(-1).stop).toBe('cancelled');
    expect(report.levels[0].stop).not.toBe('cancelled');
    const { energies } = jsonOf(['evaluate', 'kept.obj', '--json'], scratch);
    expect(Math.abs(energies.mvs_cross / report.energies.mvs_cross - 1)).toBeLessThan(1e-12);
  });

  test('twice ends the program, which leaves nothing half written', async () => {
    // One evaluation of so fine a surface takes longer than a few signals.
    const line = 'optimize large.obj --functional mvs_cross --no-symmetry --levels 5 -o never.obj';
    const running = start(line.split(' '), scratch.folder);
    const again = setInterval(() => running.child.kill('SIGINT'), 20);
    const { signal } = await running.ended;
    clearInterval(again);
    expect(signal).toBe('SIGINT');
    expect(existsSync(scratch.path('never.obj'))).toBe(false);
    expect(readdirSync(scratch.folder).filter((name) => name.startsWith('never'))).toEqual([]);
  });
});
