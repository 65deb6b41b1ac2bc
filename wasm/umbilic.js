// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript face of the core, for the browser, a worker and Node alike.
 *
 *     import { Cage, Minimizer, load } from './wasm/umbilic.js';
 *     await load();
 *     const cage = Cage.generate('two-3');
 *     const minimizer = new Minimizer(cage, { weights: { bending: 1 }, levels: [0, 2] });
 *     while (!minimizer.step(10)) console.log(minimizer.progress.energy);
 *     console.log(minimizer.energies.bending);
 *     minimizer.dispose();
 */

import {
  InputError,
  check,
  copyMesh,
  core,
  doublesAt,
  doublesFrom,
  handleFrom,
  integersFrom,
  meshObj,
  stringAt,
  withDoubles,
  withMesh,
  withText,
} from './memory.js';

/**
 * @import {FunctionalName, CapName, MetricName, Phase, StopReason, LimitStatus, MinimizerOptions, Progress, LevelReport,
 * Energies, Group, Limit, CertificateReport, CageCounts, TorusMinimizer, Mesh} from './types.js'
 */

export { InputError, load } from './memory.js';

/** @type {FunctionalName[]} the order of api.h's weights and energies */
const FUNCTIONALS = ['bending', 'willmore', 'mvs', 'mvs_cross', 'mehlum_tarrou', 'second_form_variation'];
/** @type {CapName[]} */
const CAPS = ['none', 'flat', 'smooth'];
/** @type {MetricName[]} */
const METRICS = ['auto', 'identity', 'sobolev', 'hessian'];
/** @type {Phase[]} */
const PHASES = ['prepare', 'minimize', 'report', 'done'];
const FAMILIES = ['hub', 'flag'];

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

/**
 * The place of a name among those that are known.
 * @param {string} name
 * @param {readonly string[]} known
 * @param {string} what
 * @returns {number}
 */
function indexIn(known, name, what) {
  const index = known.indexOf(name);
  if (index < 0) throw new InputError(`unknown ${what} "${name}"; known are ${known.join(', ')}`);
  return index;
}

