// SPDX-License-Identifier: MIT
/**
 * @file Loads the core, calls it, and copies values in and out of it. This is the only file that touches WebAssembly
 * memory. Views of that memory become invalid when it grows, so they are taken again after every call. Every failure
 * reaches the caller as an `Error` with a message.
 */

import createCore from '../build/wasm/umbilic-core.mjs';
import { InputError, parse } from './values.js';

/** @import {Core} from '../build/wasm/umbilic-core.mjs' */
/** @import {Mesh} from './types.js' */

/** UMBILIC_API_VERSION of the contract for which this file was written. */
const API_VERSION = 3;

/** Size of the buffer for a call's results; the largest is umbilic_mesh_arrays, nine words of 32 bits and three doubles. */
const SCRATCH_BYTES = 128;

const ownWasmUrl = new URL('../build/wasm/umbilic-core.wasm', import.meta.url);

/**
 * Where the module comes from: one of these, or else the file umbilic-core.wasm of the package or the build folder.
 * @typedef {object} LoadOptions
 * @property {string | URL} [wasmUrl] address of a copy of that file; in Node also its path
 * @property {ArrayBuffer | Uint8Array} [wasmBinary] its bytes
 * @property {WebAssembly.Module} [module] its bytes, compiled; can be sent to workers
 */

/** @type {Core | null} */
let loaded = null;
/** @type {Promise<void> | null} */
let loading = null;
let scratch = 0;
/** Why the module can no longer be called; null if it can. @type {Error | null} */
let broken = null;

/**
 * Reads the binary in Node, where Emscripten's loader cannot fetch it.
 * @param {string | URL} wasmUrl
 * @returns {Promise<ArrayBuffer | Uint8Array | undefined>} undefined in a browser
 */
async function readBinaryInNode(wasmUrl) {
  if (!globalThis.process?.versions?.node) return undefined;
  const { readFileSync } = process.getBuiltinModule('node:fs');
  const url = URL.canParse(wasmUrl) ? new URL(wasmUrl) : null;
  if (!url) return readFileSync(wasmUrl);
  if (url.protocol === 'file:') return readFileSync(process.getBuiltinModule('node:url').fileURLToPath(url.href));
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} answers ${response.status}`);
  return response.arrayBuffer();
}

/** @param {WebAssembly.Module} module @returns {Promise<Core>} */
function createFromModule(module) {
  return new Promise((resolve, reject) => {
    createCore({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports).then(receive).catch(reject);
        return {};
      },
    }).then(resolve, reject);
  });
}

/** @param {LoadOptions} options @returns {Promise<Core>} */
async function create({ wasmUrl, wasmBinary, module }) {
  const given = Object.entries({ wasmUrl, wasmBinary, module }).filter(([, value]) => value !== undefined);
  if (given.length > 1) throw new TypeError(`load: ${given.map(([name]) => name).join(' and ')} are given, not one`);
  if (module) return createFromModule(module);
  const url = wasmUrl ?? ownWasmUrl;
  const bytes = wasmBinary ?? (await readBinaryInNode(url));
  return createCore(bytes ? { wasmBinary: bytes } : { locateFile: () => String(url) });
}

/** @param {LoadOptions} options */
async function instantiate(options) {
  const made = await create(options);
  const version = made._umbilic_api_version();
  if (version !== API_VERSION) throw new Error(`the module has version ${version} of the contract, not ${API_VERSION}`);
  scratch = made._malloc(SCRATCH_BYTES) >>> 0;
  loaded = made;
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

/** @returns {Core} */
function core() {
  if (!loaded) throw new Error('umbilic is not loaded: await load() first');
  return loaded;
}

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

/** Calls a function that cannot fail. @param {string} name @param {...number} args @returns {number} */
export const plainCall = (name, ...args) => inModule((module) => module[`_umbilic_${name}`](...args));

/** Destroys the object of a handle, unless the module can no longer be called. @param {string} type @param {number} handle */
export function destroy(type, handle) {
  if (handle && !broken) plainCall(`${type}_destroy`, handle);
}

/** The first 32-bit words that the last call has written. @param {number} count */
const handedBack = (count) => Array.from(core().HEAPU32.subarray(scratch >>> 2, (scratch >>> 2) + count));

/** The result of a call whose last argument receives a 32-bit word: a handle or a truth value. @param {string} name @param {...number} args */
export function wordFrom(name, ...args) {
  call(name, ...args, scratch);
  return handedBack(1)[0];
}

/** The result of a call whose last argument receives a double. @param {string} name @param {...number} args */
export function numberFrom(name, ...args) {
  call(name, ...args, scratch);
  return core().HEAPF64[scratch >>> 3];
}

/** The result of a call whose last argument receives a text. @param {string} name @param {...number} args @returns {string} */
export function textFrom(name, ...args) {
  call(name, ...args, scratch);
  const [pointer, length] = handedBack(2);
  return new TextDecoder().decode(core().HEAPU8.subarray(pointer, pointer + length));
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
    core().HEAPU8.set(bytes, pointer);
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
    core().HEAPF64.set(points, pointer >>> 3);
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
  return { level, points: core().HEAPF64.slice(pointer >>> 3, (pointer >>> 3) + 3 * count) };
}

/** Copies of a mesh's arrays. @param {number} mesh @returns {Mesh} */
export function copyMesh(mesh) {
  call('mesh_view', mesh, scratch);
  // The order of the members of umbilic_mesh_arrays.
  const [positions, normals, curvatures, triangles, faces, edges, vertexCount, triangleCount, edgeCount] =
    handedBack(9);
  /** @param {number} pointer @param {number} count */
  const floats = (pointer, count) =>
    pointer ? core().HEAPF32.slice(pointer >>> 2, (pointer >>> 2) + count) : new Float32Array(0);
  /** @param {number} pointer @param {number} count */
  const indices = (pointer, count) =>
    pointer ? core().HEAPU32.slice(pointer >>> 2, (pointer >>> 2) + count) : new Uint32Array(0);
  return {
    centre: core().HEAPF64.slice((scratch + 40) >>> 3, (scratch + 64) >>> 3),
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
  return { ...arrays, densities: core().HEAPF32.slice(pointer >>> 2, (pointer >>> 2) + count) };
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
