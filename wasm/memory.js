// SPDX-License-Identifier: MIT
/**
 * @file Loads the core, calls it, and copies values in and out of it. This is the only file that touches WebAssembly
 * memory. Views of that memory become invalid when it grows, so they are taken again after every call. Every failure
 * reaches the caller as an `Error` with a message.
 */

import { loadCore } from './loading.js';
import { InputError, parse } from './values.js';

/** @import {Core} from '../build/wasm/umbilic-core.mjs' */
/** @import {ThreadedCore} from '../build/wasm/umbilic-core-threads.mjs' */
/** @import {Loaded} from './loading.js' */
/** @import {Mesh} from './types.js' */

/** UMBILIC_API_VERSION of the contract for which this file was written. */
const API_VERSION = 3;

/** The most threads that umbilic_use_threads takes. */
const MOST_THREADS = 256;

/** Size of the buffer for a call's results; the largest is umbilic_mesh_arrays, nine words of 32 bits and three doubles. */
const SCRATCH_BYTES = 128;

/**
 * Where the module comes from: one of the first three, or else the file umbilic-core.wasm or umbilic-core-threads.wasm of the
 * package or the build folder.
 * @typedef {object} LoadOptions
 * @property {string | URL} [wasmUrl] address of a copy of that file; in Node also its path
 * @property {ArrayBuffer | Uint8Array} [wasmBinary] its bytes
 * @property {WebAssembly.Module} [module] its bytes, compiled; can be sent to workers
 * @property {number | 'later'} [threads] how many compute; `later`: one until `useThreads` is called. Unless it is 1, what is given
 *   is umbilic-core-threads.wasm. By default 1 in Node and for a given module, else one per processor, but 8 at most. Without
 *   effect on a page that is not cross-origin isolated, and outside of workers, where nothing may wait
 */

/** @type {Loaded | null} */
let loaded = null;
/** @type {Promise<void> | null} */
let loading = null;
/** Counts calls of `useThreads`, of which the last one counts. */
let wishes = 0;
let scratch = 0;
/** Why the module can no longer be called; null if it can. @type {Error | null} */
let broken = null;

/** @param {LoadOptions} options */
async function instantiate(options) {
  const made = await loadCore(options);
  const version = made.core._umbilic_api_version();
  if (version !== API_VERSION) throw new Error(`the module has version ${version} of the contract, not ${API_VERSION}`);
  scratch = made.core._malloc(SCRATCH_BYTES) >>> 0;
  loaded = made;
  if (made.threads !== 1) await useThreads(made.threads);
}

/**
 * Loads the module once; later calls return the same promise, unless it has failed.
 * @param {LoadOptions} [options]
 * @returns {Promise<void>}
 */
