// SPDX-License-Identifier: MIT
/**
 * @file The worker's session on the real core, for tests: what it posts is kept, and it works when it is told to.
 */
import { beforeAll, beforeEach } from '@jest/globals';
import { Cage, InputError, Minimizer, load } from '../../wasm/umbilic.js';
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
    Object.assign(session, { messages: [], waiting: [], rests: 0, pace: 5 });
    session.obey = createSession({
      core: { Cage, InputError, Minimizer },
      post: (message) => session.messages.push(message),
      yieldThen: (task) => session.waiting.push(task),
      now: () => (clock += session.pace),
      rested: () => session.rests++,
    });
  });
}

/** @type {import('../../wasm/types.js').MinimizerOptions} */
export const options = { weights: { bending: 1 }, levels: [1, 1], cap: 'smooth' };

/** @param {number} run @param {any} [more] options @param {{then?: 'run' | 'step'}} [goesOn] */
export function open(run, more = {}, goesOn = {}) {
  const source = /** @type {const} */ ({ kind: 'generated', name: 'cube', family: 'flag', thickness: 1 });
  session.obey({ type: 'open', run, source, options: { ...options, ...more }, ...goesOn });
}

/** Lets the session work, `turns` yields at most. @param {number} [turns] */
export function work(turns = Infinity) {
  for (let i = 0; i < turns && session.waiting.length; i++) session.waiting.shift()?.();
}

export const types = () => session.messages.map(({ type }) => type);
/** @param {Message['type']} type */
export const all = (type) => session.messages.filter((message) => message.type === type);
