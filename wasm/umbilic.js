// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript face of the core, for the browser, a worker and Node alike. The only file that touches
 * WebAssembly memory; views of it die when it grows, so they are taken anew after every call.
 *
 *     import { Cage, Minimizer, load } from './wasm/umbilic.js';
 *     await load();
 *     const cage = Cage.generate('two-3');
 *     const minimizer = new Minimizer(cage, { weights: { bending: 1 }, levels: [0, 2] });
 *     while (!minimizer.step(10)) console.log(minimizer.progress.energy);
 *     console.log(minimizer.energies.bending);
 *     minimizer.dispose();
 */

import createCore from '../build/wasm/umbilic-core.mjs';

/** @import {Core} from '../build/wasm/umbilic-core.mjs' */
/**
 * @import {FunctionalName, CapName, Phase, StopReason, MinimizerOptions, Progress, LevelReport, Energies, CageCounts,
 * Mesh} from './types.js'
 */

/** What a user's cage or options did wrong; `message` names the place. */
export class InputError extends Error {
  name = 'InputError';
}

/** @type {FunctionalName[]} the order of api.h's weights and energies */
const FUNCTIONALS = ['bending', 'willmore', 'mvs', 'mvs_cross', 'mehlum_tarrou', 'second_form_variation'];
/** @type {CapName[]} */
const CAPS = ['none', 'flat', 'smooth'];
/** @type {Phase[]} */
const PHASES = ['prepare', 'minimize', 'report', 'done'];
const FAMILIES = ['hub', 'flag'];

/** Bytes for the numbers that a call hands back: the largest is nine doubles. */
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
function core() {
  if (!loaded) throw new Error('umbilic is not loaded: await load() first');
  return loaded;
}

/** @param {number} pointer to a zero-terminated UTF-8 string */
const stringAt = (pointer) => core().UTF8ToString(pointer);

/**
 * Runs `use` with a copy of the bytes in the module's memory, followed by a zero.
 * @template T
 * @param {string | Uint8Array} text
 * @param {(pointer: number, length: number) => T} use
 * @returns {T}
 */
