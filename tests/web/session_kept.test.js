// SPDX-License-Identifier: MIT
/**
 * @file What the session, on the real core, tells of a surface that keeps something: what pulls, how far it is from the
 * cage's own, and the cage before it was filled; and of every surface its topology once.
 */
import { describe, expect, test } from '@jest/globals';
import { vertexAreas } from '../../web/colour/histogram.js';
import { patchEdges } from '../../web/scene/patches.js';
import { withTopology } from '../../web/worker/protocol.js';
import { fish } from '../browser/fish.js';
import { plate } from '../browser/plate.js';
import { all, session, types, useSession, work } from './session_harness.js';

/** @typedef {import('../../wasm/types.js').Mesh} Mesh */

useSession();

/** The fish with its body held and a vertex of its head pinned. */
const problem = {
  cage: { name: 'fish.obj', text: fish() },
  terms: { bending: 1 },
  constraints: { hold: { groups: ['body'] }, pins: [{ vertex: 38 }] },
  options: { levels: /** @type {[number, number]} */ ([0, 0]) },
};

/** @param {number} run @param {object} [more] */
const open = (run, more = {}) => session.obey({ type: 'open', run, problem, ...more });

describe('the topology of a surface', () => {
  test('is sent with the first of each level and density, and the page has it for all', () => {
    open(1, { then: 'run' });
    work();
    /** @type {Mesh | undefined} */
    let last;
    const sent = new Set();
    for (const { limit, control } of all('surfaced')) {
      const vertices = limit.positions.length / 3;
      expect('triangles' in limit).toBe(!last || vertices !== last.positions.length / 3);
      expect('faces' in limit).toBe('triangles' in limit);
      if (!sent.has(control.positions.length)) expect(control.edges.length).toBeGreaterThan(0);
      sent.add(control.positions.length);
      last = withTopology(limit, last);
      expect(last.triangles.reduce((most, vertex) => Math.max(most, vertex), 0)).toBe(vertices - 1);
    }
    const counts = all('surfaced').map(({ limit }) => limit.positions.length);
    expect(counts.length).toBeGreaterThan(new Set(counts).size); // some surface came without
  });

  test('is sent with a level whose mesh has as many vertices as the one before', () => {
    // 24, 96 and 384 patches have the densities 16, 12 and 6 while the surface moves: the last two have as many quads.
    open(1, {
      then: 'run',
      problem: { cage: { generator: 'two-3' }, terms: { bending: 1 }, options: { levels: [1, 2] } },
    });
    work();
    const first = ['96 12', '384 6'].map((kind) =>
      all('surfaced').find(({ patches, density }) => `${patches} ${density}` === kind),
    );
    expect(first[1].limit.positions.length).toBe(first[0].limit.positions.length);
    const [before, after] = first.map(({ limit }) => limit.triangles);
    expect(after).toHaveLength(before.length);
    expect(after).not.toEqual(before);
  });

  test('is sent again with another run, and missed where the page has none', () => {
    open(1);
    work();
    open(2);
    work();
    const [first, second] = all('surfaced');
    expect(second.limit.triangles).toEqual(first.limit.triangles);
    const { triangles, ...update } = first.limit;
    expect(triangles.length).toBeGreaterThan(0);
    expect(() => withTopology(update, undefined)).toThrow('no triangles');
  });
});

describe('the deviation', () => {
  test('is sent while it is asked for, 0 before anything moves and where it is held, and within the largest distance', () => {
    open(1);
    work();
    expect(all('surfaced').filter((message) => 'computed' in message)).toEqual([]);
    session.obey({ type: 'compute', wish: { of: 'deviation' } });
    work();
    const resting = all('surfaced').at(-1);
    expect(new Set(resting.computed.values)).toEqual(new Set([0]));
    expect(resting.computed.values).toHaveLength(resting.limit.positions.length / 3);

    open(2, { then: 'run', wish: { of: 'deviation' } });
    work();
    const moved = all('surfaced').filter(({ run }) => run === 2);
    const faces = moved.findLast(({ limit }) => limit.faces)?.limit;
    const { values } = moved.at(-1).computed;
    const held = new Set([...faces.triangles].filter((_, i) => faces.faces[Math.floor(i / 3)] >= 32));
    for (const vertex of held) expect(Math.abs(values[vertex])).toBeLessThan(1e-6);
    const largest = values.reduce(
      (/** @type {number} */ most, /** @type {number} */ d) => Math.max(most, Math.abs(d)),
      0,
    );
    const { deviation } = all('constrained').at(-1).report;
    expect(largest).toBeGreaterThan(0.2 * deviation);
    expect(largest).toBeLessThanOrEqual(1.001 * deviation);

    session.obey({ type: 'compute', wish: null });
    open(3);
    work();
    expect(all('surfaced').at(-1)).not.toHaveProperty('computed');
  });
});

