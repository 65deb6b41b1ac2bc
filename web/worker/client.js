// SPDX-License-Identifier: MIT
/**
 * @file The page's side of the worker: sends commands, passes messages on, and replaces a worker that fails or stops
 * answering.
 */

/** @import {Command, Message} from './protocol.js' */

/**
 * The members of `Worker` that the client needs.
 * @typedef {Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>} WorkerLike
 */

/**
 * Why a worker was replaced: it did not answer in time, it failed, or the page gave it up. `unloadable`: it could not
 * load, and is not replaced.
 * @typedef {'silent' | 'broken' | 'abandoned' | 'unloadable'} Loss
 */

/**
 * How long a worker may be silent after pause or cancel, in milliseconds. It answers after one energy evaluation, which
 * takes much less.
 */
export const COMMAND_PATIENCE = 5_000;
/**
 * The same after the page asked to abandon a certificate. A step takes much less, except for the last one, which cannot
 * be interrupted.
 */
export const ABANDON_PATIENCE = 1_000;
/** The same while it computes or opens a cage, since single steps of a very large cage take long. */
export const WORK_PATIENCE = 30_000;
/** After this silence the client sends a ping. */
export const PING_AFTER = 2_000;

const CHECK_INTERVAL = 500;

/**
 * @typedef {object} Client
 * @property {(command: Command) => void} send
 * @property {() => void} abandon stops the worker and starts a new one
 * @property {() => void} restart starts a new worker in the place of one that could not load
 * @property {() => void} dispose
 */

/**
 * @param {object} options
 * @param {() => WorkerLike} options.createWorker
 * @param {(message: Message) => void} options.onMessage
 * @param {(loss: Loss, detail: string) => void} options.onLost called after a new worker, which has no run, has been
 *   started (none if it was unloadable)
 * @returns {Client}
 */
export function createClient({ createWorker, onMessage, onLost }) {
  /** @type {WorkerLike} */
  let worker;
  /**
   * The number of pings without an answer. Each command is followed by a ping, and messages are answered in order, so
   * the answer means that the command is done.
   */
  let pings = 0;
  let running = false;
  let loaded = false;
  let silence = 0;
  let patience = WORK_PATIENCE;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let timer;

  function start() {
    const mine = createWorker();
    worker = mine;
    pings = 0;
    running = false;
    loaded = false;
    silence = 0;
    patience = WORK_PATIENCE;
    mine.onmessage = ({ data }) => {
      if (mine === worker) hear(/** @type {Message} */ (data));
    };
    mine.onerror = (event) => {
      if (mine === worker) lose('broken', event.message ?? '');
    };
    ping();
  }

  function ping() {
    pings++;
    worker.postMessage({ type: 'ping' });
    watch();
  }

  /** @param {Message} message */
  function hear(message) {
    silence = 0;
    switch (message.type) {
      case 'ponged':
        pings--;
        if (pings === 0) patience = WORK_PATIENCE;
        return;
      case 'started':
        loaded = true;
        break;
      case 'stepped':
        running = true;
        watch();
        break;
      case 'paused':
      case 'ended':
        running = false;
        break;
      case 'failed':
        if (message.kind === 'internal') return lose('broken', message.message);
        break;
    }
    onMessage(message);
  }

  /** Checks for silence as long as the worker has something to do. */
  function watch() {
    timer ??= setInterval(() => {
      // Counts checks rather than time, so that a machine that was asleep does not count as silence. Loading does not
      // count either: a slow network is not a hung worker.
      if (loaded) silence += CHECK_INTERVAL;
      if (pings === 0 && !running) stopWatching();
      else if (silence > patience) lose('silent', '');
      else if (silence > PING_AFTER && pings === 0) ping();
    }, CHECK_INTERVAL);
  }

  function stopWatching() {
    clearInterval(timer);
    timer = undefined;
  }

  function end() {
    stopWatching();
    worker.onmessage = null;
    worker.onerror = null;
    worker.terminate();
  }

  /** @param {Loss} loss @param {string} detail */
  function lose(loss, detail) {
    const final = loss === 'broken' && !loaded;
    end();
    if (!final) start();
    onLost(final ? 'unloadable' : loss, detail);
  }

  start();
  return {
    send(command) {
      if (pings === 0 && !running) silence = 0;
      if (command.type === 'optimize' || command.type === 'step') running = true;
      if (command.type === 'open') running = command.then !== undefined;
      if (command.type === 'pause' || command.type === 'cancel') {
        silence = 0;
        patience = COMMAND_PATIENCE;
      }
      if (command.type === 'abandonCertificate') {
        silence = 0;
        patience = ABANDON_PATIENCE;
      }
      worker.postMessage(command);
      ping();
    },
    abandon: () => lose('abandoned', ''),
    restart() {
      end();
      start();
    },
    dispose: end,
  };
}
