// SPDX-License-Identifier: MIT
/**
 * @file The studio without a page, for tests: its reducer and its effects with the worker's session on the real core, which
 * works when it is told to.
 */
import { Cage, InputError, Minimizer, parseReport } from '../../../wasm/umbilic.js';
import { parseStudioAddress } from '../../../web/address/studio.js';
import { createEffects } from '../../../web/pages/studio/effects.js';
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { createSession } from '../../../web/worker/session.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** Its meshes are no finer than the tests need. */
class CoarseMinimizer extends Minimizer {
  /** @param {number} density */
  limitMesh(density) {
    return super.limitMesh(Math.min(density, 2));
  }
}

/** The core for a session. */
export const core = { Cage, InputError, Minimizer: CoarseMinimizer, parseReport };

/** @param {string} [search] of the address @param {State} [begun] the state to begin with */
export function createStudio(search = '', begun = initialState('system', parseStudioAddress(search))) {
  /** Commands and work, in their order. @type {Array<() => void>} */
  const waiting = [];
  /** @type {Array<{name: string, text: string}>} */
  const files = [];
  let clock = 0;
  let state = begun;
  let obey = createWorker();

  function createWorker() {
    const mine = createSession({
      core,
      post: (message) => obey === mine && dispatch({ type: 'answered', message }),
      yieldThen: (task) => waiting.push(task),
      now: () => (clock += 5),
    });
    return mine;
  }

  const effects = createEffects({
    client: {
      send: (command) => waiting.push(() => obey(command)),
      abandon() {},
      restart() {},
    },
    save: (name, content) => files.push({ name, text: String(content) }),
    takePicture() {},
    load() {},
    setAddress() {},
  });

  /** @param {Action} action */
  function dispatch(action) {
    const before = state;
    state = reduce(before, action);
    effects(action, before, state);
  }

  effects(null, null, state);
  dispatch({ type: 'answered', message: { type: 'started', version: '1', cages: ['cube', 'two-3'] } });
  return {
    files,
    get state() {
      return state;
    },
    dispatch,

    /** Lets the worker work, so many turns at most. @param {number} [turns] */
    work(turns = Infinity) {
      for (let i = 0; i < turns && waiting.length; i++) waiting.shift()?.();
    },

    /** Does these things one after the other, each when the worker has done all for the one before. @param {...Action} actions */
    do(...actions) {
      this.work();
      for (const action of actions) {
        dispatch(action);
        this.work();
      }
    },

    /** The worker is gone, and what it was about to do. @param {import('../../../web/worker/client.js').Loss} loss */
    lose(loss) {
      waiting.length = 0;
      obey = createWorker();
      dispatch({ type: 'workerLost', loss, detail: '' });
    },
  };
}

/** A deep copy of plain data, as the store gives it back. @param {any} value @returns {any} */
export function copied(value) {
  if (ArrayBuffer.isView(value)) return /** @type {any} */ (value).slice();
  if (value instanceof Map) return new Map([...value].map(([key, part]) => [key, copied(part)]));
  if (Array.isArray(value)) return value.map(copied);
  if (!value || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, copied(part)]));
}

/** The text of plain data; numbers in arrays of bytes by their bits. @param {unknown} value */
export const bytes = (value) =>
  JSON.stringify(value, (_, part) =>
    ArrayBuffer.isView(part)
      ? Buffer.from(part.buffer, part.byteOffset, part.byteLength).toString('base64')
      : part === undefined
        ? null
        : Number.isNaN(part)
          ? 'NaN'
          : part,
  );
