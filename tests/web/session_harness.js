// SPDX-License-Identifier: MIT
/**
 * @file The worker's session on the real core, for tests: what it posts is kept, and it works when it is told to.
 */
import { beforeAll, beforeEach } from '@jest/globals';
import { Cage, InputError, Minimizer, load, parseReport } from '../../wasm/umbilic.js';
import { createSession } from '../../web/worker/session.js';

/** @typedef {import('../../web/worker/protocol.js').Command} Command */
/** @typedef {import('../../web/worker/protocol.js').Message} Message */

/** Of the running test. */
export const session = {
  /** @type {any[]} */
  messages: [],
  /** Work that the session has put behind the messages that arrive. @type {Array<() => void>} */
  waiting: [],
  /** How often all has been told of a surface at rest. */
  rests: 0,
  /** Whether it has work for all processors. */
  busy: false,
  /** Milliseconds between two looks at the clock. */
  pace: 5,
  /** @type {(command: Command) => void} */
  obey: () => {},
};

/** A new session for each test of the file that calls this. */
export function useSession() {
  beforeAll(() => load());
  beforeEach(() => {
    let clock = 0;
    Object.assign(session, { messages: [], waiting: [], rests: 0, busy: false, pace: 5 });
    session.obey = createSession({
      core: { Cage, InputError, Minimizer, parseReport },
      post: (message) => session.messages.push(message),
      yieldThen: (task) => session.waiting.push(task),
      now: () => (clock += session.pace),
      rested: () => session.rests++,
      busy: (busy) => (session.busy = busy),
    });
  });
}

/**
 * Of bending on the cube at level 1, unless more is said.
 * @param {import('../../wasm/types.js').Options & Partial<import('../../wasm/types.js').Problem>} [more] options, and members beside them
 * @returns {import('../../wasm/types.js').Problem}
 */
export function problemOf({ cage = { generator: 'cube' }, terms = { bending: 1 }, start, ...options } = {}) {
  return { cage, terms, options: { levels: [1, 1], cap: 'smooth', ...options }, ...(start && { start }) };
}

/** @param {number} run @param {Parameters<typeof problemOf>[0]} [more] @param {{then?: 'run' | 'step', look?: boolean}} [how] */
export function open(run, more = {}, how = {}) {
  session.obey({ type: 'open', run, problem: problemOf(more), ...how });
}

/** Lets the session work, `turns` yields at most. @param {number} [turns] */
export function work(turns = Infinity) {
  for (let i = 0; i < turns && session.waiting.length; i++) session.waiting.shift()?.();
}

export const types = () => session.messages.map(({ type }) => type);
/** @param {Message['type']} type */
export const all = (type) => session.messages.filter((message) => message.type === type);
