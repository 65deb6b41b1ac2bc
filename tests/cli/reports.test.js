// SPDX-License-Identifier: MIT
/**
 * @file What the commands report, as JSON and as tables.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { functionals, jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const invariants = ['gradient_form', 'variation_form', 'triple_form'];
const energyNames = [...functionals, 'area', 'gaussian'];

beforeAll(() => {
  for (const [name, file] of [
    ['cube', 'cube.obj'],
    ['two-3', 'frame.obj'],
    ['torus', 'torus.obj'],
  ]) {
    outputOf(['cage', name, '-o', file], scratch);
  }
});

describe('info', () => {
  test('reports counts, components, valences and the first level', () => {
    const counts = { vertices: 22, edges: 48, faces: 24, genus: 2 };
    expect(jsonOf(['info', 'frame.obj', '--json'], scratch)).toEqual({
      umbilic: 'cage',
      version: 1,
      program: expect.stringMatching(/^\d+\.\d+\.\d+$/),
      cage: {
        ...counts,
        components: [{ ...counts, boundaries: 0 }],
        boundaries: [],
        groups: [],
        repairs: [],
        notes: [],
      },
      valences: { 4: 18, 6: 4 },
      face_sizes: { 4: 24 },
      first_level: 0,
    });
  });

  test('adds the genus of components up', () => {
    const torus = outputOf(['cage', 'torus']);
    const far = torus.replace(/^v (\S+)/gm, (_, x) => `v ${Number(x) + 10}`);
    const input =
      torus +
      far.replace(
        /^f (.*)$/gm,
        (_, corners) => `f ${corners.replace(/\d+/g, (/** @type {string} */ v) => Number(v) + 48)}`,
      );
    const report = jsonOf(['info', '-', '--json'], { input }).cage;
    expect(report.components.map((/** @type {{ genus: number }} */ c) => c.genus)).toEqual([1, 1]);
    expect(report.genus).toBe(2);
    expect(outputOf(['info', '-'], { input })).toContain('component 2: 48 vertices, 96 edges, 48 faces, genus 1');
  });
});

describe('evaluate', () => {
  test('computes with the kernels that were asked for, to the same energies', () => {
    const [chosen, portable] = [[], ['--instruction-set', 'portable']].map((options) =>
      jsonOf([...options, 'evaluate', 'frame.obj', '--json'], scratch),
    );
    expect(chosen.instruction_set).toMatch(/^(portable|avx2|avx512)$/);
    expect(portable.instruction_set).toBe('portable');
    for (const name of energyNames) {
      expect(Math.abs(portable.energies[name] / chosen.energies[name] - 1)).toBeLessThan(1e-12);
    }
  });

  test('reports every energy, the cap, the level and the quadrature error', () => {
    const report = jsonOf(['evaluate', 'frame.obj', '--json', '--levels', '1', '--cap', 'flat'], scratch);
    expect(Object.keys(report)).toEqual([
      'umbilic',
      'version',
      'program',
      'instruction_set',
      'cage',
      'cap',
      'cap_rings',
      'level',
      'patches',
      'energies',
    ]);
    expect(Object.keys(report.energies)).toEqual([
      ...energyNames,
      'quadrature_error',
      'resolved',
      'below_bound',
      'embedded',
      'invariants',
    ]);
    expect(Object.keys(report.energies.invariants)).toEqual(invariants);
    expect(report).toMatchObject({ umbilic: 'evaluation', version: 1, cap: 'flat', level: 1, patches: 96 });
    expect(report.energies.gaussian).toBeCloseTo(-4 * Math.PI, 1);
    expect(report.energies.quadrature_error).toBeGreaterThanOrEqual(0);
  });

  test('satisfies bending = 4 willmore - 2 gaussian', () => {
    for (const file of ['cube.obj', 'frame.obj', 'torus.obj']) {
      const { energies } = jsonOf(['evaluate', file, '--json', '--levels', '2'], scratch);
      const { bending, willmore, gaussian } = energies;
      expect(Math.abs(bending - (4 * willmore - 2 * gaussian)) / bending).toBeLessThan(1e-12);
    }
  });

  test('raises the level to what the cage needs', () => {
    expect(jsonOf(['evaluate', 'cube.obj', '--json'], scratch)).toMatchObject({ level: 1, patches: 24 });
    expect(outputOf(['evaluate', 'cube.obj'], scratch)).toContain('level 1, 24 patches, cap smooth');
  });

  test('says that third-order energies diverge without a cap, and only where there is an extraordinary vertex', () => {
    const { energies } = jsonOf(['evaluate', 'cube.obj', '--cap', 'none', '--json'], scratch);
    expect(functionals.filter((name) => energies[name] === null)).toEqual(functionals.slice(2));
    expect(Object.values(energies.invariants)).toEqual([null, null, null]);
    expect(outputOf(['evaluate', 'cube.obj', '--cap', 'none'], scratch).match(/diverges/g)).toHaveLength(9);
    const torus = jsonOf(['evaluate', 'torus.obj', '--cap', 'none', '--json'], scratch).energies;
    expect(functionals.filter((name) => torus[name] === null)).toEqual([]);
  });

  test('shows the numbers of the JSON in its table, with the ratios that explain them', () => {
    const { energies } = jsonOf(['evaluate', 'frame.obj', '--json', '--levels', '2'], scratch);
    const table = outputOf(['evaluate', 'frame.obj', '--levels', '2'], scratch);
    for (const name of energyNames) {
      const shown = Number(new RegExp(`^  ${name} +(\\S+)`, 'm').exec(table)?.[1]);
      expect(Math.abs(shown / energies[name] - 1)).toBeLessThan(1e-9);
    }
    const ratio = (/** @type {string} */ name) =>
      Number(new RegExp(`^  ${name} .* = (\\S+) \\* `, 'm').exec(table)?.[1]);
    expect(ratio('bending')).toBeCloseTo(energies.bending / (8 * Math.PI), 4);
    expect(ratio('willmore')).toBeCloseTo(energies.willmore / (4 * Math.PI), 4);
    expect(ratio('gaussian')).toBeCloseTo(-1, 2);
    expect(table).toMatch(/quadrature error of bending: \d\.\de-\d\d/);
    const [, odd] = table.split('invariants that change their sign with the side of the surface\n');
    for (const name of invariants) {
      const shown = Number(new RegExp(`^  ${name} +(\\S+)   = A`, 'm').exec(odd)?.[1]);
      expect(Math.abs(shown / energies.invariants[name] - 1)).toBeLessThan(1e-9);
    }
  });

  test('gives the invariants of the outward side of a closed surface, and of the side to which an open one is turned', () => {
    const closed = outputOf(['cage', 'torus']);
    const open = closed.replace(/\nf .*\nf .*\n/, '\n');
    const turned = (/** @type {string} */ cage) =>
      cage.replace(/^f (.*)$/gm, (_, corners) => `f ${corners.split(' ').reverse().join(' ')}`);
    const energiesOf = (/** @type {string} */ input) =>
      jsonOf(['evaluate', '-', '--json', '--levels', '1'], { input }).energies;
    for (const [cage, side] of /** @type {Array<[string, number]>} */ ([
      [closed, 1],
      [open, -1],
    ])) {
      const [one, other] = [cage, turned(cage)].map(energiesOf);
      for (const name of invariants) {
        expect(Math.abs(other.invariants[name] / one.invariants[name] - side)).toBeLessThan(1e-9);
      }
      for (const name of functionals) expect(Math.abs(other[name] / one[name] - 1)).toBeLessThan(1e-9);
    }
    expect(energiesOf(closed).invariants.gradient_form).toBeGreaterThan(0);
  });
});

describe('check-gradient', () => {
  test('agrees for every functional and cap, and says how well', () => {
    for (const functional of functionals) {
      const caps =
        functional === 'bending' || functional === 'willmore' ? ['none', 'flat', 'smooth'] : ['flat', 'smooth'];
      for (const cap of caps) {
        const report = jsonOf(
          ['check-gradient', 'frame.obj', '--functional', functional, '--cap', cap, '--json'],
          scratch,
        );
        expect(report).toMatchObject({ umbilic: 'gradient', terms: { [functional]: 1 }, cap });
        expect(report).toMatchObject({ level: 0, unknowns: 66, ok: true });
        expect(report.relative_mismatch).toBeLessThanOrEqual(report.tolerance);
        expect(Math.abs(report.analytic)).toBeGreaterThan(0);
      }
    }
  });

  test('takes weights and prints a table', () => {
    const table = outputOf(['check-gradient', 'frame.obj', '--weights', 'bending=0.95,mvs_cross=0.05'], scratch);
    expect(table).toContain('gradient of 0.95 bending + 0.05 mvs_cross at level 0, cap smooth: 66 unknowns');
    expect(table).toMatch(/relative mismatch .* ok\n$/);
  });
});

describe('numbers', () => {
  test('do not depend on the locale of the environment', () => {
    const environment = { LC_ALL: 'de_DE.UTF-8', LANG: 'de_DE.UTF-8' };
    const here = umbilic(['evaluate', 'frame.obj', '--json'], { folder: scratch.folder });
    expect(umbilic(['evaluate', 'frame.obj', '--json'], { folder: scratch.folder, environment })).toEqual(here);
  });
});

describe('a second opinion', () => {
  test('of a surface as it is stands beside its energies and agrees with them', () => {
    const { energies, second_opinion } = jsonOf(['evaluate', 'torus.obj', '--second-opinion', '--json'], scratch);
    for (const name of energyNames) {
      const difference = energies[name] - second_opinion.values[name];
      expect(second_opinion.differences[name]).toBeCloseTo(difference, 9);
      expect(Math.abs(difference)).toBeLessThan(1e-5 * Math.abs(energies[name]) + 1e-10);
      expect(second_opinion.errors[name]).toBeGreaterThanOrEqual(0);
    }
    for (const name of invariants) expect(second_opinion.values[name]).toBeCloseTo(energies.invariants[name], 0);
    expect(second_opinion.samples).toBe(48 * 17 * 17);
  });

  test('has no third order where there is no cap', () => {
    const args = ['evaluate', 'cube.obj', '--cap', 'none', '--second-opinion'];
    const { values, differences } = jsonOf([...args, '--json'], scratch).second_opinion;
    expect(values.mvs_cross).toBeNull();
    expect(Math.abs(differences.bending)).toBeLessThan(1e-6 * values.bending);
    const table = outputOf(args, scratch).split('second opinion')[1];
    expect(table).toMatch(/^, of \d+ points {2,}value {2,}difference {2,}its own error\n {2}bending +25\.49\d+ /);
    expect(table).not.toContain('mvs');
  });

  test('of a run is in its table and its report, and the problem of that asks for it again', () => {
    const args = [
      'optimize',
      'frame.obj',
      '--functional',
      'bending',
      '--levels',
      '0..0',
      '--quiet',
      '--second-opinion',
    ];
    const report = jsonOf([...args, '--report', '-'], scratch);
    expect(report.problem.options.second_opinion).toBe(true);
    const { values, differences } = report.second_opinion;
    expect(values.bending + differences.bending).toBeCloseTo(report.energies.bending, 9);
    expect(outputOf(args, scratch)).toContain('second opinion, of ');
    const plain = outputOf([...args.slice(0, -1), '--print-problem'], scratch);
    expect(plain).not.toContain('second_opinion');
  });
});
