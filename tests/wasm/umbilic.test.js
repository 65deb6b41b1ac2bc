// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript face of the core against the real module: cages, errors, runs, meshes, and what happens to
 * memory.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import {
  Cage,
  InputError,
  Minimizer,
  cageNames,
  functionalNames,
  load,
  parseReport,
  version,
} from '../../wasm/umbilic.js';
import { functionals } from '../cli/program.js';
import { objCube, plyCube } from './ply_cube.js';

beforeAll(() => load());

/** A cube with side 2. */
const cube = `v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;

/** @param {Minimizer} minimizer */
function finish(minimizer) {
  while (!minimizer.step(20));
  return minimizer;
}

/** @param {import('../../wasm/types.js').Options & {terms?: import('../../wasm/types.js').Terms}} [asked] */
function cubeMinimizer({ terms = { bending: 1 }, ...options } = {}) {
  return new Minimizer({ cage: { generator: 'cube' }, terms, options: { levels: [1, 1], ...options } });
}

/** Six times the volume inside a triangle mesh. @param {import('../../wasm/types.js').Mesh} mesh */
function sixfoldVolume({ positions, triangles }) {
  let sum = 0;
  /** @param {number} vertex */
  const at = (vertex) => positions.subarray(3 * vertex, 3 * vertex + 3);
  for (let i = 0; i < triangles.length; i += 3) {
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [at(triangles[i]), at(triangles[i + 1]), at(triangles[i + 2])];
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum;
}

describe('the module', () => {
  test('loads once', () => expect(load()).toBe(load()));

  test('knows its version, its functionals and its cages', () => {
    expect(version()).toMatch(/^\d+\.\d+\.\d+/);
    expect(functionalNames()).toEqual(functionals);
    expect(cageNames()).toEqual(expect.arrayContaining(['cube', 'torus', 'two-3', 'two-12', 'dodecahedron-frame']));
  });
});

describe('a cage', () => {
  test('is read from the bytes of a binary file, with all digits', () => {
    const input = { name: 'cube.ply', text: plyCube() };
    const cage = new Cage(input);
    expect(cage.obj()).toBe(objCube());
    cage.dispose();
    const minimizer = new Minimizer({ cage: input, terms: { bending: 1 } });
    expect(minimizer.problem.cage).toEqual({ name: 'cube.ply', text: objCube() });
    minimizer.dispose();
    const bad = { ...input, text: plyCube(8) };
    for (const make of [() => new Cage(bad), () => new Minimizer({ cage: bad, terms: { bending: 1 } })]) {
      expect(make).toThrow(
        new InputError("cube.ply: 'face' 6: index 8 does not exist: 8 vertices have the indices 0 to 7"),
      );
    }
    expect(() => Cage.read(plyCube().subarray(0, 300))).toThrow(InputError);
  });

  test('is read from text and from bytes', () => {
    for (const text of [cube, new TextEncoder().encode(cube), `\uFEFF${cube.replaceAll('\n', '\r\n')}`]) {
      const cage = Cage.read(text);
      const counts = { vertices: 8, edges: 12, faces: 6, genus: 0 };
      expect(cage.counts).toEqual({
        ...counts,
        components: [{ ...counts, boundaries: 0 }],
        boundaries: [],
        groups: [],
        repairs: [],
        notes: [],
      });
      cage.dispose();
    }
  });

  test('written as OBJ is read back to the same positions', () => {
    const cage = Cage.generate('tetrahedron-frame', { family: 'hub' });
    const again = Cage.read(cage.obj());
    expect(again.counts).toEqual(cage.counts);
    expect(again.mesh()).toEqual(cage.mesh());
    expect(again.obj()).toBe(cage.obj());
    cage.dispose();
    again.dispose();
  });

  test.each([
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n', /line 4/],
    [`${cube}v 0 zero 0\n`, /line 15/],
    [cube.replace('f 4 3 2 1', 'f 4 3 2 9'), /line 9/],
    ['', /./],
  ])('with a mistake is refused with its place', (text, place) => {
    expect(() => Cage.read(text)).toThrow(InputError);
    expect(() => Cage.read(text)).toThrow(place);
  });

  test('whose message is longer than the scratch memory still says all of it', () => {
    const word = 'x'.repeat(500);
    expect(() => Cage.generate(word)).toThrow(word);
  });

  test('comes in two families and any thickness, and refuses others', () => {
    const [hub, flag, thin] = [
      Cage.generate('two-4', { family: 'hub' }),
      Cage.generate('two-4'),
      Cage.generate('two-4', { thickness: 0.7 }),
    ];
    expect(hub.counts.genus).toBe(3);
    expect(flag.counts.genus).toBe(3);
    expect(hub.counts.faces).not.toBe(flag.counts.faces);
    expect(thin.counts).toEqual(flag.counts);
    expect(thin.mesh().positions).not.toEqual(flag.mesh().positions);
    for (const cage of [hub, flag, thin]) cage.dispose();
    expect(() => Cage.generate('two-4', { thickness: -1 })).toThrow(InputError);
    expect(() => Cage.generate('no-such-cage')).toThrow(/no-such-cage/);
    // @ts-expect-error: only these two are known
    expect(() => Cage.generate('two-4', { family: 'spiral' })).toThrow(
      "family: 'spiral' is unknown, expected one of hub, flag",
    );
  });

  test('is disposed of once, and not used afterwards', () => {
    const cage = Cage.read(cube);
    cage.dispose();
    cage.dispose();
    expect(() => cage.counts).toThrow(/disposed/);
    expect(() => cage.mesh()).toThrow(/disposed/);
    expect(() => cage.obj()).toThrow(/disposed/);
  });
});

describe('a run', () => {
  test('of bending on the cube falls towards 8π, the sphere, and ends with a reason', () => {
    const minimizer = cubeMinimizer({ levels: [1, 2] });
    let energy = Infinity;
    let level = -1;
    let evaluations = 0;
    while (!minimizer.step(1)) {
      const { progress } = minimizer;
      expect(progress.total_evaluations - evaluations).toBeLessThanOrEqual(1);
      evaluations = progress.total_evaluations;
      if (progress.level !== level || Number.isNaN(progress.energy)) {
        level = progress.level;
        energy = Infinity;
      } else {
        expect(progress.energy).toBeLessThanOrEqual(energy);
        energy = progress.energy;
      }
    }
    expect(minimizer.progress.phase).toBe('done');
    expect(minimizer.levels.map((report) => report.level)).toEqual([1, 2]);
    for (const report of minimizer.levels) {
      expect(['converged', 'round_off']).toContain(report.stop);
      expect(report.patches).toBe(6 * 4 ** report.level);
      expect(report.evaluations).toBeGreaterThan(1);
      expect(Math.abs(report.energy_reported / report.energy - 1)).toBeLessThan(1e-3);
    }
    // The minimum over a finite mesh is above that over all surfaces; 24 elements of the sphere are this good.
    expect(minimizer.energies.bending / (8 * Math.PI)).toBeGreaterThan(1 - 1e-5);
    expect(minimizer.energies.bending / (8 * Math.PI)).toBeLessThan(1.01);
    expect(minimizer.energies.gaussian / (4 * Math.PI)).toBeCloseTo(1, 3);
    minimizer.dispose();
  });

  test('of a blend minimizes the weighted sum', () => {
    const minimizer = finish(cubeMinimizer({ terms: { bending: 0.95, mvs_cross: 0.05 } }));
    const { bending, mvs_cross, quadrature_error } = minimizer.energies;
    const [report] = minimizer.levels;
    expect(report.energy_reported).toBeCloseTo(0.95 * bending + 0.05 * mvs_cross, 9);
    expect(Math.abs(report.energy_reported - report.energy)).toBeCloseTo(quadrature_error, 9);
    minimizer.dispose();
  });

  test('without a cap says by NaN that curvature variation diverges', () => {
    const minimizer = finish(cubeMinimizer({ cap: 'none', max_iterations: 0 }));
    const { energies } = minimizer;
    const variations = functionalNames().filter((name) => name !== 'bending' && name !== 'willmore');
    for (const name of variations) expect(energies[name]).toBeNaN();
    for (const value of Object.values(energies.invariants ?? { none: 0 })) expect(value).toBeNaN();
    expect(energies.bending).toBeGreaterThan(8 * Math.PI);
    minimizer.dispose();
  });

  test('that is cancelled keeps its best surface and says so', () => {
    const minimizer = cubeMinimizer({ levels: [2, 3] });
    while (minimizer.progress.total_evaluations < 3) minimizer.step(1);
    minimizer.cancel();
    expect(minimizer.step(1)).toBe(true);
    expect(minimizer.levels.at(-1)?.stop).toBe('cancelled');
    expect(minimizer.energies.bending).toBeGreaterThan(8 * Math.PI * (1 - 1e-5));
    minimizer.dispose();
  });

  test('can be shown, measured and saved before its first step', () => {
    const minimizer = cubeMinimizer();
    expect(minimizer.progress.total_evaluations).toBe(0);
    expect(minimizer.limitMesh(2).positions.length).toBeGreaterThan(0);
    expect(minimizer.energies.bending).toBeGreaterThan(8 * Math.PI);
    expect(Cage.read(minimizer.controlObj()).counts.faces).toBe(24);
    minimizer.dispose();
  });

  test.each(
    /** @type {Array<[string, any, RegExp]>} */ ([
      ['an unknown functional', { terms: { bend: 1 } }, /bend/],
      ['an unknown cap', { cap: 'round' }, /round/],
      ['weights that are all zero', { terms: {} }, /weight/],
      ['a negative weight', { terms: { bending: -1 } }, /weight|bending/],
      ['a weight that is no number', { terms: { bending: NaN } }, /weight|bending/],
      ['half a level', { levels: [0, 1.5] }, /level/],
      ['levels in the wrong order', { levels: [2, 1] }, /level/],
      ['too many levels', { levels: [0, 20] }, /level|faces/],
      ['a negative tolerance', { tolerance: -1 }, /tolerance/],
    ]),
  )('refuses %s', (_, options, reason) => {
    expect(() => cubeMinimizer(options)).toThrow(InputError);
    expect(() => cubeMinimizer(options)).toThrow(reason);
  });

  test('is disposed of once, and not used afterwards', () => {
    const minimizer = cubeMinimizer();
    minimizer.dispose();
    minimizer.dispose();
    expect(() => minimizer.step(1)).toThrow(/disposed/);
    expect(() => minimizer.progress).toThrow(/disposed/);
  });

  test('does not disturb another one', () => {
    const [one, two] = [cubeMinimizer(), cubeMinimizer({ terms: { mvs_cross: 1 } })];
    while (!(Number(one.step(1)) & Number(two.step(1))));
    const alone = finish(cubeMinimizer());
    expect(one.energies).toEqual(alone.energies);
    for (const minimizer of [one, two, alone]) minimizer.dispose();
  });
});

describe('a mesh', () => {
  test('of the limit surface is closed, with normals outwards and the curvatures of the near-sphere that the cube becomes', () => {
    const minimizer = finish(cubeMinimizer({ levels: [2, 2] }));
    const mesh = minimizer.limitMesh(3);
    const vertices = mesh.positions.length / 3;
    const quads = mesh.triangles.length / 6;
    expect(quads).toBe(96 * 3 * 3);
    expect(vertices - 2 * quads + quads).toBe(2); // Euler's formula for the sphere, each quad having half of four edges
    expect(mesh.edges).toHaveLength(0);
    expect(sixfoldVolume(mesh)).toBeGreaterThan(0);
    expect(mesh.normals).toHaveLength(3 * vertices);
    expect(mesh.curvatures).toHaveLength(2 * vertices);
    expect(Math.max(...mesh.triangles)).toBe(vertices - 1);

    const centre = [0, 1, 2].map(
      (axis) => mesh.positions.reduce((sum, x, i) => sum + (i % 3 === axis ? x : 0), 0) / vertices,
    );
    const radius = Math.cbrt(sixfoldVolume(mesh) / (8 * Math.PI));
    for (let i = 0; i < vertices; i++) {
      const position = [0, 1, 2].map((axis) => mesh.positions[3 * i + axis] - centre[axis]);
      const normal = mesh.normals.subarray(3 * i, 3 * i + 3);
      expect(Math.hypot(...normal)).toBeCloseTo(1, 5);
      expect(position[0] * normal[0] + position[1] * normal[1] + position[2] * normal[2]).toBeGreaterThan(0.9 * radius);
      const [kappa1, kappa2] = mesh.curvatures.subarray(2 * i, 2 * i + 2);
      expect(kappa1).toBeGreaterThanOrEqual(kappa2);
      expect(kappa2 * radius).toBeGreaterThan(0.7);
      expect(kappa1 * radius).toBeLessThan(1.3);
    }
    minimizer.dispose();
  });

  test('far from the origin keeps its digits: positions are measured from its centre', () => {
    const offset = [1e6, -3e5, 7e8];
    const far = cube.replace(/^v (.*)$/gm, (_, point) => {
      const [x, y, z] = point.split(' ').map(Number);
      return `v ${x + offset[0]} ${y + offset[1]} ${z + offset[2]}`;
    });
    const [here, there] = [cube, far].map((text) => {
      const cage = Cage.read(text);
      const minimizer = new Minimizer({ cage: cage.input, terms: { bending: 1 }, options: { levels: [1, 1] } });
      const meshes = [cage.mesh(), minimizer.controlMesh(), minimizer.limitMesh(4)];
      for (const disposable of [cage, minimizer]) disposable.dispose();
      return meshes;
    });
    for (const [i, { centre, positions }] of there.entries()) {
      // Doubles near 7e8 are 1.2e-7 apart, and every weighted mean of points is rounded once or twice; floats there are 64 apart.
      for (const axis of [0, 1, 2]) {
        expect(Math.abs(centre[axis] - here[i].centre[axis] - offset[axis])).toBeLessThan(5e-7);
      }
      positions.forEach((value, j) => expect(Math.abs(value - here[i].positions[j])).toBeLessThan(1e-6));
      const [low, high] = [Math.min(...positions), Math.max(...positions)];
      expect(low).toBeCloseTo(-high, 6);
    }
    // The cage as it is read is not rounded at all.
    expect([...there[0].centre]).toEqual(offset);
    expect(there[0].positions).toEqual(here[0].positions);
  });

  test('of the control net has its edges once and no curvatures', () => {
    const minimizer = cubeMinimizer({ levels: [2, 2] });
    const mesh = minimizer.controlMesh();
    expect(mesh.positions).toHaveLength(3 * 98);
    const edges = new Set();
    for (let i = 0; i < mesh.edges.length; i += 2)
      edges.add(
        mesh.edges
          .slice(i, i + 2)
          .sort()
          .join(),
      );
    expect(edges.size).toBe(192);
    expect(mesh.edges).toHaveLength(2 * 192);
    expect(mesh.normals).toHaveLength(0);
    expect(mesh.curvatures).toHaveLength(0);
    minimizer.dispose();
  });

  test('as OBJ has the same counts, and the control mesh continues the run where it stood', () => {
    const minimizer = finish(cubeMinimizer());
    const limit = Cage.read(minimizer.limitObj(4));
    expect(limit.counts).toMatchObject({ faces: 24 * 16, genus: 0 });
    const control = Cage.read(minimizer.controlObj());
    const again = finish(
      new Minimizer({
        cage: control.input,
        terms: { bending: 1 },
        options: { levels: [0, 0], max_iterations: 0 },
      }),
    );
    for (const [name, value] of Object.entries(again.energies)) {
      if (name === 'quadrature_error' || name === 'resolved' || name === 'invariants') continue;
      const before = /** @type {Record<string, number>} */ (minimizer.energies)[name];
      expect(Math.abs(Number(value) - before)).toBeLessThanOrEqual(1e-12 * Math.abs(before) + 1e-13);
    }
    for (const disposable of [limit, control, minimizer, again]) disposable.dispose();
  });

  test('copied out stays as it is while the memory of the module grows', () => {
    const minimizer = cubeMinimizer();
    const mesh = minimizer.limitMesh(4);
    const positions = mesh.positions.slice();
    const others = Array.from({ length: 4 }, () => {
      const other = cubeMinimizer({ levels: [5, 5] }); // 6144 patches each
      expect(other.limitMesh(8).positions.length).toBeGreaterThan(1_000_000);
      return other;
    });
    expect(mesh.positions).toEqual(positions);
    expect(minimizer.limitMesh(4).positions).toEqual(positions);
    expect(minimizer.step(1)).toBe(false);
    for (const other of [minimizer, ...others]) other.dispose();
  });
});

describe('a report', () => {
  test('reads back as what the run says, and goes on where it ended', () => {
    const minimizer = finish(cubeMinimizer({ levels: [0, 2] }));
    const text = minimizer.report();
    const report = parseReport(text);
    expect(report).toMatchObject({ umbilic: 'report', version: 1, program: version() });
    const { problem, cage, group, levels, limit, energies } = minimizer;
    expect(report).toMatchObject({ cage, group, levels, limit, energies });
    expect(problem).toMatchObject({ ...report.problem, umbilic: 'problem', version: 1 });
    expect(report.surface.points).toEqual([...minimizer.state.points]);
    for (const source of [text, report]) {
      const again = new Minimizer(source);
      expect(again.progress.level).toBe(2);
      // The points of an orbit are made exactly symmetric, to rounding.
      const { points } = minimizer.state;
      expect(again.state.points).toHaveLength(points.length);
      for (const [i, x] of again.state.points.entries()) expect(Math.abs(x - points[i])).toBeLessThan(1e-14);
      again.dispose();
    }
    minimizer.dispose();
  });

  test('holds the certificate of its surface', () => {
    const minimizer = finish(cubeMinimizer());
    const certificate = minimizer.certify();
    while (!certificate.step(10));
    expect(parseReport(minimizer.report(certificate)).certificate).toEqual(certificate.report);
    for (const handle of [minimizer, certificate]) handle.dispose();
  });
});
