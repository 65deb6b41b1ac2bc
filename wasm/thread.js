// SPDX-License-Identifier: MIT
/**
 * @file The worker of a thread of the core. It gets the module and its memory from the core that it is lent to, and then runs one
 * thread after the other: the part of Emscripten's own `worker.js` that threads need which call nothing but the core.
 */

import createThreadedCore from '../build/wasm/umbilic-core-threads.mjs';

/** @import {ThreadedCore} from '../build/wasm/umbilic-core-threads.mjs' */

/**
 * @typedef {{cmd: 'load', wasmModule: WebAssembly.Module, wasmMemory: WebAssembly.Memory}} Load
 * @typedef {{cmd: 'run', threadInfoStruct: number, start_routine: number, arg: number, time: number}} Run `time` is that of the
 *   lender's clock
 */

/** @type {ThreadedCore} */
let core;

/** Joins the memory of the core. Emscripten's loader answers `loaded`. @param {Load} message */
async function join({ wasmModule, wasmMemory }) {
  core = await createThreadedCore({
    ENVIRONMENT_IS_PTHREAD: true,
    wasmMemory,
    buffer: wasmMemory.buffer,
    instantiateWasm(imports, receive) {
      const instance = new WebAssembly.Instance(wasmModule, imports);
      receive(instance, wasmModule);
      return instance.exports;
    },
  });
}

/** Runs one thread to its end. @param {Run} message */
function run({ threadInfoStruct, start_routine: routine, arg, time }) {
  core.__performance_now_clock_drift = performance.now() - time;
  core.__emscripten_thread_init(threadInfoStruct, 0, 0, 1); // neither the page's thread nor the core's first one; it may wait
  core.establishStackSpace();
  core.PThread.threadInit();
  core.__emscripten_thread_exit(core.invokeEntryPoint(routine, arg));
}

/** @param {Load | Run} message */
function hear(message) {
  if (message.cmd === 'load') return join(message);
  if (message.cmd === 'run') run(message);
}

const port = globalThis.process?.getBuiltinModule?.('node:worker_threads').parentPort;
if (port) {
  // What Emscripten's loader calls.
  Object.assign(globalThis, { postMessage: (/** @type {unknown} */ message) => port.postMessage(message) });
  port.on('message', hear);
} else {
  self.onmessage = ({ data }) => hear(data);
}