describe('the density of an energy', () => {
  /** The integral over a mesh by its corners' means. @param {any} message */
  function integral({ limit: { positions }, computed: { values } }) {
    const triangles = all('surfaced').findLast(({ limit }) => limit.triangles)?.limit.triangles;
    return vertexAreas(positions, triangles).reduce((sum, area, vertex) => sum + area * values[vertex], 0);
  }

  test('is sent while it is asked for, integrates to the energy, and need not be what is minimized', () => {
    open(1);
    work();
    const { energies } = all('measured').at(-1);
    for (const terms of [{ bending: 1 }, { mvs_cross: 0.5, bending: 0.5 }]) {
      session.obey({ type: 'compute', wish: { of: 'energy', terms } });
      work();
      const message = all('surfaced').at(-1);
      expect(message.computed.wish).toEqual({ of: 'energy', terms });
      const expected = Object.entries(terms).reduce((sum, [name, weight]) => sum + weight * energies[name], 0);
      expect(Math.abs(integral(message) / expected - 1)).toBeLessThan(0.02);
    }
  });

  test('is not sent where the energy is infinite; the surface is, and nothing fails', () => {
    session.obey({
      type: 'open',
      run: 1,
      problem: { cage: { generator: 'two-3' }, terms: { bending: 1 }, options: { levels: [1, 1], cap: 'none' } },
      wish: { of: 'energy', terms: { mvs: 1 } },
    });
    work();
    expect(all('surfaced').at(-1)).not.toHaveProperty('computed');
    expect(all('failed')).toEqual([]);
    session.obey({ type: 'compute', wish: { of: 'energy', terms: { bending: 1 } } });
    work();
    expect(all('surfaced').at(-1).computed.values.length).toBeGreaterThan(0);
  });

  test('is sent once for many wishes that come at once, the last one', () => {
    open(1);
    work();
    const before = all('surfaced').length;
    for (const weight of [1, 2, 3])
      session.obey({ type: 'compute', wish: { of: 'energy', terms: { bending: weight } } });
    work();
    const sent = all('surfaced').slice(before);
    expect(sent.map(({ computed }) => computed.wish.terms.bending)).toEqual([3]);
  });
});

describe('where a run began', () => {
  test('is the cage and its own surface, from which the run leads away but where it is held', () => {
    open(1);
    work();
    const [{ limit, density }] = all('surfaced');
    session.obey({ type: 'recall', run: 1 });
    const [before] = all('recalled');
    expect(before.limit.positions).toEqual(limit.positions);
    expect(patchEdges(before.limit, density).length).toBe(2 * density * 192);
    expect(before.cage.positions).toHaveLength(3 * 98);
    expect(before.cage.edges).toHaveLength(2 * 192);
    session.obey({ type: 'optimize', run: 1 });
    work();
    session.obey({ type: 'recall', run: 1 });
    const after = all('recalled')[1];
    expect(after.limit.positions).toEqual(before.limit.positions);
    expect(all('surfaced').at(-1).limit.positions).not.toEqual(before.limit.positions);
  });
});

describe('what the constraints do', () => {
  test('is told of a surface at rest that has been minimized, and not before', () => {
    open(1);
    work();
    expect(all('constrained')).toEqual([]);
    session.obey({ type: 'optimize', run: 1 });
    work();
    expect(types().slice(types().indexOf('ended'))).toEqual(['ended', 'surfaced', 'saved', 'measured', 'constrained']);
    const { report, evaluations } = all('constrained')[0];
    expect(evaluations).toBe(all('measured').at(-1).evaluations);
    expect(report).toMatchObject({ held_faces: 64, pins: [{ pin: 1 }], regions: [{ faces: 64 }] });
    expect(report.pins[0].strength).toBeGreaterThan(0);
  });

  test('is read from a report’s file', () => {
    open(1, { then: 'run' });
    work();
    session.obey({ type: 'export', run: 1, what: 'report' });
    session.obey({ type: 'open', run: 2, problem: all('exported')[0].content });
    expect(all('opened')[1].report.constraints).toEqual(all('constrained')[0].report);
  });
});

describe('a filled cage', () => {
  test('is told with the one before, which the file’s numbers are those of', () => {
    const cage = { name: 'plate.obj', text: plate() };
    session.obey({ type: 'open', run: 1, problem: { cage, terms: { bending: 1 }, fill: { loops: [2] } } });
    work();
    const { cage: filled, groups, unfilled } = all('opened')[0];
    expect(filled).toMatchObject({ faces: 36, boundaries: [{ vertices: 24 }] });
    expect(filled.notes[0]).toBe("filled boundary 2 of 8 vertices with 4 faces, the group 'fill-2'");
    expect(groups.map((/** @type {any} */ { name }) => name)).toEqual(['fill-2-rim', 'fill-2']);
    expect(unfilled.counts).toMatchObject({ faces: 32, boundaries: [{ vertices: 24 }, { vertices: 8 }] });
    expect([...unfilled.corners]).toEqual(Array(32).fill(4));
    session.obey({ type: 'open', run: 2, problem: { cage, terms: { bending: 1 } } });
    expect(all('opened')[1]).not.toHaveProperty('unfilled');
  });

  test('that every face touches is refused with the core’s words', () => {
    const cage = { name: 'plate.obj', text: plate() };
    session.obey({ type: 'open', run: 1, problem: { cage, terms: { bending: 1 }, fill: {} } });
    expect(all('failed')[0].message).toMatch(/^plate\.obj: fill: every face of the cage touches a filled boundary/);
  });
});