export function load(options = {}) {
  loading ??= instantiate(options).catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

/** @returns {Loaded} */
function ready() {
  if (!loaded) throw new Error('umbilic is not loaded: await load() first');
  return loaded;
}

const core = () => ready().core;

/** The module's memory, which is another buffer after it has grown; Emscripten's own views do not see what other threads do. */
function memory() {
  const { HEAPU8, wasmMemory } = /** @type {ThreadedCore} */ (core());
  return wasmMemory ? wasmMemory.buffer : HEAPU8.buffer;
}

const bytesOf = (/** @type {number} */ pointer, /** @type {number} */ count) =>
  new Uint8Array(memory(), pointer, count);
const wordsOf = (/** @type {number} */ pointer, /** @type {number} */ count) =>
  new Uint32Array(memory(), pointer, count);
const floatsOf = (/** @type {number} */ pointer, /** @type {number} */ count) =>
  new Float32Array(memory(), pointer, count);
const doublesOf = (/** @type {number} */ pointer, /** @type {number} */ count) =>
  new Float64Array(memory(), pointer, count);

/**
 * Runs a function in the module. A trap may leave the module's memory inconsistent, so the module refuses all later
 * calls.
 * @template T
 * @param {(module: Core) => T} run
 * @returns {T}
 */
function inModule(run) {
  if (broken) throw broken;
  try {
    return run(core());
  } catch (error) {
    const trapped = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    if (!trapped) throw error;
    broken = new Error(`the core has broken off and takes no more calls: ${error.message}`, { cause: error });
    throw broken;
  }
}

/** @param {number} bytes @returns {number} */
function allocate(bytes) {
  const pointer = inModule((module) => module._malloc(bytes)) >>> 0;
  if (!pointer) throw new RangeError('out of memory');
  return pointer;
}

/** The message of the last failure. @returns {string} */
function lastMessage() {
  return inModule((module) => {
    const length = module._umbilic_copy_message(scratch, SCRATCH_BYTES) >>> 0;
    if (length < SCRATCH_BYTES) return module.UTF8ToString(scratch);
    const buffer = module._malloc(length + 1) >>> 0;
    if (!buffer) return module.UTF8ToString(scratch);
    module._umbilic_copy_message(buffer, length + 1);
    const message = module.UTF8ToString(buffer);
    module._free(buffer);
    return message;
  });
}

/**
 * Calls a function of api.h that returns a status.
 * @param {string} name without umbilic_
 * @param {...number} args
 * @throws {InputError | RangeError | Error}
 */
export function call(name, ...args) {
  const status = inModule((module) => module[`_umbilic_${name}`](...args));
  if (status === 0) return;
  const message = lastMessage();
  if (status === 1) throw new InputError(message);
  if (status === 3) throw new RangeError(message);
  throw new Error(`umbilic_${name}: ${message}`);
}

/**
 * Sets how many threads compute from now on: so many, or as many as there can be.
 * @param {number} count @returns {Promise<number>} how many they are
 */
export async function useThreads(count) {
  if (!Number.isInteger(count) || count < 1 || count > MOST_THREADS) {
    throw new InputError(`${count} threads: from 1 to ${MOST_THREADS} can compute, in whole numbers`);
  }
  const wish = ++wishes;
  const threads = await ready().prepareThreads(count);
  if (wish === wishes) call('use_threads', threads);
  return threads;
}

/** Calls a function that cannot fail. @param {string} name @param {...number} args @returns {number} */
export const plainCall = (name, ...args) => inModule((module) => module[`_umbilic_${name}`](...args));

/** Destroys the object of a handle, unless the module can no longer be called. @param {string} type @param {number} handle */
export function destroy(type, handle) {
  if (handle && !broken) plainCall(`${type}_destroy`, handle);
}

/** The first 32-bit words that the last call has written. @param {number} count */
const handedBack = (count) => Array.from(wordsOf(scratch, count));

/** The result of a call whose last argument receives a 32-bit word: a handle or a truth value. @param {string} name @param {...number} args */
export function wordFrom(name, ...args) {
  call(name, ...args, scratch);
  return handedBack(1)[0];
}

/** The result of a call whose last argument receives a double. @param {string} name @param {...number} args */
export function numberFrom(name, ...args) {
  call(name, ...args, scratch);
  return doublesOf(scratch, 1)[0];
}

/** The result of a call whose last argument receives a text. @param {string} name @param {...number} args @returns {string} */
export function textFrom(name, ...args) {
  call(name, ...args, scratch);
  const [pointer, length] = handedBack(2);
  return new TextDecoder().decode(bytesOf(pointer, length).slice()); // which takes no shared memory
}

/** The result of a call whose last argument receives JSON text. @param {string} name @param {...number} args @returns {any} */
export const valueFrom = (name, ...args) => parse(textFrom(name, ...args));

/** The string at the pointer that a call returns. @param {string} name @returns {string} */
export const stringFrom = (name) => core().UTF8ToString(plainCall(name));

/**
 * Runs `use` with a copy of the text in the module's memory.
 * @template T
 * @param {string} text
 * @param {(pointer: number, length: number) => T} use
 * @returns {T}
 */
export const withText = (text, use) => withBytes(new TextEncoder().encode(text), use);

/**
 * Runs `use` with a copy of the bytes in the module's memory.
 * @template T
 * @param {Uint8Array} bytes
 * @param {(pointer: number, length: number) => T} use
 * @returns {T}
 */
export function withBytes(bytes, use) {
  const pointer = allocate(bytes.length + 1);
  try {
    bytesOf(pointer, bytes.length).set(bytes);
    return use(pointer, bytes.length);
  } finally {
    if (!broken) core()._free(pointer);
  }
}

/**
 * Runs `use` with a copy of the points in the module's memory, or with a null pointer if there are none.
 * @template T
 * @param {Float64Array | null} points
 * @param {(pointer: number, count: number) => T} use
 * @returns {T}
 */
export function withPoints(points, use) {
  if (!points) return use(0, 0);
  const pointer = allocate(Math.max(8, points.byteLength));
  try {
    doublesOf(pointer, points.length).set(points);
    return use(pointer, points.length / 3);
  } finally {
    if (!broken) core()._free(pointer);
  }
}

/**
 * A surface as umbilic_run_state and umbilic_certificate_descent hand it out.
 * @param {string} name of the function @param {number} handle @returns {{level: number, points: Float64Array}}
 */
export function stateOf(name, handle) {
  call(name, handle, scratch, scratch + 4, scratch + 8);
  const [level, pointer, count] = handedBack(3);
  return { level, points: doublesOf(pointer, 3 * count).slice() };
}

/** Copies of a mesh's arrays. @param {number} mesh @returns {Mesh} */
export function copyMesh(mesh) {
  call('mesh_view', mesh, scratch);
  // The order of the members of umbilic_mesh_arrays.
  const [positions, normals, curvatures, triangles, faces, edges, vertexCount, triangleCount, edgeCount] =
    handedBack(9);
  /** @param {number} pointer @param {number} count */
  const floats = (pointer, count) => (pointer ? floatsOf(pointer, count).slice() : new Float32Array(0));
  /** @param {number} pointer @param {number} count */
  const indices = (pointer, count) => (pointer ? wordsOf(pointer, count).slice() : new Uint32Array(0));
  return {
    centre: doublesOf(scratch + 40, 3).slice(),
    positions: floats(positions, 3 * vertexCount),
    normals: floats(normals, 3 * vertexCount),
    curvatures: floats(curvatures, 2 * vertexCount),
    triangles: indices(triangles, 3 * triangleCount),
    faces: indices(faces, triangleCount),
    edges: indices(edges, 2 * edgeCount),
  };
}

/** Copies of a mesh's arrays and of its energy's density. @param {number} mesh @returns {Mesh & {densities: Float32Array}} */
export function copyMeshWithDensities(mesh) {
  const arrays = copyMesh(mesh);
  call('mesh_densities', mesh, scratch, scratch + 4);
  const [pointer, count] = handedBack(2);
  return { ...arrays, densities: floatsOf(pointer, count).slice() };
}

/**
 * Runs `use` with the mesh that a call returns, and destroys the mesh afterwards.
 * @template T
 * @param {(mesh: number) => T} use
 * @param {string} name
 * @param {...number} args
 * @returns {T}
 */
export function withMesh(use, name, ...args) {
  const mesh = wordFrom(name, ...args);
  try {
    return use(mesh);
  } finally {
    destroy('mesh', mesh);
  }
}

/** A mesh as OBJ text. @param {number} mesh @returns {string} */
export const meshObj = (mesh) => textFrom('mesh_obj', mesh);