function withText(text, use) {
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

/** @param {number} status @throws {InputError | RangeError} */
function check(status) {
  if (status === 0) return;
  if (status === 1) throw new InputError(lastMessage());
  throw new RangeError(lastMessage() || 'not enough memory');
}

/**
 * The handle that `create(out)` writes.
 * @param {(out: number) => number} create
 * @returns {number}
 */
function handleFrom(create) {
  check(create(scratch));
  return core().HEAPU32[scratch >>> 2];
}

/** @param {number} count @returns {number[]} */
const scratchIntegers = (count) => Array.from(core().HEAP32.subarray(scratch >>> 2, (scratch >>> 2) + count));

/** @param {number} count @returns {number[]} */
const scratchDoubles = (count) => Array.from(core().HEAPF64.subarray(scratch >>> 3, (scratch >>> 3) + count));

/**
 * Copies of a mesh's arrays.
 * @param {number} handle
 * @returns {Mesh}
 */
function copyMesh(handle) {
  core()._umbilic_mesh_counts(handle, scratch);
  const [vertices, , , edges, triangles] = scratchIntegers(5);
  /** @param {number} pointer @param {number} count */
  const floats = (pointer, count) =>
    pointer ? core().HEAPF32.slice(pointer >>> 2, (pointer >>> 2) + count) : new Float32Array(0);
  /** @param {number} pointer @param {number} count */
  const indices = (pointer, count) => core().HEAPU32.slice(pointer >>> 2, (pointer >>> 2) + count);
  return {
    positions: floats(core()._umbilic_mesh_positions(handle), 3 * vertices),
    normals: floats(core()._umbilic_mesh_normals(handle), 3 * vertices),
    curvatures: floats(core()._umbilic_mesh_curvatures(handle), 2 * vertices),
    triangles: indices(core()._umbilic_mesh_triangles(handle), 3 * triangles),
    edges: indices(core()._umbilic_mesh_edges(handle), 2 * edges),
  };
}

/** @param {number} handle @returns {string} */
function meshObj(handle) {
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
function withMesh(create, use) {
  const handle = handleFrom(create);
  try {
    return use(handle);
  } finally {
    core()._umbilic_mesh_destroy(handle);
  }
}

/** @param {number} handle @param {string} type @returns {number} */
function alive(handle, type) {
  if (!handle) throw new Error(`this ${type} has been disposed`);
  return handle;
}

/**
 * @param {number} value
 * @param {string} name
 * @returns {number}
 */
function integer(value, name) {
  if (!Number.isInteger(value)) throw new InputError(`${name} is ${value}, which is not a whole number`);
  return value;
}

/** @returns {string} */
export function version() {
  return stringAt(core()._umbilic_version());
}

/** @returns {string[]} names of the generated cages */
export function cageNames() {
  return stringAt(core()._umbilic_cage_names()).trim().split('\n');
}

/** @returns {FunctionalName[]} */
export function functionalNames() {
  return /** @type {FunctionalName[]} */ (stringAt(core()._umbilic_functional_names()).trim().split('\n'));
}

/** A control cage: closed, orientable, manifold. */
export class Cage {
  #handle;

  /** Use `Cage.read` or `Cage.generate`. @param {number} handle */
  constructor(handle) {
    this.#handle = handle;
  }

  /** @param {string | Uint8Array} text OBJ or OFF @returns {Cage} @throws {InputError} */
  static read(text) {
    return withText(
      text,
      (pointer, length) => new Cage(handleFrom((out) => core()._umbilic_cage_read(pointer, length, out))),
    );
  }

  /**
   * @param {string} name
   * @param {{family?: 'hub'|'flag', thickness?: number}} [options]
   * @returns {Cage} @throws {InputError}
   */
  static generate(name, { family = 'flag', thickness = 1 } = {}) {
    const index = FAMILIES.indexOf(family);
    if (index < 0) throw new InputError(`unknown family "${family}"; known are ${FAMILIES.join(', ')}`);
    return withText(
      name,
      (pointer) => new Cage(handleFrom((out) => core()._umbilic_cage_generate(pointer, index, thickness, out))),
    );
  }

  /** For `Minimizer`. @returns {number} */
  get handle() {
    return alive(this.#handle, 'cage');
  }

  /** @returns {CageCounts} */
  get counts() {
    core()._umbilic_cage_counts(this.handle, scratch);
    const [vertices, edges, faces, components, genus] = scratchIntegers(5);
    return { vertices, edges, faces, components, genus };
  }

  /** @returns {Mesh} */
  mesh() {
    return withMesh((out) => core()._umbilic_cage_mesh(this.handle, out), copyMesh);
  }

  /** @returns {string} OBJ text */
  obj() {
    return withMesh((out) => core()._umbilic_cage_mesh(this.handle, out), meshObj);
  }

  /** Frees the cage; a second call does nothing. */
  dispose() {
    if (this.#handle) core()._umbilic_cage_destroy(this.#handle);
    this.#handle = 0;
  }
}

/** One run on one cage; see core/driver/run.h. */
export class Minimizer {
  #handle;

  /** @param {Cage} cage @param {MinimizerOptions} options @throws {InputError} */
  constructor(cage, { weights, cap = 'smooth', levels = [0, 2], maxIterations = 1000, tolerance = 1e-6 }) {
    for (const name of Object.keys(weights)) {
      if (!FUNCTIONALS.includes(/** @type {FunctionalName} */ (name))) {
        throw new InputError(`unknown functional "${name}"; known are ${FUNCTIONALS.join(', ')}`);
      }
    }
    if (!CAPS.includes(cap)) throw new InputError(`unknown cap "${cap}"; known are ${CAPS.join(', ')}`);
    const first = integer(levels[0], 'the first level');
    const last = integer(levels[1], 'the last level');
    const limit = integer(maxIterations, 'the number of iterations');
    // The handle is written to the start of the scratch memory, so the weights stand behind it.
    const slots = core().HEAPF64.subarray((scratch >>> 3) + 1, (scratch >>> 3) + 1 + FUNCTIONALS.length);
    slots.set(FUNCTIONALS.map((name) => weights[name] ?? 0));
    this.#handle = handleFrom((out) =>
      core()._umbilic_minimizer_create(cage.handle, scratch + 8, CAPS.indexOf(cap), first, last, limit, tolerance, out),
    );
  }

  /** @returns {number} */
  get #alive() {
    return alive(this.#handle, 'minimizer');
  }

  /** Up to `units` energy evaluations. @param {number} units @returns {boolean} whether the run is done */
  step(units) {
    return core()._umbilic_minimizer_step(this.#alive, units) !== 0;
  }

  /** Ends the run; what there is so far is its result. */
  cancel() {
    core()._umbilic_minimizer_cancel(this.#alive);
  }

  /** @returns {Progress} */
  get progress() {
    core()._umbilic_minimizer_progress(this.#alive, scratch);
    const [phase, level, iterations, evaluations, totalEvaluations, energy, gradientNorm, predictedDecrease] =
      scratchDoubles(8);
    return {
      phase: PHASES[phase],
      level,
      iterations,
      evaluations,
      totalEvaluations,
      energy,
      gradientNorm,
      predictedDecrease,
    };
  }

  /** How many levels have ended. @returns {number} */
  get levelCount() {
    return core()._umbilic_minimizer_level_count(this.#alive);
  }

  /** @returns {LevelReport[]} */
  get levels() {
    return Array.from({ length: this.levelCount }, (_, index) => {
      const stop = /** @type {StopReason} */ (stringAt(core()._umbilic_minimizer_level(this.#alive, index, scratch)));
      const [level, patches, unknowns, energy, energyReported, iterations, evaluations, seconds] = scratchDoubles(8);
      return { level, patches, unknowns, energy, energyReported, iterations, evaluations, seconds, stop };
    });
  }

  /** By the reporting rule; several times the cost of a step. @returns {Energies} */
  get energies() {
    core()._umbilic_minimizer_energies(this.#alive, scratch);
    const [bending, willmore, mvs, mvs_cross, mehlum_tarrou, second_form_variation, area, gaussian, quadratureError] =
      scratchDoubles(9);
    return {
      bending,
      willmore,
      mvs,
      mvs_cross,
      mehlum_tarrou,
      second_form_variation,
      area,
      gaussian,
      quadratureError,
    };
  }

  /** @returns {Mesh} */
  controlMesh() {
    return withMesh((out) => core()._umbilic_minimizer_control_mesh(this.#alive, out), copyMesh);
  }

  /** @param {number} density quads along each edge of a patch @returns {Mesh} */
  limitMesh(density) {
    return withMesh((out) => core()._umbilic_minimizer_limit_mesh(this.#alive, density, out), copyMesh);
  }

  /** @returns {string} OBJ text of the control mesh */
  controlObj() {
    return withMesh((out) => core()._umbilic_minimizer_control_mesh(this.#alive, out), meshObj);
  }

  /** @param {number} density @returns {string} OBJ text of the limit mesh */
  limitObj(density) {
    return withMesh((out) => core()._umbilic_minimizer_limit_mesh(this.#alive, density, out), meshObj);
  }

  /** Frees the run; a second call does nothing. */
  dispose() {
    if (this.#handle) core()._umbilic_minimizer_destroy(this.#handle);
    this.#handle = 0;
  }
}
