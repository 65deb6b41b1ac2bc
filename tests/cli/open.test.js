// SPDX-License-Identifier: MIT
/**
 * @file Open surfaces: evaluated, minimized with what is held at their boundaries, and refused where that cannot be.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { jsonOf, outputOf, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

/** Points on half a sphere, on 4 circles of 8 and at the pole. */
const dome = (() => {
  const around = 8;
  const rings = [0, 1, 2, 3];
  const turn = (/** @type {number} */ k) => (2 * Math.PI * k) / around;
  const steps = [...Array(around).keys()];
  const points = rings.flatMap((ring) => {
    const [height, radius] = [Math.sin((ring * Math.PI) / 8), Math.cos((ring * Math.PI) / 8)];
    return steps.map((k) => `v ${radius * Math.cos(turn(k))} ${radius * Math.sin(turn(k))} ${height}`);
  });
  const at = (/** @type {number} */ ring, /** @type {number} */ k) => ring * around + (k % around) + 1;
  const quads = rings
    .slice(1)
    .flatMap((ring) =>
      steps.map((k) => `f ${at(ring - 1, k)} ${at(ring - 1, k + 1)} ${at(ring, k + 1)} ${at(ring, k)}`),
    );
  const fan = steps.map((k) => `f ${at(3, k)} ${at(3, k + 1)} ${4 * around + 1}`);
  return `${[...points, 'v 0 0 1', ...quads, ...fan].join('\n')}\n`;
})();

/** @param {object} cage @param {object} terms @param {object} [rest] @returns {any} the report of the run at the first level */
const reportOf = (cage, terms, rest = {}) =>
  jsonOf(['optimize', '-', '-q', '--report', '-'], {
    input: JSON.stringify({ umbilic: 'problem', version: 1, cage, terms, options: { levels: [0, 0] }, ...rest }),
  });