/** @param {Partial<Record<FunctionalName, number>>} weights @returns {number[]} in the core's order */
function orderedWeights(weights) {
  for (const name of Object.keys(weights)) indexIn(FUNCTIONALS, name, 'functional');
  return FUNCTIONALS.map((name) => weights[name] ?? 0);
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

/**
 * Of the torus of revolution, in closed form.
 * @param {number} ratio of the tube's radius to that of the circle of its centres, between 0 and 1
 * @returns {Record<FunctionalName, number>} @throws {InputError}
 */
export function torusEnergies(ratio) {
  const values = doublesFrom(6, (out) => check(core()._umbilic_torus_energies(ratio, out)));
  const [bending, willmore, mvs, mvs_cross, mehlum_tarrou, second_form_variation] = values;
  return { bending, willmore, mvs, mvs_cross, mehlum_tarrou, second_form_variation };
}

/**
 * The torus of revolution of least energy.
 * @param {Partial<Record<FunctionalName, number>>} weights
 * @returns {TorusMinimizer} @throws {InputError}
 */
export function torusMinimizer(weights) {
  const [ratio, energy, attained] = withDoubles(orderedWeights(weights), (pointer) =>
    doublesFrom(3, (out) => check(core()._umbilic_torus_minimizer(pointer, out))),
  );
  return { ratio, energy, attained: attained !== 0 };
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
    const index = indexIn(FAMILIES, family, 'family');
    return withText(
      name,
      (pointer) => new Cage(handleFrom((out) => core()._umbilic_cage_generate(pointer, index, thickness, out))),
    );
  }

  /**
   * The control mesh `level` Catmull-Clark steps from this cage, with its symmetry, that `orbitPoints` of a surface on
   * that level describe.
   * @param {number} level
   * @param {ArrayLike<number>} points x, y, z of the first vertex of each orbit
   * @returns {Cage} @throws {InputError} where the mesh has another number of orbits
   */
  refined(level, points) {
    const steps = integer(level, 'the level');
    const count = integer(points.length / 3, 'the number of points');
    return withDoubles(
      points,
      (pointer) => new Cage(handleFrom((out) => core()._umbilic_cage_refined(this.handle, steps, pointer, count, out))),
    );
  }

  /** For `Minimizer`. @returns {number} */
  get handle() {
    return alive(this.#handle, 'cage');
  }

  /** @returns {CageCounts} */
  get counts() {
    const [vertices, edges, faces, components, genus] = integersFrom(5, (out) =>
      core()._umbilic_cage_counts(this.handle, out),
    );
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
  constructor(cage, options) {
    const { weights, cap = 'smooth', symmetry = true, metric = 'auto', levels = [0, 2] } = options;
    const { maxIterations = 1000, tolerance = 1e-6 } = options;
    const choices = [indexIn(CAPS, cap, 'cap'), Number(symmetry), indexIn(METRICS, metric, 'metric')];
    const first = integer(levels[0], 'the first level');
    const last = integer(levels[1], 'the last level');
    const limit = integer(maxIterations, 'the number of iterations');
    this.#handle = withDoubles(orderedWeights(weights), (pointer) =>
      handleFrom((out) =>
        core()._umbilic_minimizer_create(cage.handle, pointer, ...choices, first, last, limit, tolerance, out),
      ),
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
    const [phase, level, iterations, evaluations, totalEvaluations, energy, gradientNorm, predictedDecrease] =
      doublesFrom(8, (out) => core()._umbilic_minimizer_progress(this.#alive, out));
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

  /** @param {number} index @returns {LevelReport} */
  #level(index) {
    let stop = 0;
    const numbers = doublesFrom(11, (out) => (stop = core()._umbilic_minimizer_level(this.#alive, index, out)));
    const [level, patches, unknowns, energy, energyReported, ...rest] = numbers;
    const [iterations, evaluations, seconds, metrics, evaluable, quadrature] = rest;
    const metric = stringAt(core()._umbilic_minimizer_level_metric(this.#alive, index));
    return {
      ...{ level, patches, unknowns, energy, energyReported, iterations, evaluations, seconds, metrics, quadrature },
      stop: /** @type {StopReason} */ (stringAt(stop)),
      metric: /** @type {LevelReport['metric']} */ (metric),
      evaluable: evaluable !== 0,
    };
  }

  /** Those that have ended. @returns {LevelReport[]} */
  get levels() {
    return Array.from({ length: this.levelCount }, (_, index) => this.#level(index));
  }

  /** The symmetry that the run keeps. @returns {Group} */
  get group() {
    let name = 0;
    const [order] = integersFrom(1, (out) => (name = core()._umbilic_minimizer_group(this.#alive, out)));
    return { name: stringAt(name), order };
  }

  /** What the levels so far say about the limit of their energies. @returns {Limit} */
  get limit() {
    let status = 0;
    const [energy, order, error] = doublesFrom(
      3,
      (out) => (status = core()._umbilic_minimizer_limit(this.#alive, out)),
    );
    return { status: /** @type {LimitStatus} */ (stringAt(status)), energy, order, error };
  }

  /** By the reporting rule; several times the cost of a step. @returns {Energies} */
  get energies() {
    const [bending, willmore, mvs, mvs_cross, mehlum_tarrou, second_form_variation, area, gaussian, quadratureError] =
      doublesFrom(9, (out) => core()._umbilic_minimizer_energies(this.#alive, out));
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

  /**
   * Begins to tell whether the best surface is a minimum among all surfaces near it.
   * @returns {Certificate} @throws {InputError} for flat caps and very large meshes
   */
  certify() {
    return new Certificate(handleFrom((out) => core()._umbilic_minimizer_certify(this.#alive, out)));
  }

  /** For `Cage.refined`. @returns {Float64Array} x, y, z of the first vertex of each orbit of the control mesh */
  orbitPoints() {
    let pointer = 0;
    const [count] = integersFrom(1, (out) => (pointer = core()._umbilic_minimizer_orbit_points(this.#alive, out)));
    return doublesAt(pointer, 3 * count);
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

/** Counts the directions along which a surface's energy decreases; see core/driver/certificate.h. */
export class Certificate {
  #handle;

  /** Use `Minimizer.certify`. @param {number} handle */
  constructor(handle) {
    this.#handle = handle;
  }

  /** @returns {number} */
  get #alive() {
    return alive(this.#handle, 'certificate');
  }

  /** Units of about an energy evaluation. @param {number} units @returns {boolean} whether the report is ready */
  step(units) {
    const [done] = integersFrom(1, (out) => check(core()._umbilic_certificate_step(this.#alive, units, out)));
    return done !== 0;
  }

  /** @returns {number} from 0 to 1 */
  get progress() {
    return core()._umbilic_certificate_progress(this.#alive);
  }

  /** Once `step` has returned true. @returns {CertificateReport} */
  get report() {
    const [level, unknowns, gauge, tau, negative] = doublesFrom(5, (out) =>
      core()._umbilic_certificate_report(this.#alive, out),
    );
    return { level, unknowns, gauge, tau, negative };
  }

  /** Frees the certificate; a second call does nothing. */
  dispose() {
    if (this.#handle) core()._umbilic_certificate_destroy(this.#handle);
    this.#handle = 0;
  }
}
