// SPDX-License-Identifier: MIT
/**
 * @file The worker's session on the real core: what it answers, in which order, and when it listens.
 */
import { describe, expect, test } from '@jest/globals';
import { Cage, Minimizer, parseReport } from '../../wasm/umbilic.js';
import { MOVING_QUADS, RESTING_QUADS, densityFor } from '../../web/worker/density.js';
import { SAMPLE_SIZE, transferables } from '../../web/worker/protocol.js';
import { objCube, plyCube } from '../wasm/ply_cube.js';
import { all, open, problemOf, session, types, useSession, work } from './session_harness.js';

useSession();

describe('opening', () => {
  test('answers with counts, surface, a copy for safe keeping and energies, in that order', () => {
    open(1);
    expect(types()).toEqual(['opened']);
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'saved', 'measured']);
    const [opened, surfaced, saved, measured] = session.messages;
    expect(opened.group).toEqual({ name: 'Oh', order: 48 });
    expect(opened.cage).toMatchObject({ vertices: 8, genus: 0 });
    expect(opened).not.toHaveProperty('asked');
    expect(opened.estimate.levels.map((/** @type {any} */ { level }) => level)).toEqual([1]);
    expect(opened.estimate.seconds).toBeGreaterThan(0);
    expect(surfaced.limit.positions.length).toBeGreaterThan(1000);
    expect(surfaced.control.edges).toHaveLength(2 * 48);
    // One of each kind of vertex: of the cube's vertices, edges and faces.
    expect(saved.state).toEqual({ level: 1, points: expect.any(Float64Array) });
    expect(saved.state.points).toHaveLength(3 * 3);
    expect(measured.energies.bending).toBeGreaterThan(8 * Math.PI);
    expect(session.waiting).toEqual([]);
  });

  test('goes on from a minimizer by its orbits’ points: its symmetry, its cage’s counts, and its energies; coarsely first', () => {
    const cage = { generator: 'two-3' };
    const minimizer = new Minimizer(problemOf({ cage }));
    while (!minimizer.step(10));
    const start = minimizer.state;
    open(1, { cage, start }, { look: true });
    work();
    expect(types()).toEqual(['opened', 'surfaced']); // what takes time waits until it has been drawn
    expect(session.rests).toBe(0);
    session.obey({ type: 'detail', run: 1 });
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'surfaced', 'saved', 'measured']);
    expect(all('surfaced').map(({ coarse }) => coarse)).toEqual([true, undefined]);
    expect(session.rests).toBe(1);
    const [opened, coarse, fine, , measured] = session.messages;
    expect(opened).not.toHaveProperty('estimate');
    expect(opened).toMatchObject({ cage: minimizer.cage, group: { name: 'D3h', order: 12 } });
    const quads = [coarse, fine].map(({ limit }) => limit.triangles.length / 6);
    expect(quads).toEqual([MOVING_QUADS, RESTING_QUADS].map((most) => 96 * densityFor(96, most) ** 2));
    expect(quads[0]).toBeLessThan(quads[1] / 3);
    expect(measured.energies.bending / minimizer.energies.bending).toBeCloseTo(1, 10);

    open(2, { cage, start: { ...start, level: 2 } });
    expect(all('failed')).toEqual([expect.objectContaining({ run: 2, kind: 'input' })]);
    minimizer.dispose();
  });

  test('of a file says what it asks, and of a report what came out and where it goes on', () => {
    const minimizer = new Minimizer(problemOf({ levels: [0, 2] }));
    while (!minimizer.step(10));
    session.obey({ type: 'open', run: 1, problem: minimizer.report() });
    work();
    const [opened, , saved, measured] = session.messages;
    const { asked } = opened;
    expect(asked).toMatchObject({ cage: { generator: 'cube' }, terms: { bending: 1 }, options: { levels: [0, 2] } });
    expect(asked).not.toHaveProperty('start');
    expect(opened.report.levels).toEqual(minimizer.levels);
    expect([opened.level, saved.state.level, measured.level]).toEqual([2, 2, 2]);
    expect(saved.state.points).toHaveLength(minimizer.state.points.length);
    const text = JSON.stringify({ umbilic: 'problem', version: 1, ...problemOf() });
    session.obey({ type: 'open', run: 2, problem: text });
    expect(all('opened').at(-1)).not.toHaveProperty('report');
    expect(all('opened').at(-1).asked).not.toHaveProperty('start');
    const start = { level: 2, points: [...minimizer.state.points] };
    session.obey({ type: 'open', run: 2, problem: text.replace(/\}$/, `,"start":${JSON.stringify(start)}}`) });
    expect(Array.from(all('opened').at(-1).asked.start.points)).toEqual(start.points);
    session.obey({ type: 'open', run: 3, problem: text.replace('[1,1]', '[1]') });
    expect(all('failed').at(-1)).toMatchObject({
      run: 3,
      kind: 'input',
      message: expect.stringMatching(/^options.levels/),
    });
    minimizer.dispose();
  });

  test('shows a cage that is too coarse to be evaluated as finely as any other', () => {
    open(1, { levels: [0, 0] });
    work();
    const [{ control, limit }] = all('surfaced');
    expect(control.positions).toHaveLength(3 * 8);
    expect(limit.triangles.length / 6).toBe(24 * densityFor(24, RESTING_QUADS) ** 2);
  });

  test('of bytes that are no text answers with the text that the page is to keep', () => {
    open(1, { cage: { name: 'cube.ply', text: plyCube() } });
    expect(all('opened')).toEqual([expect.objectContaining({ text: objCube() })]);
    open(2, { cage: { name: 'cube.obj', text: new TextEncoder().encode(objCube()) } });
    expect(all('opened')[1]).not.toHaveProperty('text');
    open(3, { cage: { name: 'cube.ply', text: plyCube(9) } });
    expect(all('failed')).toEqual([
      { type: 'failed', run: 3, kind: 'input', message: expect.stringMatching(/^cube.ply: 'face' 6: index 9 /) },
    ]);
  });

  test('a broken file says where, and the run before it goes on', () => {
    open(1, { levels: [1, 2] });
    session.obey({ type: 'optimize', run: 1 });
    work(3);
    session.messages.length = 0;
    const text = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nf 1 2\n');
    open(2, { cage: { name: 'bad.obj', text } });
    expect(session.messages).toEqual([
      { type: 'failed', run: 2, kind: 'input', message: expect.stringMatching(/^bad.obj: line 3/) },
    ]);
    session.obey({ type: 'optimize', run: 2 }); // sent before the page knew
    work();
    expect(all('ended')).toEqual([expect.objectContaining({ run: 1 })]);
  });

  test('another cage ends the run before it', () => {
    open(1);
    session.obey({ type: 'optimize', run: 1 });
    work(3);
    session.messages.length = 0;
    open(2);
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'saved', 'measured']);
    expect(session.messages.every((message) => message.run === 2)).toBe(true);
    session.messages.length = 0;
    session.obey({ type: 'pause', run: 1 });
    expect(session.messages).toEqual([]);
    session.obey({ type: 'optimize', run: 1 });
    expect(session.messages).toEqual([expect.objectContaining({ type: 'failed', kind: 'internal' })]);
  });
});

