// SPDX-License-Identifier: MIT
/**
 * @file The worker's session on the real core: what it answers, in which order, and when it listens.
 */
import { beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { Cage, InputError, Minimizer, load } from '../../wasm/umbilic.js';
import { MOVING_QUADS, RESTING_QUADS, densityFor } from '../../web/worker/density.js';
import { SAMPLE_SIZE, transferables } from '../../web/worker/protocol.js';
import { createSession } from '../../web/worker/session.js';

/** @typedef {import('../../web/worker/protocol.js').Message} Message */

/** @type {any[]} */
let messages;
/** Work that the session has put behind the messages that arrive. @type {Array<() => void>} */
let waiting;
/** @type {ReturnType<typeof createSession>} */
let obey;
let clock = 0;
/** How often all has been told of a surface at rest. */
let rests = 0;
/** Milliseconds between two looks at the clock. */
let pace = 5;

beforeAll(() => load());

beforeEach(() => {
  messages = [];
  waiting = [];
  clock = 0;
  rests = 0;
  pace = 5;
  obey = createSession({
    core: { Cage, InputError, Minimizer },
    post: (message) => messages.push(message),
    yieldThen: (task) => waiting.push(task),
    now: () => (clock += pace),
    rested: () => rests++,
  });
});

/** @type {import('../../wasm/types.js').MinimizerOptions} */
const options = { weights: { bending: 1 }, levels: [1, 1], cap: 'smooth' };

/** @param {number} run @param {any} [more] options @param {{then?: 'run' | 'step'}} [goesOn] */
function open(run, more = {}, goesOn = {}) {
  const source = /** @type {const} */ ({ kind: 'generated', name: 'cube', family: 'flag', thickness: 1 });
  obey({ type: 'open', run, source, options: { ...options, ...more }, ...goesOn });
}

/** Lets the session work, `turns` yields at most. @param {number} [turns] */
function work(turns = Infinity) {
  for (let i = 0; i < turns && waiting.length; i++) waiting.shift()?.();
}

const types = () => messages.map(({ type }) => type);
/** @param {Message['type']} type */
const all = (type) => messages.filter((message) => message.type === type);

describe('opening', () => {
  test('answers with counts, surface, a copy for safe keeping and energies, in that order', () => {
    open(1);
    expect(types()).toEqual(['opened']);
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'saved', 'measured']);
    const [opened, surfaced, saved, measured] = messages;
    expect(opened.group).toEqual({ name: 'Oh', order: 48 });
    expect(opened.counts).toMatchObject({ vertices: 8, genus: 0 });
    expect(surfaced.limit.positions.length).toBeGreaterThan(1000);
    expect(surfaced.control.edges).toHaveLength(2 * 48);
    expect(Cage.read(saved.obj).counts.faces).toBe(24);
    expect(saved.level).toBe(1);
    expect(measured.energies.bending).toBeGreaterThan(8 * Math.PI);
    expect(waiting).toEqual([]);
  });

  test('goes on from a minimizer by its orbits’ points: its symmetry, its cage’s counts, and its energies; coarsely first', () => {
    const cage = Cage.generate('two-3');
    const minimizer = new Minimizer(cage, { weights: { bending: 1 }, levels: [1, 1] });
    while (!minimizer.step(10));
    const points = minimizer.orbitPoints();
    const source = /** @type {const} */ ({
      kind: 'minimizer',
      name: 'two-3',
      family: 'flag',
      thickness: 1,
      level: 1,
      points,
    });
    obey({ type: 'open', run: 1, source, options: { ...options, levels: [0, 0] } });
    work();
    expect(types()).toEqual(['opened', 'surfaced']); // what takes time waits until it has been drawn
    expect(rests).toBe(0);
    obey({ type: 'detail', run: 1 });
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'surfaced', 'saved', 'measured']);
    expect(all('surfaced').map(({ coarse }) => coarse)).toEqual([true, undefined]);
    expect(rests).toBe(1);
    const [opened, coarse, fine, , measured] = messages;
    expect(opened).toMatchObject({ counts: cage.counts, group: { name: 'D3h', order: 12 } });
    const quads = [coarse, fine].map(({ limit }) => limit.triangles.length / 6);
    expect(quads).toEqual([MOVING_QUADS, RESTING_QUADS].map((most) => 96 * densityFor(96, most) ** 2));
    expect(quads[0]).toBeLessThan(quads[1] / 3);
    expect(measured.energies.bending / minimizer.energies.bending).toBeCloseTo(1, 10);

    obey({ type: 'open', run: 2, source: { ...source, level: 2 }, options });
    expect(all('failed')).toEqual([expect.objectContaining({ run: 2, kind: 'input' })]);
    minimizer.dispose();
    cage.dispose();
  });

  test('shows a cage that is too coarse to be evaluated as finely as any other', () => {
    open(1, { levels: [0, 0] });
    work();
    const [{ control, limit }] = all('surfaced');
    expect(control.positions).toHaveLength(3 * 8);
    expect(limit.triangles.length / 6).toBe(24 * densityFor(24, RESTING_QUADS) ** 2);
  });

  test('a broken file says where, and the run before it goes on', () => {
    open(1, { levels: [1, 2] });
    obey({ type: 'optimize', run: 1 });
    work(3);
    messages.length = 0;
    const text = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nf 1 2\n');
    obey({ type: 'open', run: 2, source: { kind: 'text', name: 'bad.obj', text }, options });
    expect(messages).toEqual([{ type: 'failed', run: 2, kind: 'input', message: expect.stringMatching(/^line 3/) }]);
    obey({ type: 'optimize', run: 2 }); // sent before the page knew
    work();
    expect(all('ended')).toEqual([expect.objectContaining({ run: 1 })]);
  });

  test('another cage ends the run before it', () => {
    open(1);
    obey({ type: 'optimize', run: 1 });
    work(3);
    messages.length = 0;
    open(2);
    work();
    expect(types()).toEqual(['opened', 'surfaced', 'saved', 'measured']);
    expect(messages.every((message) => message.run === 2)).toBe(true);
    messages.length = 0;
    obey({ type: 'pause', run: 1 });
    expect(messages).toEqual([]);
    obey({ type: 'optimize', run: 1 });
    expect(messages).toEqual([expect.objectContaining({ type: 'failed', kind: 'internal' })]);
  });
});