describe('an open surface', () => {
  test('is evaluated: its curvature and the turning of its boundary sum to 2 pi times its characteristic', () => {
    const { energies } = jsonOf(['evaluate', '-', '--json'], { input: dome });
    expect(Math.abs(energies.gaussian + energies.boundary_turning - 2 * Math.PI)).toBeLessThan(1e-3);
    expect(energies.resolved).toBe(true);
  });

  test('is minimized with its tangents held, and the table says what became of it', () => {
    const out = outputOf(['optimize', '-', '--functional', 'bending', '--boundary', 'tangent', '--levels', '0', '-q'], {
      input: dome,
    });
    expect(out).toMatch(/^standard input: \d+ vertices, \d+ edges, \d+ faces, genus 0, 1 boundary$/m);
    expect(out).toMatch(/^ {2}bending +10\.\d+ {3}= /m); // a part of a sphere: twice its Willmore energy
    expect(out).toMatch(/^ {2}willmore +5\.\d+ {3}= /m);
    expect(out).toMatch(/^ {2}boundary_turning +-?\d/m);
    expect(out).toMatch(/^ {2}largest deviation from the cage's own surface \d/m);
  });

  test('has the faces of a group beyond its boundary, as generated cages have them', () => {
    const generated = outputOf(['cage', 'cylinder', '--segments', '16x4']);
    const run = ['optimize', '-', '--functional', 'willmore', '--levels', '0', '-q', '--report', '-'];
    const cage = { generator: 'cylinder', segments: [16, 4] };
    const { energies } = jsonOf([...run, '--holes', 'hole'], { input: generated });
    expect(energies.willmore / reportOf(cage, { willmore: 1 }).energies.willmore).toBeCloseTo(1, 9);
    // Without, they are part of the surface.
    expect(jsonOf(run, { input: generated }).energies.area).toBeGreaterThan(1.2 * energies.area);
  });

  test('holds its tangents unless something else is asked', () => {
    const run = (/** @type {string[]} */ ...args) =>
      jsonOf(['optimize', '-', '--functional', 'bending', '--levels', '0', '-q', '--report', '-', ...args], {
        input: dome,
      });
    const usual = run();
    const tangent = run('--boundary', 'tangent');
    expect(usual.energies).toEqual(tangent.energies);
    expect(tangent.problem.constraints).toEqual({ boundary: { condition: 'tangent', loops: [] } });
    const [free, position] = ['free', 'position'].map((condition) => run('--boundary', condition).energies.bending);
    for (const flat of [free, position]) expect(flat).toBeLessThan(1e-12); // the boundary lies in a plane
    expect(tangent.energies.bending).toBeGreaterThan(10);
  });

  test('whose cage says nothing of curvature at its boundary is refused where that is to be held', () => {
    const bare = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n';
    expect(umbilic(['optimize', '-', '--functional', 'bending', '--boundary', 'curvature'], { input: bare })).toEqual({
      code: 3,
      out: '',
      err:
        'umbilic: standard input: constraints.boundary: the cage says nothing of the curvature across its boundary ' +
        'at vertex 1: hold the faces next to it, or mark the outermost ones as holes\n',
    });
  });

  test('refuses conditions that there are none of', () => {
    const { code, err } = umbilic(['optimize', '-', '--functional', 'bending', '--boundary', 'clamped'], {
      input: dome,
    });
    expect(code).toBe(2);
    expect(err).toContain("'clamped' is none of free, position, tangent, curvature");
  });
});

describe('the boundaries that info lists', () => {
  const cage = { generator: 'cylinder', segments: [8, 4] };
  const problem = (/** @type {object} */ constraints) =>
    JSON.stringify({
      umbilic: 'problem',
      version: 1,
      cage,
      terms: { bending: 1 },
      constraints,
      options: { levels: [0, 0] },
    });

  test('are those of the surface, not of the holes beyond it', () => {
    const out = outputOf(['info', '-'], { input: problem({}) });
    expect(out).toBe(
      'cylinder: 40 vertices, 72 edges, 32 faces, 16 holes, genus 0, 2 boundaries\n' +
        '  boundary 1: 8 vertices, from vertex 1\n  boundary 2: 8 vertices, from vertex 33\n' +
        '  valences     16 x 3, 24 x 4\n  face sizes   32 x 4\n' +
        '  first level that can be evaluated: 0\n',
    );
    expect(jsonOf(['info', '-', '--json'], { input: problem({}) }).cage).toMatchObject({ faces: 32, holes: 16 });
  });

  test('have the numbers that conditions use', () => {
    const { boundaries } = jsonOf(['info', '-', '--json'], { input: problem({}) }).cage;
    for (const loop of [1, 2]) {
      for (const { number, first_vertex: from } of boundaries) {
        const input = problem({ boundary: { loops: [{ loop, from, to: from, condition: 'position' }] } });
        expect(umbilic(['optimize', '-', '-q', '--max-iterations', '0'], { input }).code).toBe(loop === number ? 0 : 3);
      }
    }
  });
});

describe('a generated open surface finds', () => {
  test('the clamped surface of revolution, and says so in its report', () => {
    const report = reportOf({ generator: 'cylinder', radius: 1, segments: [32, 12] }, { willmore: 1 });
    const expected = 3.1239888; // by spectral minimization of the profile
    expect(Math.abs(report.energies.willmore / expected - 1)).toBeLessThan(1e-4);
    expect(report.levels[0].stop).toBe('converged');
    expect(Math.abs(report.energies.gaussian + report.energies.boundary_turning)).toBeLessThan(1e-6);
    expect(report.constraints).toMatchObject({ held_faces: 0, regions: [], pins: [] });
    expect(report.constraints.free_faces).toBe(32 * 12); // without its holes
    expect(report.constraints.deviation).toBeGreaterThan(0.01);
  }, 60_000);

  test('the catenoid', () => {
    const report = reportOf({ generator: 'catenoid', height: 1 }, { bending: 1 });
    expect(Math.abs(report.energies.bending / (8 * Math.PI * Math.tanh(0.5)) - 1)).toBeLessThan(1e-4);
  }, 60_000);
});
