// SPDX-License-Identifier: MIT
/**
 * @file The worker's entry: loads the core and connects a session to the page.
 */
import { Cage, InputError, Minimizer, cageNames, load, version } from '../../wasm/umbilic.js';
import { transferables } from './protocol.js';
import { createSession } from './session.js';
import { warmUp } from './warm_up.js';

/** @import {Command, Message} from './protocol.js' */

/** @param {Message} message */
function post(message) {
  self.postMessage(message, { transfer: transferables(message) });
}

/** A message to oneself queues behind those of the page; a timer would wait 4 ms. */
const channel = new MessageChannel();
/** @type {Array<() => void>} */
const tasks = [];
channel.port1.onmessage = () => tasks.shift()?.();

/** @param {() => void} task */
function yieldThen(task) {
  tasks.push(task);
  channel.port2.postMessage(null);
}

/** @type {(command: Command) => void} */
let obey;
/** @type {Command[]} */
const early = [];
self.onmessage = (/** @type {MessageEvent<Command>} */ event) => {
  if (obey) obey(event.data);
  else early.push(event.data);
};

try {
  await load();
  obey = createSession({ core: { Cage, InputError, Minimizer }, post, yieldThen, now: () => performance.now() });
  post({ type: 'started', version: version(), cages: cageNames() });
  early.forEach(obey);
  warmUp({ Cage, Minimizer }, yieldThen);
} catch (error) {
  const message = error instanceof Error ? error.message : String(error);
  post({ type: 'failed', run: 0, kind: 'internal', message });
}