describe('while a surface rests', () => {
  /** How many turns it takes until the first surface that has moved is told. @param {number} run */
  function turnsUntilMoved(run) {
    messages.length = 0;
    let turns = 0;
    for (; !all('surfaced').length; turns++) work(1);
    expect(all('surfaced')[0]).toMatchObject({ run });
    return turns;
  }

  test('its level is prepared, so that the first steps are evaluations', () => {
    open(1, { levels: [1, 2], weights: { mvs_cross: 1 } });
    obey({ type: 'optimize', run: 1 });
    const unprepared = turnsUntilMoved(1);
    open(2, { levels: [1, 2], weights: { mvs_cross: 1 } });
    work();
    expect(rests).toBe(1);
    obey({ type: 'optimize', run: 2 });
    const prepared = turnsUntilMoved(2);
    expect(prepared).toBeLessThanOrEqual(all('surfaced')[0].evaluations);
    expect(prepared).toBeLessThan(unprepared);
  });

  test('the run that is expected next is prepared as well, and no other is taken for it', () => {
    const source = /** @type {const} */ ({ kind: 'generated', name: 'two-3', family: 'flag', thickness: 1 });
    const asked = { ...options, weights: { mvs_cross: 1 } };
    open(1);
    obey({ type: 'expect', run: 1, source, options: asked });
    work();
    const energies = [];
    const turns = [];
    for (const [run, changed] of [asked, { ...asked, levels: /** @type {[number, number]} */ ([1, 2]) }].entries()) {
      obey({ type: 'open', run: run + 2, source, options: changed, then: 'run' });
      turns.push(turnsUntilMoved(run + 2));
      energies.push(all('measured')[0].energies.mvs_cross);
    }
    expect(turns[0]).toBeLessThan(turns[1]);
    expect(energies[0] / energies[1]).toBeCloseTo(1, 12); // of the same cage
  });

  test('a run that could not be opened is not expected, without a word', () => {
    open(1);
    work();
    messages.length = 0;
    const source = /** @type {const} */ ({ kind: 'generated', name: 'none', family: 'flag', thickness: 1 });
    obey({ type: 'expect', run: 1, source, options });
    work();
    expect(messages).toEqual([]);
  });
});

