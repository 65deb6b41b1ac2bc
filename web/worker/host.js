// SPDX-License-Identifier: MIT
/**
 * @file Connects a worker to the page: loads the core, passes the page's commands on in order, and posts the answers.
 */
import { cageNames, load, version } from '../../wasm/umbilic.js';
import { transferables } from './protocol.js';

/** @import {Command, Message} from './protocol.js' */

/** @param {Message} message */
export function post(message) {
  self.postMessage(message, { transfer: transferables(message) });
}

/** A message to itself is queued behind the page's messages; a timer would wait at least 4 ms. */
const channel = new MessageChannel();
/** @type {Array<() => void>} */
const tasks = [];
channel.port1.onmessage = () => tasks.shift()?.();

/** @param {() => void} task runs after the messages that have arrived */
export function yieldThen(task) {
  tasks.push(task);
  channel.port2.postMessage(null);
}

/**
 * @param {() => (command: Command) => void} begin called when the core has been loaded
 */
export async function host(begin) {
  /** @type {((command: Command) => void) | undefined} */
  let obey;
  /** @type {Command[]} */
  const early = [];
  self.onmessage = (/** @type {MessageEvent<Command>} */ event) => {
    if (obey) obey(event.data);
    else early.push(event.data);
  };
  try {
    await load({ threads: 'later' });
    obey = begin();
    post({ type: 'started', version: version(), cages: cageNames() });
    early.forEach(obey);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    post({ type: 'failed', run: 0, kind: 'internal', message });
  }
}
