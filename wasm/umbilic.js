// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript API of the core, for the browser, workers and Node. Problems and reports are objects with the
 * names of their text form; see types.js.
 *
 *     import { Minimizer, load } from 'umbilic'; // in this project './wasm/umbilic.js'
 *     await load();
 *     const minimizer = new Minimizer({
 *       cage: { generator: 'two-3' },
 *       terms: { bending: 1 },
 *       options: { levels: [0, 2] },
 *     });
 *     while (!minimizer.step(10)) console.log(minimizer.progress.energy);
 *     console.log(minimizer.energies.bending);
 *     minimizer.dispose();
 */

import {
  call,
  copyMesh,
  copyMeshWithDensities,
  destroy,
  meshObj,
  numberFrom,
  stateOf,
  stringFrom,
  textFrom,
  valueFrom,
  withBytes,
  withMesh,
  withPoints,
  withText,
  wordFrom,
} from './memory.js';
import { InputError, mayBeBinary, parse } from './values.js';

/**
 * @import {CageInput, CageReport, CertificateReport, Energies, Estimate, FaceGroup, FunctionalName, GeneratedCage, Group, LevelReport, Limit,
 * Mesh, Problem, Progress, Report, Targets, Terms, TorusMinimizer} from './types.js'
 */

export { load, useThreads } from './memory.js';
export * from './types.js';
export { InputError } from './values.js';

/** @typedef {import('./memory.js').LoadOptions} LoadOptions */

/** The values of umbilic_part in api.h. */
const PARTS = {
  progress: 0,
  problem: 1,
  cage: 2,
  group: 3,
  levels: 4,
  limit: 5,
  energies: 6,
  groups: 7,
  held: 8,
  estimate: 9,
};

/** @param {number} handle @param {string} type @returns {number} */
function alive(handle, type) {
  if (!handle) throw new Error(`this ${type} has been disposed`);
  return handle;
}

/**
 * Checks an argument that the contract takes as a 32-bit integer.
 * @param {number} value
 * @param {string} name
 * @param {number} least
 * @returns {number}
 */
function count(value, name, least) {
  if (Number.isInteger(value) && value >= least && value < 2 ** 31) return value;
  throw new InputError(`${name} is ${value}, not a whole number of at least ${least}`);
}

/** @param {CageInput} cage @returns {object} the cage with a file's bytes as text @throws {InputError} for binary files */
function plainCage(cage) {
  const { text, name } = /** @type {{text?: unknown, name?: string}} */ (cage ?? {});
  return text instanceof Uint8Array ? { ...cage, text: textOf(text, name) } : cage;
}

/** @param {Uint8Array} file @param {string} [name] @returns {string} */
function textOf(file, name) {
  if (!mayBeBinary(file)) return new TextDecoder().decode(file);
  try {
    return withBytes(file, (pointer, length) => textFrom('cage_text', pointer, length));
  } catch (error) {
    if (name && error instanceof InputError) error.message = `${name}: ${error.message}`;
    throw error;
  }
}

/**
 * The text of a problem or a report. The points to start from, which can be many, are passed separately as numbers.
 * @param {Problem | Report | string} asked
 * @returns {{text: string, points: Float64Array | null}}
 */
function packed(asked) {
  if (typeof asked === 'string') return { text: asked, points: null };
  if (!asked || typeof asked !== 'object') throw new InputError(`${asked} is no problem`);
  if ('umbilic' in asked && asked.umbilic === 'report') return { text: JSON.stringify(asked), points: null };
  const problem = /** @type {Problem} */ (asked);
  const head = { umbilic: 'problem', version: 1, ...problem, cage: plainCage(problem.cage) };
  const points = problem.start?.points;
  if (!(points instanceof Float64Array)) return { text: JSON.stringify(head), points: null };
  if (points.length % 3 !== 0) throw new InputError(`start.points: ${points.length} numbers, not three for each point`);
  return { text: JSON.stringify({ ...head, start: { ...problem.start, points: [] } }), points };
}

/** @returns {string} */
export const version = () => stringFrom('version');

/** @returns {string[]} names of the generated cages */
export const cageNames = () => valueFrom('cage_names');

/** @returns {FunctionalName[]} */
export const functionalNames = () => valueFrom('functional_names');

