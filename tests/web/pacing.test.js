// SPDX-License-Identifier: MIT
/**
 * @file When a run goes on: one unit of work between two messages, until it rests.
 */
import { beforeEach, describe, expect, test } from '@jest/globals';
import { createPacing } from '../../web/worker/pacing.js';

/** @type {Array<() => void>} */
let waiting;
let clock = 0;
/** @type {ReturnType<typeof createPacing>} */
let pacing;
/** @type {string[]} */
let done;

beforeEach(() => {
  waiting = [];
  clock = 0;
  done = [];
  pacing = createPacing({ yieldThen: (task) => waiting.push(task), now: () => clock });
});

/** @param {string} name */
const unit = (name) => () => void done.push(name);

describe('a pace', () => {
  test('does one unit for each turn, and goes on behind what has arrived since', () => {
    pacing.go('running', unit('a'));
    expect(done).toEqual([]);
    for (let i = 0; i < 3; i++) {
      expect(waiting).toHaveLength(1);
      waiting.shift()?.();
    }
    expect(done).toEqual(['a', 'a', 'a']);
  });

  test('that rests does nothing more, also of what has been scheduled', () => {
    pacing.go('running', unit('a'));
    pacing.rest();
    waiting.shift()?.();
    expect([done, waiting, pacing.pace]).toEqual([[], [], 'resting']);
  });

  test('that is told to go twice does not go twice as fast', () => {
    pacing.go('running', unit('a'));
    pacing.go('stepping', unit('b'));
    expect(waiting).toHaveLength(1);
    waiting.shift()?.();
    expect([done, pacing.pace]).toEqual([['b'], 'stepping']);
  });

  test('may rest in a unit of work, whose cost is known', () => {
    expect(pacing.cost).toBe(Infinity);
    pacing.go('running', () => {
      pacing.timed(() => (clock += 7));
      pacing.rest();
    });
    waiting.shift()?.();
    expect([waiting, pacing.cost]).toEqual([[], 7]);
  });
});
