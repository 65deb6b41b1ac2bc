// SPDX-License-Identifier: MIT
/**
 * @file A worker's ends: loads the core, hands the page's commands on in their order, and posts what is answered.
 */
import { cageNames, load, version } from '../../wasm/umbilic.js';
import { transferables } from './protocol.js';

/** @import {Command, Message} from './protocol.js' */

/** @param {Message} message */
export function post(message) {
  self.postMessage(message, { transfer: transferables(message) });
}

/** A message to oneself queues behind those of the page; a timer would wait 4 ms. */
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
 * @param {() => (command: Command) => void} begin is called when the core is there
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
    await load();
    obey = begin();
    post({ type: 'started', version: version(), cages: cageNames() });
    early.forEach(obey);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    post({ type: 'failed', run: 0, kind: 'internal', message });
  }
}
