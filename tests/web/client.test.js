// SPDX-License-Identifier: MIT
/**
 * @file The page's end of the worker: what it takes for a sign of life, and when it replaces a worker.
 */
import { afterEach, beforeEach, describe, expect, jest, test } from '@jest/globals';
import {
  ABANDON_PATIENCE,
  COMMAND_PATIENCE,
  PING_AFTER,
  WORK_PATIENCE,
  createClient,
} from '../../web/worker/client.js';
import { createSpare } from '../../web/worker/spare.js';
import { progress } from './studio/state.js';

/** A worker whose answers the test gives. */
class ScriptedWorker {
  /** @type {any[]} */
  commands = [];
  terminated = false;
  /** @type {any} */
  onmessage = null;
  /** @type {any} */
  onerror = null;
  /** @param {any} command */
  postMessage(command) {
    this.commands.push(command);
  }
  terminate() {
    this.terminated = true;
  }
  /** @param {any} message */
  say(message) {
    this.onmessage?.({ data: message });
  }
  /** Answers every ping so far. */
  pong() {
    for (const { type } of this.commands.splice(0)) if (type === 'ping') this.say({ type: 'ponged' });
  }
}

/** @type {ScriptedWorker[]} */
let workers;
/** @type {any[]} */
let messages;
/** @type {Array<[string, string]>} */
let losses;
/** @type {import('../../web/worker/client.js').Client} */
let client;

beforeEach(() => {
  jest.useFakeTimers();
  workers = [];
  messages = [];
  losses = [];
  client = createClient({
    createWorker: () => {
      const worker = new ScriptedWorker();
      workers.push(worker);
      return worker;
    },
    onMessage: (message) => messages.push(message),
    onLost: (loss, detail) => losses.push([loss, detail]),
  });
});

afterEach(() => {
  client.dispose();
  jest.useRealTimers();
});

const last = () => workers[workers.length - 1];

function load() {
  last().say({ type: 'started', version: '1', cages: [] });
  last().pong();
}

const stepped = { type: 'stepped', run: 1, progress: progress(0, 1), samples: new Float64Array(4) };

describe('a spare worker', () => {
  test('says again what it said before it was taken, in its order, and is followed by others', async () => {
    const made = workers.length;
    const take = createSpare(() => {
      workers.push(new ScriptedWorker());
      return last();
    });
    const spare = workers[made];
    const started = { type: 'started', version: '1', cages: [] };
    spare.say(started);
    client.dispose();
    client = createClient({ createWorker: take, onMessage: (message) => messages.push(message), onLost: () => {} });
    expect(workers).toHaveLength(made + 1);
    await Promise.resolve();
    expect(messages).toEqual([started]);
    client.abandon();
    expect(workers).toHaveLength(made + 2);
  });

  test('that could not load is told so when it is taken', async () => {
    const take = createSpare(() => {
      workers.push(new ScriptedWorker());
      return last();
    });
    last().onerror?.(/** @type {any} */ ({ message: 'no network' }));
    client.dispose();
    client = createClient({
      createWorker: take,
      onMessage: () => {},
      onLost: (loss, detail) => losses.push([loss, detail]),
    });
    await Promise.resolve();
    expect(losses).toEqual([['unloadable', 'no network']]);
    const made = workers.length;
    client.restart();
    expect(workers).toHaveLength(made + 1);
    load();
    expect(losses).toHaveLength(1);
  });
});

describe('a worker', () => {
  test('may take its time to load', () => {
    jest.advanceTimersByTime(10 * WORK_PATIENCE);
    expect(losses).toEqual([]);
    load();
    expect(messages).toEqual([{ type: 'started', version: '1', cages: [] }]);
  });

  test('that rests is left alone: no timer runs', () => {
    load();
    jest.advanceTimersByTime(1000);
    expect(jest.getTimerCount()).toBe(0);
  });

  test('that computes and is silent is asked for a sign of life, and kept when it gives one', () => {
    load();
    client.send({ type: 'optimize', run: 1 });
    last().pong();
    jest.advanceTimersByTime(PING_AFTER + 1000);
    expect(last().commands).toEqual([{ type: 'ping' }]);
    for (let i = 0; i < 40; i++) {
      last().pong();
      jest.advanceTimersByTime(WORK_PATIENCE / 4);
    }
    expect(losses).toEqual([]);
  });

  test('that steps is never pinged', () => {
    load();
    client.send({ type: 'optimize', run: 1 });
    last().pong();
    for (let i = 0; i < 100; i++) {
      last().say(stepped);
      jest.advanceTimersByTime(PING_AFTER / 2);
    }
    expect(last().commands).toEqual([]);
  });

  test('that does not answer a pause is replaced within seconds', () => {
    load();
    client.send({ type: 'optimize', run: 1 });
    last().pong();
    client.send({ type: 'pause', run: 1 });
    jest.advanceTimersByTime(COMMAND_PATIENCE - 500);
    expect(losses).toEqual([]);
    jest.advanceTimersByTime(1000);
    expect(losses).toEqual([['silent', '']]);
    expect(workers).toHaveLength(2);
    expect(workers[0].terminated).toBe(true);
    expect(workers[1].terminated).toBe(false);
  });

  test('that is silent while it computes is replaced after its patience, without being asked anything', () => {
    load();
    client.send({ type: 'optimize', run: 1 });
    last().pong();
    last().say(stepped);
    jest.advanceTimersByTime(WORK_PATIENCE - 500);
    expect(losses).toEqual([]);
    jest.advanceTimersByTime(1000);
    expect(losses).toEqual([['silent', '']]);
  });

  test('that makes a certificate may be silent for as long as it takes, until it is asked to abandon it', () => {
    load();
    client.send({ type: 'certify', run: 1 });
    last().pong();
    jest.advanceTimersByTime(10 * WORK_PATIENCE);
    expect(losses).toEqual([]);
    client.send({ type: 'abandonCertificate', run: 1 });
    jest.advanceTimersByTime(ABANDON_PATIENCE + 1000);
    expect(losses).toEqual([['silent', '']]);
  });

  test('is not heard any more once it is replaced', () => {
    load();
    client.abandon();
    expect(losses).toEqual([['abandoned', '']]);
    messages.length = 0;
    workers[0].say(stepped);
    expect(messages).toEqual([]);
  });

  test('that fails in itself is replaced, one that refuses a file is not', () => {
    load();
    last().say({ type: 'failed', run: 2, kind: 'input', message: 'line 3: no' });
    expect(losses).toEqual([]);
    expect(messages.at(-1)).toMatchObject({ kind: 'input' });
    last().say({ type: 'failed', run: 2, kind: 'internal', message: 'memory access out of bounds' });
    expect(losses).toEqual([['broken', 'memory access out of bounds']]);
    expect(workers).toHaveLength(2);
  });

  test('that cannot load is not tried again and again', () => {
    last().onerror({ message: 'no such file' });
    expect(losses).toEqual([['unloadable', 'no such file']]);
    expect(workers).toHaveLength(1);
    jest.advanceTimersByTime(WORK_PATIENCE * 3);
    expect(losses).toHaveLength(1);
  });

  test('is ended with the client', () => {
    load();
    client.send({ type: 'optimize', run: 1 });
    client.dispose();
    expect(last().terminated).toBe(true);
    expect(jest.getTimerCount()).toBe(0);
  });
});
