// SPDX-License-Identifier: MIT
/**
 * @file The worker's session on the real core: what it answers, in which order, and when it listens.
 */
import { beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { Cage, InputError, Minimizer, load } from '../../wasm/umbilic.js';
import { densityFor } from '../../web/worker/density.js';
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

beforeAll(() => load());

beforeEach(() => {
  messages = [];
  waiting = [];
  clock = 0;
  obey = createSession({
    core: { Cage, InputError, Minimizer },
    post: (message) => messages.push(message),
    yieldThen: (task) => waiting.push(task),
    now: () => (clock += 5),
  });
});

/** @type {import('../../wasm/types.js').MinimizerOptions} */
const options = { weights: { bending: 1 }, levels: [1, 1], cap: 'smooth' };

/** @param {number} run @param {any} [more] */
function open(run, more = {}) {
  const source = /** @type {const} */ ({ kind: 'generated', name: 'cube', family: 'flag', thickness: 1 });
  obey({ type: 'open', run, source, options: { ...options, ...more } });
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
    expect(types()).toEqual(['opened', 'surfaced', 'saved', 'measured']);
    const [opened, surfaced, saved, measured] = messages;
    expect(opened.counts).toMatchObject({ vertices: 8, genus: 0 });
    expect(surfaced.limit.positions.length).toBeGreaterThan(1000);
    expect(surfaced.control.edges).toHaveLength(2 * 48);
    expect(Cage.read(saved.obj).counts.faces).toBe(24);
    expect(saved.level).toBe(1);
    expect(measured.energies.bending).toBeGreaterThan(8 * Math.PI);
    expect(waiting).toEqual([]);
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
    open(2);
    messages.length = 0;
    work();
    expect(messages).toEqual([]);
    obey({ type: 'pause', run: 1 });
    expect(messages).toEqual([]);
    obey({ type: 'optimize', run: 1 });
    expect(messages).toEqual([expect.objectContaining({ type: 'failed', kind: 'internal' })]);
  });
});

describe('a run', () => {
  test('tells every evaluation once, its levels, and at last that it has ended', () => {
    open(1, { levels: [1, 2] });
    obey({ type: 'optimize', run: 1 });
    work();
    const samples = all('stepped').flatMap((message) => [...message.samples]);
    const evaluations = samples.filter((_, i) => i % SAMPLE_SIZE === 0);
    expect(evaluations).toEqual(evaluations.map((_, i) => i + 1));
    expect(all('levelEnded').map(({ report }) => report.level)).toEqual([1, 2]);
    const [ended] = all('ended');
    expect(ended.progress.totalEvaluations).toBe(evaluations.length);
    expect(ended.stop).toBe(all('levelEnded')[1].report.stop);
    // After the answer, everything that the page needs to rest.
    expect(types().slice(types().indexOf('ended'))).toEqual(['ended', 'surfaced', 'saved', 'measured']);
    expect(messages.at(-1).energies.bending).toBeCloseTo(all('levelEnded')[1].report.energyReported, 9);
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
