// SPDX-License-Identifier: MIT
/**
 * @file A worker that only answers, both ends of it joined: each question has its own answer.
 */
import { afterEach, describe, expect, test } from '@jest/globals';
import { answerRequests, createRequests } from '../../web/worker/requests.js';

/** @type {any} */
const scope = globalThis;
const before = scope.self;
afterEach(() => (scope.self = before));

/**
 * Both ends in one thread.
 * @param {() => Promise<void>} load
 * @param {(question: any) => {answer: any, transfer?: ArrayBuffer[]}} answer
 */
function joined(load, answer) {
  /** @type {any[]} */
  const posted = [];
  let workers = 0;
  const ask = createRequests(() => {
    workers++;
    const page = /** @type {any} */ ({ postMessage: (/** @type {any} */ data) => scope.self.onmessage({ data }) });
    scope.self = {
      postMessage(/** @type {any} */ data, /** @type {any} */ options) {
        posted.push(options?.transfer);
        page.onmessage({ data });
      },
    };
    answerRequests(load, answer);
    return page;
  });
  return { ask, posted, workers: () => workers };
}

describe('questions', () => {
  test('have their own answers; the worker begins with the first, loads once, and hands buffers over', async () => {
    let loads = 0;
    const buffer = new ArrayBuffer(8);
    const { ask, posted, workers } = joined(
      async () => void loads++,
      (question) => ({ answer: 2 * question, ...(question > 1 && { transfer: [buffer] }) }),
    );
    expect(workers()).toBe(0);
    expect(await Promise.all([ask(1), ask(2), ask(3)])).toEqual([2, 4, 6]);
    expect([workers(), loads]).toEqual([1, 1]);
    expect(posted).toEqual([[], [buffer], [buffer]]);
  });

  test('fail alone, with the reason', async () => {
    const { ask } = joined(
      async () => {},
      (question) => {
        if (question < 0) throw new Error('no such torus');
        return { answer: question };
      },
    );
    const answers = await Promise.allSettled([ask(-1), ask(5)]);
    expect(answers).toMatchObject([{ reason: { message: 'no such torus' } }, { value: 5 }]);
  });

  test('all fail where the core cannot be loaded', async () => {
    const { ask } = joined(
      () => Promise.reject(new Error('no WebAssembly')),
      () => ({ answer: 1 }),
    );
    await expect(ask(1)).rejects.toThrow('no WebAssembly');
    await expect(ask(2)).rejects.toThrow('no WebAssembly');
  });
});
