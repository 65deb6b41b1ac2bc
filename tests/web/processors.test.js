// SPDX-License-Identifier: MIT
/**
 * @file The processors that workers share: no two compute on the same one, and none is idle while a busy worker could have it.
 */
import { setImmediate as nextTurn } from 'node:timers/promises';
import { beforeEach, expect, test } from '@jest/globals';
import { createProcessors } from '../../web/worker/processors.js';

/** The browser's locks, without modes: who waits for a lock gets it in turn. */
function createLocks() {
  /** @type {Map<string, Array<() => Promise<void>>>} */
  const queues = new Map();
  return /** @type {LockManager} */ (
    /** @type {unknown} */ ({
      /** @param {string} name @param {{signal: AbortSignal}} options @param {() => any} held */
      request(name, { signal }, held) {
        return new Promise((resolve, reject) => {
          const queue = queues.get(name) ?? [];
          queues.set(name, queue);
          const turn = async () => {
            signal.removeEventListener('abort', giveUp);
            resolve(await held());
            queue.shift();
            void queue[0]?.();
          };
          const giveUp = () => {
            queue.splice(queue.indexOf(turn), 1);
            reject(signal.reason);
          };
          signal.addEventListener('abort', giveUp);
          if (queue.push(turn) === 1) setImmediate(turn);
        });
      },
    })
  );
}

/** What each worker computes on. @type {number[]} */
let threads;
/** @type {Array<(busy: boolean) => void>} */
let workers;
beforeEach(() => {
  const locks = createLocks();
  threads = [1, 1, 1];
  workers = threads.map((_, i) => createProcessors({ locks, count: 4, use: (count) => (threads[i] = count) }));
});

/** Locks are given a turn later, one after the other. */
async function settled() {
  for (let turn = 0; turn < 20; turn++) await nextTurn();
}

test('a busy worker has all, and at rest only its own', async () => {
  workers[0](true);
  workers[0](true);
  await settled();
  expect(threads).toEqual([4, 1, 1]);
  workers[0](false);
  expect(threads).toEqual([1, 1, 1]);
});

test('of two that are busy the second one has only its own', async () => {
  workers[0](true);
  workers[1](true);
  await settled();
  expect(threads).toEqual([4, 1, 1]);
});

test('what one gives back, another gets that waits for it', async () => {
  for (const worker of workers) worker(true);
  await settled();
  workers[1](false);
  workers[0](false);
  await settled();
  expect(threads).toEqual([1, 1, 4]);
});

test('one that rests before it gets any has none', async () => {
  workers[0](true);
  workers[0](false);
  workers[0](true);
  await settled();
  expect(threads).toEqual([4, 1, 1]);
  workers[0](false);
  workers[1](true);
  await settled();
  expect(threads).toEqual([1, 4, 1]);
});

test('without locks nothing is asked for', () => {
  const use = () => {
    throw new Error('used');
  };
  const alone = createProcessors({ locks: undefined, count: 4, use });
  alone(true);
  alone(false);
});