describe('a run', () => {
  test('tells every evaluation once, its levels, and at last that it has ended', () => {
    open(1, { levels: [1, 2] });
    work();
    session.obey({ type: 'optimize', run: 1 });
    work();
    const samples = all('stepped').flatMap((message) => [...message.samples]);
    const evaluations = samples.filter((_, i) => i % SAMPLE_SIZE === 0);
    expect(evaluations).toEqual(evaluations.map((_, i) => i + 1));
    expect(all('levelEnded').map(({ report }) => report.level)).toEqual([1, 2]);
    expect(all('levelEnded').map(({ limit }) => limit.status)).toEqual(['too_few_levels', 'too_few_levels']);
    const [ended] = all('ended');
    expect(ended.progress.total_evaluations).toBe(evaluations.length);
    expect(ended.stop).toBe(all('levelEnded')[1].report.stop);
    // After the answer, everything that the page needs to rest.
    expect(types().slice(types().indexOf('ended'))).toEqual(['ended', 'surfaced', 'saved', 'measured']);
    expect(session.messages.at(-1).energies.bending).toBeCloseTo(all('levelEnded')[1].report.energy_reported, 9);
  });

  test('shows the first surface that has moved before it does anything else that takes time', () => {
    session.pace = 0.1;
    for (const resting of [true, false]) {
      session.messages = [];
      const run = resting ? 1 : 2;
      open(run, { levels: [1, 2] });
      if (resting) work();
      const before = session.messages.length;
      session.obey({ type: 'optimize', run });
      work();
      const order = types().slice(before);
      const first = order.indexOf('surfaced');
      const { evaluations } = session.messages[before + first];
      expect(evaluations).toBeGreaterThan(1);
      expect(evaluations).toBeLessThan(5);
      expect(order.slice(0, first)).not.toContain('saved');
      expect(order.slice(0, first)).not.toContain('levelEnded');
      // The energies of the start are those of the surface before it moves.
      expect(all('measured')[0].evaluations).toBe(0);
      expect(order.slice(0, first).filter((type) => type === 'measured')).toHaveLength(resting ? 0 : 1);
    }
  });

  test('goes on showing its surface where a finer quadrature rule lets the energy rise', () => {
    open(1, { cage: { generator: 'dodecahedron-frame' }, levels: [0, 2] });
    work();
    session.obey({ type: 'optimize', run: 1 });
    work();
    const samples = all('stepped').flatMap((message) => [...message.samples]);
    /** @type {Array<{evaluations: number, energy: number, level: number}>} */
    const steps = [];
    for (let i = 0; i < samples.length; i += SAMPLE_SIZE) {
      steps.push({ evaluations: samples[i], energy: samples[i + 1], level: samples[i + 3] });
    }
    for (const { energy } of steps) expect(Number.isFinite(energy)).toBe(true);
    const rise = steps.findIndex(
      ({ energy, level }, i) => i > 0 && level === steps[i - 1].level && energy > steps[i - 1].energy,
    );
    expect(steps[rise].level).toBe(2);
    expect(all('levelEnded').map(({ report }) => report.quadrature)).toEqual([0, 0, 1]);
    const shown = all('surfaced').filter(({ evaluations }) => evaluations > steps[rise].evaluations);
    expect(shown.length).toBeGreaterThan(2);
  });

  test('that is long in preparing its first step after it was opened shows its cage meanwhile', () => {
    session.pace = 50;
    open(1);
    session.obey({ type: 'optimize', run: 1 });
    work();
    expect(all('surfaced')[0].evaluations).toBe(0);
  });

  test('yields after every evaluation, so that pause waits for one at most', () => {
    open(1, { levels: [2, 2] });
    session.obey({ type: 'optimize', run: 1 });
    while (!all('stepped').length) work(1);
    const before = all('stepped').at(-1).progress.total_evaluations;
    work(1);
    session.obey({ type: 'pause', run: 1 });
    const [paused] = all('paused');
    expect(paused.progress.total_evaluations).toBeLessThanOrEqual(before + 1);
    const count = session.messages.length;
    work();
    expect(session.messages).toHaveLength(count); // stands still
    session.obey({ type: 'optimize', run: 1 });
    work();
    expect(all('ended')).toHaveLength(1);
  });

  test('that goes on as it is opened does not show its cage first', () => {
    session.pace = 0.1;
    open(1, {}, { then: 'step' });
    work();
    expect(types()).toEqual(['opened', 'measured', 'stepped', 'paused', 'surfaced', 'saved', 'measured']);
    expect(all('surfaced')[0].evaluations).toBe(1);
  });

  test('takes one step when it is asked for one', () => {
    open(1);
    for (const expected of [1, 2]) {
      session.obey({ type: 'step', run: 1 });
      work();
      expect(all('paused').at(-1).progress.total_evaluations).toBe(expected);
    }
  });

  test('is cancelled at once, whether it rests or not, and keeps its surface', () => {
    for (const turns of [0, 4]) {
      session.messages = [];
      session.waiting = [];
      open(turns + 1, { levels: [2, 2] });
      session.obey({ type: 'optimize', run: turns + 1 });
      work(turns);
      session.obey({ type: 'cancel', run: turns + 1 });
      expect(all('ended')).toEqual([expect.objectContaining({ stop: 'cancelled' })]);
      expect(types().at(-1)).toBe('measured');
      const count = session.messages.length;
      work();
      expect(session.messages).toHaveLength(count);
    }
  });

  test('saves its control mesh on the way, and going on from it goes on from the same energy', () => {
    open(1, { levels: [2, 2] });
    session.obey({ type: 'optimize', run: 1 });
    work();
    const { state } = all('saved').at(-1);
    expect(state.level).toBe(2);
    session.messages.length = 0;
    open(2, { levels: [0, 0], start: state });
    session.obey({ type: 'optimize', run: 2 });
    work();
    const [first] = all('stepped');
    expect(first.samples[1] / all('ended')[0].progress.energy - 1).toBeLessThan(1e-6);
  });

  test('exports its meshes and its report', () => {
    open(1);
    work();
    const [control, limit, report] = /** @type {const} */ (['control', 'limit', 'report']).map((what) => {
      session.obey({ type: 'export', run: 1, what });
      expect(all('exported').at(-1)).toMatchObject({ run: 1, what });
      return all('exported').at(-1).content;
    });
    const cages = [control, limit].map((obj) => Cage.read(obj));
    expect(cages.map(({ counts }) => counts.faces)).toEqual([24, 24 * densityFor(24, 200_000) ** 2]);
    cages.forEach((cage) => cage.dispose());
    expect(parseReport(report)).toMatchObject({ umbilic: 'report', problem: problemOf(), levels: [] });
  });

  test('has its certificate in its report until its surface moves', () => {
    const certificateOf = () => {
      session.obey({ type: 'export', run: 1, what: 'report' });
      return parseReport(all('exported').at(-1).content).certificate;
    };
    open(1, { levels: [1, 2] });
    work();
    expect(certificateOf()).toBeUndefined();
    session.obey({ type: 'certify', run: 1 });
    work();
    expect(certificateOf()).toEqual(all('certified')[0].report);
    session.obey({ type: 'optimize', run: 1 });
    work();
    expect(certificateOf()).toBeUndefined();
  });
});

test('a ping is answered', () => {
  session.obey({ type: 'ping' });
  expect(session.messages).toEqual([{ type: 'ponged' }]);
});

test('a command for a cage that never opened is no failure', () => {
  session.obey({ type: 'optimize', run: 7 });
  work();
  expect(session.messages).toEqual([]);
});

test('the buffers of meshes and samples are handed over, empty ones are not', () => {
  open(1);
  work();
  const [surfaced] = all('surfaced');
  const buffers = transferables(surfaced);
  expect(buffers).toContain(surfaced.limit.curvatures.buffer);
  expect(buffers).not.toContain(surfaced.control.curvatures.buffer);
  expect(new Set(buffers).size).toBe(buffers.length);
  expect(transferables(session.messages[0])).toEqual([]);
  const [saved] = all('saved');
  expect(transferables(saved)).toEqual([saved.state.points.buffer]);
});

test('a mesh has about as many quads as asked, and at least one for each patch', () => {
  for (const patches of [24, 100, 1536, 24576, 1e6]) {
    const density = densityFor(patches, 14_000);
    expect(density).toBeGreaterThanOrEqual(1);
    if (density > 1) expect(patches * density ** 2).toBeLessThanOrEqual(14_000);
  }
});
