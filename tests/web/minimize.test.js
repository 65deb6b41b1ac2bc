// SPDX-License-Identifier: MIT
/**
 * @file Minimizing in a worker as a promise, with the worker's session on the real core: what it resolves to, what it tells on
 * the way, and how it ends early or fails.
 */
import { beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { load } from '../../wasm/umbilic.js';
import { InputError, minimize } from '../../web/worker/minimize.js';
import { createSession } from '../../web/worker/session.js';
import { core } from './studio/real.js';

/** @typedef {import('../../web/worker/protocol.js').Message} Message */

/** A worker in this thread: every command and every part of its work is a task of its own, until it is terminated. */
class SessionWorker {
  /** @type {any} */
  onmessage = null;
  /** @type {any} */
  onerror = null;
  terminated = false;

  constructor() {
    const post = (/** @type {Message} */ message) => this.onmessage?.({ data: structuredClone(message) });
    const yieldThen = (/** @type {() => void} */ task) => void setImmediate(() => this.terminated || task());
    const session = createSession({ core, post, yieldThen, now: () => performance.now() });
    /** @param {any} command */
    this.postMessage = (command) => yieldThen(() => session(structuredClone(command)));
    yieldThen(() => post({ type: 'started', version: '', cages: [] }));
  }

  terminate() {
    this.terminated = true;
  }
}

/** @type {SessionWorker[]} */
let workers;
const createWorker = () => {
  workers.push(new SessionWorker());
  return workers[workers.length - 1];
};

beforeAll(() => load());
beforeEach(() => {
  workers = [];
});

/** @type {import('../../wasm/types.js').Problem} */
const problem = { cage: { generator: 'two-3' }, terms: { bending: 1 }, options: { levels: [0, 1] } };
const long = { ...problem, options: { levels: /** @type {[number, number]} */ ([0, 6]) } };

const expectEnded = () => expect(workers.map(({ terminated }) => terminated)).toEqual(workers.map(() => true));

/** The report of a run in this thread. @param {import('../../wasm/types.js').Problem | string} asked */
function directly(asked) {
  const minimizer = new core.Minimizer(asked);
  while (!minimizer.step(10));
  const report = core.parseReport(minimizer.report());
  minimizer.dispose();
  return report;
}

describe('a run', () => {
  test('resolves to the report, and its worker ends', async () => {
    const report = await minimize(problem, { createWorker });
    const { energies, limit, surface } = directly(problem);
    expect(report).toMatchObject({ umbilic: 'report', energies, limit, surface });
    expect(workers).toHaveLength(1);
    expectEnded();
    // A report is also a problem.
    expect((await minimize(report, { createWorker })).energies.bending).toBeLessThanOrEqual(energies.bending);
  });

  test('tells its progress and complete surfaces', async () => {
    /** @type {number[]} */
    const levels = [];
    /** @type {import('../../web/worker/minimize.js').Surface[]} */
    const surfaces = [];
    await minimize(problem, {
      createWorker,
      onProgress: ({ level }) => levels.push(level),
      onSurface: (surface) => surfaces.push(surface),
    });
    expect(levels.at(-1)).toBe(1);
    expect(surfaces.length).toBeGreaterThan(1);
    for (const { limit, control, density } of surfaces) {
      const vertices = limit.positions.length / 3;
      // Quads of a surface of genus 2 have V - Q = -2.
      expect(limit.triangles.length / 3).toBe(2 * (vertices + 2));
      expect(Math.max(...limit.triangles)).toBe(vertices - 1);
      expect(control.edges.length).toBeGreaterThan(0);
      expect(density).toBeGreaterThan(0);
    }
  });
});

describe('it ends early', () => {
  test('by the signal, with its reason', async () => {
    const abort = new AbortController();
    const reason = new Error('enough');
    const run = minimize(long, { createWorker, signal: abort.signal, onSurface: () => abort.abort(reason) });
    await expect(run).rejects.toBe(reason);
    expectEnded();
  });

  test('before a worker begins, if the signal has come', async () => {
    await expect(minimize(problem, { createWorker, signal: AbortSignal.abort() })).rejects.toThrow(/abort/);
    expect(workers).toEqual([]);
  });

  test('by the other signal, with the report of what has been found', async () => {
    const stop = new AbortController();
    const run = minimize(long, { createWorker, stop: stop.signal, onSurface: () => stop.abort() });
    const report = await run;
    expect(report.levels.at(-1)?.stop).toBe('cancelled');
    expect(report.energies.bending).toBeGreaterThan(0);
    expectEnded();
    const atOnce = await minimize(long, { createWorker, stop: AbortSignal.abort() });
    expect(atOnce.problem.options?.levels).toEqual([0, 6]);
  });
});

describe('it fails', () => {
  test.each([
    [{ ...problem, terms: { bendig: 1 } }, /bendig/],
    [{ terms: { bending: 1 } }, /cage/],
    [null, /null is no problem/],
    ['{', /./],
  ])('with the error of the core, of %j', async (asked, message) => {
    const run = minimize(/** @type {any} */ (asked), { createWorker });
    await expect(run).rejects.toThrow(InputError);
    await expect(run).rejects.toThrow(message);
    expectEnded();
  });

  test('with what a callback throws', async () => {
    const error = new Error('of the page');
    const onSurface = () => {
      throw error;
    };
    await expect(minimize(problem, { createWorker, onSurface })).rejects.toBe(error);
    expectEnded();
  });

  test('if the worker cannot be loaded, or breaks off', async () => {
    const unloadable = () => {
      const worker = createWorker();
      worker.postMessage = () => worker.onerror?.({ message: 'not found' });
      return worker;
    };
    await expect(minimize(problem, { createWorker: unloadable })).rejects.toThrow('could not be loaded: not found');
    const breaking = minimize(problem, {
      createWorker,
      onProgress: () => workers.at(-1)?.onerror({ message: 'out of memory' }),
    });
    await expect(breaking).rejects.toThrow('the worker has failed: out of memory');
    expectEnded();
  });

  test('if there can be no worker', async () => {
    const forbidden = () => {
      throw new Error('not allowed');
    };
    await expect(minimize(problem, { createWorker: forbidden })).rejects.toThrow('not allowed');
  });
});