describe('a certificate', () => {
  /** @param {number} run @param {any} [more] */
  function minimize(run, more) {
    open(run, more);
    obey({ type: 'optimize', run });
    work();
    messages.length = 0;
  }

  test('advances step by step and says whether the surface is a minimum', () => {
    minimize(1);
    obey({ type: 'certify', run: 1 });
    expect(messages).toEqual([]);
    work();
    const advances = all('certificateAdvanced').map(({ progress }) => progress);
    expect(advances.length).toBeGreaterThan(3);
    expect(advances).toEqual([...advances].sort((a, b) => a - b));
    expect(advances.at(-1)).toBe(1);
    expect(messages.at(-1)).toEqual({
      type: 'certified',
      run: 1,
      report: { level: 1, unknowns: 78, gauge: 10, tau: 1e-3, negative: 0 },
    });
  });

  test('is abandoned between two steps, and one that is ready is not', () => {
    minimize(1);
    obey({ type: 'certify', run: 1 });
    work(2);
    obey({ type: 'abandonCertificate', run: 1 });
    expect(types().at(-1)).toBe('certificateAbandoned');
    const count = messages.length;
    work();
    obey({ type: 'abandonCertificate', run: 1 });
    expect(messages).toHaveLength(count);
    obey({ type: 'certify', run: 1 });
    work();
    expect(all('certified')).toHaveLength(1);
  });

  test('is dropped when another run opens, and refused with the reason where there can be none', () => {
    minimize(1);
    obey({ type: 'certify', run: 1 });
    work(2);
    minimize(2, { cap: 'flat' });
    expect(all('certified')).toEqual([]);
    obey({ type: 'certify', run: 2 });
    work();
    expect(messages).toEqual([{ type: 'failed', run: 2, kind: 'input', message: expect.stringMatching(/cap flat/) }]);
  });

  test('is not begun while a run goes on', () => {
    open(1);
    obey({ type: 'optimize', run: 1 });
    obey({ type: 'certify', run: 1 });
    work();
    expect(types()).not.toContain('certified');
    expect(all('ended')).toHaveLength(1);
  });
});

