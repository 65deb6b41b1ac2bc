// SPDX-License-Identifier: MIT
/**
 * @file Loads the core and moves values in and out of it. The only file that touches WebAssembly memory; views of it die
 * when it grows, so they are taken anew after every call.
 */

import createCore from '../build/wasm/umbilic-core.mjs';

/** @import {Core} from '../build/wasm/umbilic-core.mjs' */
/** @import {Mesh} from './types.js' */

/** What a user's cage or options did wrong; `message` names the place. */
export class InputError extends Error {
  name = 'InputError';
}

/** Bytes for the numbers that a call hands back: the largest is ten doubles. */
const SCRATCH_BYTES = 128;

const wasmUrl = new URL('../build/wasm/umbilic-core.wasm', import.meta.url);

/** @type {Core | null} */
let loaded = null;
/** @type {Promise<void> | null} */
let loading = null;
let scratch = 0;

/**
 * In Node the glue cannot fetch, so the binary is read here.
 * @returns {Uint8Array | undefined} undefined in a browser
 */
function readBinaryInNode() {
  if (!globalThis.process?.versions?.node) return undefined;
  const { readFileSync } = process.getBuiltinModule('node:fs');
  const { fileURLToPath } = process.getBuiltinModule('node:url');
  return readFileSync(fileURLToPath(wasmUrl.href));
}

/** @param {{wasmBinary?: ArrayBuffer | Uint8Array}} options */
async function instantiate(options) {
  const wasmBinary = options.wasmBinary ?? readBinaryInNode();
  loaded = await createCore(wasmBinary ? { wasmBinary } : { locateFile: () => wasmUrl.href });
  scratch = loaded._malloc(SCRATCH_BYTES) >>> 0;
}

/**
 * Loads the module once; later calls return the same promise. In Node the binary is read from the build folder unless
 * given.
 * @param {{wasmBinary?: ArrayBuffer | Uint8Array}} [options]
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
export function core() {
  if (!loaded) throw new Error('umbilic is not loaded: await load() first');
  return loaded;
}

/** @param {number} pointer to a zero-terminated UTF-8 string */
export const stringAt = (pointer) => core().UTF8ToString(pointer);

/**
 * Runs `use` with a copy of the bytes in the module's memory, followed by a zero.
 * @template T
 * @param {string | Uint8Array} text
 * @param {(pointer: number, length: number) => T} use
 * @returns {T}
 */
export function withText(text, use) {
  const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text;
  const pointer = core()._malloc(bytes.length + 1) >>> 0;
  if (!pointer) throw new RangeError('not enough memory');
  try {
    core().HEAPU8.set(bytes, pointer);
    core().HEAPU8[pointer + bytes.length] = 0;
    return use(pointer, bytes.length);
  } finally {
    core()._free(pointer);
  }
}

/**
 * Runs `use` with a copy of the numbers in the module's memory.
 * @template T
 * @param {ArrayLike<number>} values
 * @param {(pointer: number) => T} use
 * @returns {T}
 */
export function withDoubles(values, use) {
  const pointer = core()._malloc(8 * values.length) >>> 0;
  if (!pointer) throw new RangeError('not enough memory');
  try {
    core().HEAPF64.set(values, pointer >>> 3);
    return use(pointer);
  } finally {
    core()._free(pointer);
  }
}

/** @returns {string} the words of the last failure */
function lastMessage() {
  const length = core()._umbilic_copy_message(scratch, SCRATCH_BYTES);
  if (length < SCRATCH_BYTES) return stringAt(scratch);
  const buffer = core()._malloc(length + 1) >>> 0;
  core()._umbilic_copy_message(buffer, length + 1);
  const message = stringAt(buffer);
  core()._free(buffer);
  return message;
}

/** Of a call that can fail. @param {number} status @throws {InputError | RangeError} */
export function check(status) {
  if (status === 0) return;
  if (status === 1) throw new InputError(lastMessage());
  throw new RangeError(lastMessage() || 'not enough memory');
}

/**
 * The handle that `create(out)` writes.
 * @param {(out: number) => number} create
 * @returns {number}
 */
export function handleFrom(create) {
  check(create(scratch));
  return core().HEAPU32[scratch >>> 2];
}

/**
 * The whole numbers that `write(out)` writes.
 * @param {number} count
 * @param {(out: number) => void} write
 * @returns {number[]}
 */
export function integersFrom(count, write) {
  write(scratch);
  return Array.from(core().HEAP32.subarray(scratch >>> 2, (scratch >>> 2) + count));
}

/**
 * The numbers that `write(out)` writes.
 * @param {number} count
 * @param {(out: number) => void} write
 * @returns {number[]}
 */
export function doublesFrom(count, write) {
  write(scratch);
  return Array.from(core().HEAPF64.subarray(scratch >>> 3, (scratch >>> 3) + count));
}

/** A copy. @param {number} pointer @param {number} count @returns {Float64Array} */
export const doublesAt = (pointer, count) => core().HEAPF64.slice(pointer >>> 3, (pointer >>> 3) + count);

/**
 * Copies of a mesh's arrays.
 * @param {number} handle
 * @returns {Mesh}
 */
export function copyMesh(handle) {
  const [vertices, , , edges, triangles] = integersFrom(5, (out) => core()._umbilic_mesh_counts(handle, out));
  /** @param {number} pointer @param {number} count */
  const floats = (pointer, count) =>
    pointer ? core().HEAPF32.slice(pointer >>> 2, (pointer >>> 2) + count) : new Float32Array(0);
  /** @param {number} pointer @param {number} count */
  const indices = (pointer, count) =>
    pointer ? core().HEAPU32.slice(pointer >>> 2, (pointer >>> 2) + count) : new Uint32Array(0);
  return {
    centre: Float64Array.from(doublesFrom(3, (out) => core()._umbilic_mesh_centre(handle, out))),
    positions: floats(core()._umbilic_mesh_positions(handle), 3 * vertices),
    normals: floats(core()._umbilic_mesh_normals(handle), 3 * vertices),
    curvatures: floats(core()._umbilic_mesh_curvatures(handle), 2 * vertices),
    triangles: indices(core()._umbilic_mesh_triangles(handle), 3 * triangles),
    edges: indices(core()._umbilic_mesh_edges(handle), 2 * edges),
  };
}

/** A mesh as OBJ text. @param {number} handle @returns {string} */
export function meshObj(handle) {
  const pointer = core()._umbilic_mesh_obj(handle, scratch) >>> 0;
  const length = core().HEAPU32[scratch >>> 2];
  return new TextDecoder().decode(core().HEAPU8.subarray(pointer, pointer + length));
}

/**
 * Runs `use` with a mesh handle that lives no longer.
 * @template T
 * @param {(out: number) => number} create
 * @param {(handle: number) => T} use
 * @returns {T}
 */
export function withMesh(create, use) {
  const handle = handleFrom(create);
  try {
    return use(handle);
  } finally {
    core()._umbilic_mesh_destroy(handle);
  }
}
