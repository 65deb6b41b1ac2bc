// SPDX-License-Identifier: MIT
/**
 * @file Loads the core: the module that has threads where it can have some, else the one that has none. Makes the workers
 * in which the threads run, ahead of the calls that use them: a worker that waits for a call cannot begin another.
 */

import createCore from '../build/wasm/umbilic-core.mjs';

/** @import {Core, CoreOptions} from '../build/wasm/umbilic-core.mjs' */
/** @import {ThreadWorker, ThreadedCore} from '../build/wasm/umbilic-core-threads.mjs' */
/** @import {LoadOptions} from './memory.js' */

/**
 * A core, and how many threads it is to use at once. `prepareThreads` makes workers for so many threads, and says for how many
 * there are some, the calling thread included.
 * @typedef {{core: Core, threads: number, prepareThreads: (count: number) => Promise<number>}} Loaded
 */

/** More gain little: not all of the work is shared among them. */
const MOST_BY_DEFAULT = 8;

const ownWasmUrl = new URL('../build/wasm/umbilic-core.wasm', import.meta.url);
const threadedWasmUrl = new URL('../build/wasm/umbilic-core-threads.wasm', import.meta.url);

const inNode = () => Boolean(globalThis.process?.versions?.node);

/** Whether memory can be shared with workers, and this thread may wait for them. */
const mayHaveThreads = () => inNode() || (globalThis.crossOriginIsolated === true && !('document' in globalThis));

/**
 * Reads the binary in Node, where Emscripten's loader cannot fetch it.
 * @param {string | URL} wasmUrl
 * @returns {Promise<ArrayBuffer | Uint8Array | undefined>} undefined in a browser
 */
async function readBinaryInNode(wasmUrl) {
  if (!inNode()) return undefined;
  const { readFileSync } = process.getBuiltinModule('node:fs');
  const url = URL.canParse(wasmUrl) ? new URL(wasmUrl) : null;
  if (!url) return readFileSync(wasmUrl);
  if (url.protocol === 'file:') return readFileSync(process.getBuiltinModule('node:url').fileURLToPath(url.href));
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} answers ${response.status}`);
  return response.arrayBuffer();
}

/**
 * @template {Core} C
 * @param {(options: CoreOptions) => Promise<C>} start Emscripten's loader
 * @param {WebAssembly.Module} module
 * @returns {Promise<C>}
 */
function createFromModule(start, module) {
  return new Promise((resolve, reject) => {
    start({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports)
          .then((instance) => receive(instance, module))
          .catch(reject);
        return {};
      },
    }).then(resolve, reject);
  });
}

/**
 * @template {Core} C
 * @param {(options: CoreOptions) => Promise<C>} start
 * @param {URL} ownUrl
 * @param {LoadOptions} options
 * @returns {Promise<C>}
 */
async function create(start, ownUrl, { wasmUrl, wasmBinary, module }) {
  if (module) return createFromModule(start, module);
  const url = wasmUrl ?? ownUrl;
  const bytes = wasmBinary ?? (await readBinaryInNode(url));
  return start(bytes ? { wasmBinary: bytes } : { locateFile: () => String(url) });
}

/** A worker of thread.js in Node, with the members of one in a browser. @returns {ThreadWorker} */
function createNodeThread() {
  const { Worker: NodeWorker } = process.getBuiltinModule('node:worker_threads');
  const file = './thread.js';
  const worker = new NodeWorker(new URL(file, import.meta.url), { execArgv: [] }); // those of this program may be about its text
  /** @type {ThreadWorker} */
  const thread = {
    postMessage: (message) => worker.postMessage(message),
    terminate: () => void worker.terminate(),
    unref: () => worker.unref(),
  };
  worker.on('message', (data) => thread.onmessage?.({ data }));
  worker.on('error', (error) => thread.onerror?.(error));
  return thread;
}

/** @returns {ThreadWorker} */
const createThread = () =>
  inNode() ? createNodeThread() : new Worker(new URL('./thread.js', import.meta.url), { type: 'module' });

/**
 * Lends the core one more worker.
 * @param {ThreadedCore['PThread']} pool
 * @returns {Promise<boolean>} whether it works
 */
function addThread(pool) {
  return new Promise((resolve) => {
    const worker = createThread();
    pool.loadWasmModuleToWorker(worker, () => {
      pool.unusedWorkers.push(worker);
      worker.unref?.(); // from now on it does not keep a program from ending
      resolve(true);
    });
    worker.onerror = () => {
      worker.terminate();
      resolve(false);
    };
  });
}

/** @param {LoadOptions} options @param {number} threads @returns {Promise<Loaded>} */
async function loadThreaded(options, threads) {
  const { default: createThreadedCore } = await import('../build/wasm/umbilic-core-threads.mjs');
  const core = await create(createThreadedCore, threadedWasmUrl, options);
  /** Whether each of the workers works. @type {Array<Promise<boolean>>} */
  const workers = [];
  return {
    core,
    threads,
    async prepareThreads(count) {
      while (workers.length + 1 < count) workers.push(addThread(core.PThread));
      const working = (await Promise.all(workers)).filter(Boolean).length;
      return Math.min(count, 1 + working);
    },
  };
}

/** How many threads are asked for. @param {LoadOptions} options @returns {number | 'later'} */
function threadsOf({ threads, wasmUrl, wasmBinary, module }) {
  if (threads !== undefined) return threads;
  return inNode() || wasmUrl || wasmBinary || module ? 1 : Math.min(navigator.hardwareConcurrency, MOST_BY_DEFAULT);
}

/**
 * Loads a core, which has as many threads as the options ask for and as can be had.
 * @param {LoadOptions} options
 * @returns {Promise<Loaded>}
 */
export async function loadCore(options) {
  const { wasmUrl, wasmBinary, module } = options;
  const given = Object.entries({ wasmUrl, wasmBinary, module }).filter(([, value]) => value !== undefined);
  if (given.length > 1) throw new TypeError(`load: ${given.map(([name]) => name).join(' and ')} are given, not one`);
  const threads = threadsOf(options);
  if (threads !== 1 && mayHaveThreads()) {
    try {
      return await loadThreaded(options, threads === 'later' ? 1 : threads);
    } catch (error) {
      if (given.length) throw error;
    }
  }
  return { core: await create(createCore, ownWasmUrl, options), threads: 1, prepareThreads: async () => 1 };
}
