// SPDX-License-Identifier: MIT
/**
 * @file The page's end of the worker: sends commands, hands messages on, and replaces a worker that has stopped
 * answering or has failed.
 */

/** @import {Command, Message} from './protocol.js' */

/**
 * What the client needs of a `Worker`.
 * @typedef {Pick<Worker, 'postMessage' | 'terminate' | 'onmessage' | 'onerror'>} WorkerLike
 */

/**
 * Why a worker was replaced: it did not answer in time, it broke, or the page gave it up. One that cannot even load
 * is not replaced.
 * @typedef {'silent' | 'broken' | 'abandoned' | 'unloadable'} Loss
 */

/**
 * Milliseconds that a worker may be silent after pause or cancel; one energy evaluation, after which it answers,
 * takes much less.
 */
export const COMMAND_PATIENCE = 5_000;
/**
 * The same after it was asked to abandon a certificate: one step of it takes much less, but for the last, which nothing
 * else can end.
 */
export const ABANDON_PATIENCE = 1_000;
/** The same while it computes or opens a cage, where single steps of a very large cage take long. */
export const WORK_PATIENCE = 30_000;
/** Silence after which it is asked for a sign of life. */
export const PING_AFTER = 2_000;

const CHECK_INTERVAL = 500;

/**
 * @typedef {object} Client
 * @property {(command: Command) => void} send
 * @property {() => void} abandon gives the worker up and starts a new one
 * @property {() => void} dispose
 */

/**
 * @param {object} options
 * @param {() => WorkerLike} options.createWorker
 * @param {(message: Message) => void} options.onMessage
 * @param {(loss: Loss, detail: string) => void} options.onLost unless unloadable, a new worker has been started
 *   already, and knows no run
 * @returns {Client}
 */
export function createClient({ createWorker, onMessage, onLost }) {
  /** @type {WorkerLike} */
  let worker;
  /**
   * Pings without an answer yet. One follows every command; messages are answered in order, so its answer says that
   * the command is done.
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

  /** Looks at the clock for as long as the worker has something to do. */
  function watch() {
    timer ??= setInterval(() => {
      // Checks are counted, not the time between them: a machine that slept has not been silent. Nor is loading: a
      // slow network is not a hung worker.
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
    dispose: end,
  };
}