/**
 * Energies of a torus of revolution, in closed form.
 * @param {number} ratio radius of the tube divided by that of the circle of its centres, between 0 and 1
 * @returns {Record<FunctionalName, number>} @throws {InputError}
 */
export const torusEnergies = (ratio) => valueFrom('torus_energies', ratio);

/**
 * The torus of revolution of least energy.
 * @param {Terms} terms
 * @returns {TorusMinimizer} @throws {InputError}
 */
export const torusMinimizer = (terms) =>
  withText(JSON.stringify(terms), (pointer, length) => valueFrom('torus_minimizer', pointer, length));

/** A control cage: orientable, manifold, closed or with boundaries. */
export class Cage {
  #handle;

  /** The input of the constructor, as a problem's `cage`. @type {CageInput} */
  input;

  /** @param {CageInput} input @throws {InputError} */
  constructor(input) {
    this.input = input;
    this.#handle = withText(JSON.stringify(plainCage(input)), (pointer, length) =>
      wordFrom('cage_create', pointer, length),
    );
  }

  /** @param {string | Uint8Array} text OBJ, OFF or PLY @param {string} [name] @throws {InputError} */
  static read(text, name = '') {
    return new Cage({ name, text });
  }

  /** @param {string} generator @param {Omit<GeneratedCage, 'generator'>} [parameters] @throws {InputError} */
  static generate(generator, parameters = {}) {
    return new Cage({ generator, ...parameters });
  }

  /** @returns {number} */
  get #alive() {
    return alive(this.#handle, 'cage');
  }

  /** @returns {CageReport} */
  get counts() {
    return valueFrom('cage_counts', this.#alive);
  }

  /** @returns {Mesh} */
  mesh() {
    return withMesh(copyMesh, 'cage_mesh', this.#alive);
  }

  /** @returns {string} OBJ text */
  obj() {
    return withMesh(meshObj, 'cage_mesh', this.#alive);
  }

  /** Frees the cage; a second call does nothing. */
  dispose() {
    destroy('cage', this.#handle);
    this.#handle = 0;
  }
}

/** One run of one problem; see core/driver/run.h. */
export class Minimizer {
  #handle;

  /**
   * @param {Problem | Report | string} problem or its text; a report's run continues where the report ended
   * @throws {InputError}
   */
  constructor(problem) {
    const { text, points } = packed(problem);
    this.#handle = withText(text, (pointer, length) =>
      withPoints(points, (numbers, count) => wordFrom('run_create', pointer, length, numbers, count)),
    );
  }

  /** @returns {number} */
  get #alive() {
    return alive(this.#handle, 'minimizer');
  }

  /** @param {keyof typeof PARTS} name @returns {any} */
  #part(name) {
    return valueFrom('run_part', this.#alive, PARTS[name]);
  }

  /** Up to `units` energy evaluations. @param {number} units @returns {boolean} whether the run is done */
  step(units) {
    return wordFrom('run_step', this.#alive, count(units, 'the number of units', 0)) !== 0;
  }

  /**
   * Changes weights, pins' targets, the pull to the cage's own surface or the cage's points of a run, ended or not. It goes
   * on from its best surface; levels and limit are those since then.
   * @param {Targets} targets
   * @throws {InputError} if they do not fit the problem; then the run stays as it is
   */
  retarget(targets) {
    const plain = targets.points ? { ...targets, points: Array.from(targets.points) } : targets;
    withText(JSON.stringify(plain), (pointer, length) => call('run_retarget', this.#alive, pointer, length));
  }

  /** Ends the run. Its result is what has been computed so far. */
  cancel() {
    call('run_cancel', this.#alive);
  }

  /** @returns {Progress} */
  get progress() {
    return this.#part('progress');
  }

  /** What the run will probably take, as known when it began; what is left of it, `progress` tells. @returns {Estimate} */
  get estimate() {
    return this.#part('estimate');
  }

  /** The problem, with all defaults filled in. @returns {Required<Omit<Problem, 'start'>> & Problem} */
  get problem() {
    return this.#part('problem');
  }

  /** Counts of the cage's elements. @returns {CageReport} */
  get cage() {
    return this.#part('cage');
  }

  /** The groups of the cage's file, with the numbers of their faces from 1. @returns {FaceGroup[]} */
  get groups() {
    return this.#part('groups');
  }

  /** The numbers of the cage's faces that are held, from 1, with those that `symmetric` copies. @returns {number[]} */
  get held() {
    return this.#part('held');
  }

  /** The symmetry that the run keeps. @returns {Group} */
  get group() {
    return this.#part('group');
  }

  /** The levels that have ended. @returns {LevelReport[]} */
  get levels() {
    return this.#part('levels');
  }

  /** The estimated limit of the energies, from the levels so far. @returns {Limit} */
  get limit() {
    return this.#part('limit');
  }

  /** All energies by the reporting rule; costs as much as several steps. @returns {Energies} */
  get energies() {
    return this.#part('energies');
  }

  /** The best surface so far, for a problem's `start`. @returns {{level: number, points: Float64Array}} */
  get state() {
    return stateOf('run_state', this.#alive);
  }

  /**
   * The complete report as a text.
   * @param {Certificate} [certificate] a ready certificate of this surface
   * @returns {string}
   */
  report(certificate) {
    return textFrom('run_report', this.#alive, certificate?.handle ?? 0);
  }

  /**
   * Begins a test whether the best surface is a minimum among all surfaces near it.
   * @returns {Certificate} @throws {InputError} for flat caps and very large meshes
   */
  certify() {
    return new Certificate(wordFrom('run_certify', this.#alive));
  }

  /** @returns {Mesh} */
  controlMesh() {
    return withMesh(copyMesh, 'run_control_mesh', this.#alive);
  }

  /** @param {number} density quads along each edge of a patch @returns {Mesh} */
  limitMesh(density) {
    return withMesh(copyMesh, 'run_limit_mesh', this.#alive, count(density, 'the density', 1));
  }

  /**
   * The limit mesh with the density of an energy: per vertex the energy per area, in 1/length². It integrates to the energy.
   * @param {number} density quads along each edge of a patch
   * @param {Terms} terms of the energy, which need not be what is minimized
   * @returns {Mesh & {densities: Float32Array}} @throws {InputError}
   */
  limitMeshWithDensities(density, terms) {
    const quads = count(density, 'the density', 1);
    return withText(JSON.stringify(terms), (pointer, length) =>
      withMesh(copyMeshWithDensities, 'run_limit_mesh_with_densities', this.#alive, quads, pointer, length),
    );
  }

  /** @returns {string} OBJ text of the control mesh */
  controlObj() {
    return withMesh(meshObj, 'run_control_mesh', this.#alive);
  }

  /** @param {number} density @returns {string} OBJ text of the limit mesh */
  limitObj(density) {
    return withMesh(meshObj, 'run_limit_mesh', this.#alive, count(density, 'the density', 1));
  }

  /** Frees the run; a second call does nothing. */
  dispose() {
    destroy('run', this.#handle);
    this.#handle = 0;
  }
}

/** Counts the directions along which a surface's energy decreases; see core/driver/certificate.h. */
export class Certificate {
  #handle;

  /** To be called by `Minimizer.certify` only. @param {number} handle */
  constructor(handle) {
    this.#handle = handle;
  }

  /** To be used by `Minimizer.report` only. @returns {number} */
  get handle() {
    return alive(this.#handle, 'certificate');
  }

  /** Does up to `units` units of work, each about one energy evaluation. @param {number} units @returns {boolean} whether the report is ready */
  step(units) {
    return wordFrom('certificate_step', this.handle, count(units, 'the number of units', 0)) !== 0;
  }

  /** @returns {number} from 0 to 1 */
  get progress() {
    return numberFrom('certificate_progress', this.handle);
  }

  /** The result; available once `step` has returned true. @returns {CertificateReport} */
  get report() {
    return valueFrom('certificate_report', this.handle);
  }

  /**
   * A surface of lower energy nearby, for a problem's `start`; costs some tens of evaluations.
   * @returns {{level: number, points: Float64Array}}
   * @throws {InputError} where no direction leads down
   */
  descent() {
    return stateOf('certificate_descent', this.handle);
  }

  /** Frees the certificate; a second call does nothing. */
  dispose() {
    destroy('certificate', this.#handle);
    this.#handle = 0;
  }
}

/** Parses the text of a report; null becomes NaN. @param {string} text @returns {Report} */
export const parseReport = (text) => parse(text);