describe('a run', () => {
  test('tells every evaluation once, its levels, and at last that it has ended', () => {
    open(1, { levels: [1, 2] });
    work();
    obey({ type: 'optimize', run: 1 });
    work();
    const samples = all('stepped').flatMap((message) => [...message.samples]);
    const evaluations = samples.filter((_, i) => i % SAMPLE_SIZE === 0);
    expect(evaluations).toEqual(evaluations.map((_, i) => i + 1));
    expect(all('levelEnded').map(({ report }) => report.level)).toEqual([1, 2]);
    expect(all('levelEnded').map(({ limit }) => limit.status)).toEqual(['too_few_levels', 'too_few_levels']);
    const [ended] = all('ended');
    expect(ended.progress.totalEvaluations).toBe(evaluations.length);
    expect(ended.stop).toBe(all('levelEnded')[1].report.stop);
    // After the answer, everything that the page needs to rest.
    expect(types().slice(types().indexOf('ended'))).toEqual(['ended', 'surfaced', 'saved', 'measured']);
    expect(messages.at(-1).energies.bending).toBeCloseTo(all('levelEnded')[1].report.energyReported, 9);
  });

  test('shows the first surface that has moved before it does anything else that takes time', () => {
    pace = 0.1;
    for (const resting of [true, false]) {
      messages = [];
      const run = resting ? 1 : 2;
      open(run, { levels: [1, 2] });
      if (resting) work();
      const before = messages.length;
      obey({ type: 'optimize', run });
      work();
      const order = types().slice(before);
      const first = order.indexOf('surfaced');
      const { evaluations } = messages[before + first];
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
    const source = /** @type {const} */ ({
      kind: 'generated',
      name: 'dodecahedron-frame',
      family: 'flag',
      thickness: 1,
    });
    obey({ type: 'open', run: 1, source, options: { ...options, levels: [0, 2] } });
    work();
    obey({ type: 'optimize', run: 1 });
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
    pace = 50;
    open(1);
    obey({ type: 'optimize', run: 1 });
    work();
    expect(all('surfaced')[0].evaluations).toBe(0);
  });

  test('yields after every evaluation, so that pause waits for one at most', () => {
    open(1, { levels: [2, 2] });
    obey({ type: 'optimize', run: 1 });
    while (!all('stepped').length) work(1);
    const before = all('stepped').at(-1).progress.totalEvaluations;
    work(1);
    obey({ type: 'pause', run: 1 });
    const [paused] = all('paused');
    expect(paused.progress.totalEvaluations).toBeLessThanOrEqual(before + 1);
    const count = messages.length;
    work();
    expect(messages).toHaveLength(count); // stands still
    obey({ type: 'optimize', run: 1 });
    work();
    expect(all('ended')).toHaveLength(1);
  });

  test('that goes on as it is opened does not show its cage first', () => {
    pace = 0.1;
    open(1, {}, { then: 'step' });
    work();
    expect(types()).toEqual(['opened', 'measured', 'stepped', 'paused', 'surfaced', 'saved', 'measured']);
    expect(all('surfaced')[0].evaluations).toBe(1);
  });

  test('takes one step when it is asked for one', () => {
    open(1);
    for (const expected of [1, 2]) {
      obey({ type: 'step', run: 1 });
      work();
      expect(all('paused').at(-1).progress.totalEvaluations).toBe(expected);
    }
  });

  test('is cancelled at once, whether it rests or not, and keeps its surface', () => {
    for (const turns of [0, 4]) {
      messages = [];
      waiting = [];
      open(turns + 1, { levels: [2, 2] });
      obey({ type: 'optimize', run: turns + 1 });
      work(turns);
      obey({ type: 'cancel', run: turns + 1 });
      expect(all('ended')).toEqual([expect.objectContaining({ stop: 'cancelled' })]);
      expect(types().at(-1)).toBe('measured');
      const count = messages.length;
      work();
      expect(messages).toHaveLength(count);
    }
  });

  test('saves its control mesh on the way, and going on from it goes on from the same energy', () => {
    open(1, { levels: [2, 2] });
    obey({ type: 'optimize', run: 1 });
    work();
    const saved = all('saved').at(-1);
    expect(saved.level).toBe(2);
    messages.length = 0;
    obey({
      type: 'open',
      run: 2,
      source: { kind: 'text', name: 'saved', text: saved.obj },
      options: { ...options, levels: [0, 0] },
    });
    obey({ type: 'optimize', run: 2 });
    work();
    const [first] = all('stepped');
    expect(first.samples[1] / all('ended')[0].progress.energy - 1).toBeLessThan(1e-6);
  });

  test('exports its limit mesh', () => {
    open(1);
    work();
    obey({ type: 'export', run: 1 });
    const [exported] = all('exported');
    const cage = Cage.read(exported.obj);
    expect(cage.counts.faces).toBe(24 * densityFor(24, 200_000) ** 2);
    cage.dispose();
  });
});

test('a ping is answered', () => {
  obey({ type: 'ping' });
  expect(messages).toEqual([{ type: 'ponged' }]);
});

test('a command for a cage that never opened is no failure', () => {
  obey({ type: 'optimize', run: 7 });
  work();
  expect(messages).toEqual([]);
});

test('the buffers of meshes and samples are handed over, empty ones are not', () => {
  open(1);
  work();
  const [surfaced] = all('surfaced');
  const buffers = transferables(surfaced);
  expect(buffers).toContain(surfaced.limit.curvatures.buffer);
  expect(buffers).not.toContain(surfaced.control.curvatures.buffer);
  expect(new Set(buffers).size).toBe(buffers.length);
  expect(transferables(messages[0])).toEqual([]);
});

test('a mesh has about as many quads as asked, and at least one for each patch', () => {
  for (const patches of [24, 100, 1536, 24576, 1e6]) {
    const density = densityFor(patches, 14_000);
    expect(density).toBeGreaterThanOrEqual(1);
    if (density > 1) expect(patches * density ** 2).toBeLessThanOrEqual(14_000);
  }
});
