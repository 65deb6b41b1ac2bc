// SPDX-License-Identifier: MIT
/**
 * @file Minimizes one problem in a worker of its own, as a promise: what programs import as `umbilic/client`. The pages
 * of this project speak to their worker themselves (client.js).
 */
import { InputError, parse } from '../../wasm/values.js';
import { createClient } from './client.js';
import { withTopology } from './protocol.js';

/** @import {Mesh, Problem, Progress, Report} from '../../wasm/types.js' */
/** @import {Client, Loss, WorkerLike} from './client.js' */
/** @import {Message, Surfaced} from './protocol.js' */

export { InputError };

/**
 * A surface on the way. `limit` is the limit mesh with `density` quads along each edge of a patch, `control` the control
 * mesh. Surfaces of one level share the arrays of their triangles, faces and edges, so these must not be changed.
 * @typedef {{evaluations: number, limit: Mesh, density: number, control: Mesh}} Surface
 *
 * @typedef {object} MinimizeOptions
 * @property {AbortSignal} [signal] gives the run up: its worker ends, and the promise is rejected with the signal's reason
 * @property {AbortSignal} [stop] ends the run early: the promise is fulfilled with what has been found by then
 * @property {(progress: Progress) => void} [onProgress] at most 20 times per second
 * @property {(surface: Surface) => void} [onSurface] at most 15 times per second, and a finer one at the end
 * @property {() => WorkerLike} [createWorker] of the module `umbilic/worker`; by default from beside this file
 */

/** The number of the only run of a worker. */
const RUN = 1;

const createOwnWorker = () => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });

/** @type {Record<Loss, string>} */
const losses = {
  silent: 'the worker has stopped answering',
  broken: 'the worker has failed',
  abandoned: 'the worker was given up',
  unloadable: 'the worker could not be loaded',
};

/** @param {Loss} loss @param {string} detail */
const lossError = (loss, detail) => new Error(detail ? `${losses[loss]}: ${detail}` : losses[loss]);

/** Completes the meshes that come without the topology that they share with those before. */
function createCompletion() {
  /** @type {Surface | undefined} */
  let last;
  /** @param {Surfaced} message @returns {Surface} */
  return ({ evaluations, limit, density, control }) => {
    last = {
      evaluations,
      limit: withTopology(limit, last?.limit),
      density,
      control: withTopology(control, last?.control),
    };
    return last;
  };
}

/**
 * @param {MinimizeOptions} options
 * @param {() => void} finish called when the run has ended
 * @param {(report: Report) => void} resolve
 * @param {(error: unknown) => void} reject
 * @returns {(message: Message) => void}
 */
function createHearing({ onProgress, onSurface }, finish, resolve, reject) {
  const completed = createCompletion();
  /** @param {Message} message */
  function hear(message) {
    switch (message.type) {
      case 'stepped':
        return onProgress?.(message.progress);
      case 'surfaced':
        return onSurface?.(completed(message));
      case 'ended':
        return finish();
      case 'exported':
        return resolve(parse(String(message.content)));
      case 'failed':
        return reject(new InputError(message.message));
    }
  }
  return (message) => {
    try {
      hear(message);
    } catch (error) {
      reject(error);
    }
  };
}

/**
 * Minimizes a problem in a new worker, which ends with it.
 * @param {Problem | Report | string} problem or its text; a report's run continues where the report ended
 * @param {MinimizeOptions} [options]
 * @returns {Promise<Report>} rejected with an `InputError` if something is wrong with the problem, with the signal's reason,
 *   with what a callback throws, or with an `Error` if the worker fails
 */
export async function minimize(problem, options = {}) {
  const { signal, stop, createWorker = createOwnWorker } = options;
  signal?.throwIfAborted();
  const listening = new AbortController();
  /** @type {Client | undefined} */
  let client;
  try {
    return await new Promise((resolve, reject) => {
      /** @param {import('./protocol.js').Command} command */
      const send = (command) => client?.send(command);
      const finish = () => send({ type: 'export', run: RUN, what: 'report' });
      const end = () => send({ type: 'cancel', run: RUN });
      client = createClient({
        createWorker,
        onMessage: createHearing(options, finish, resolve, reject),
        onLost: (loss, detail) => reject(lossError(loss, detail)),
      });
      signal?.addEventListener('abort', () => reject(signal.reason), { signal: listening.signal });
      stop?.addEventListener('abort', end, { signal: listening.signal });
      send({ type: 'open', run: RUN, problem: /** @type {Problem | string} */ (problem), then: 'run' });
      if (stop?.aborted) end();
    });
  } finally {
    listening.abort();
    client?.dispose();
  }
}
