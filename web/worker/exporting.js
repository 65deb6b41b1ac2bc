// SPDX-License-Identifier: MIT
/**
 * @file The files that the worker makes of its run: meshes as OBJ, PLY, STL and GLB, the report and the problem.
 */
import { glb } from '../files/glb.js';
import { placed } from '../files/placed.js';
import { ply } from '../files/ply.js';
import { stl } from '../files/stl.js';
import { coloursOf } from './colouring.js';
import { createComputed } from './computed.js';
import { SAVED_QUADS, densityFor } from './density.js';
import { createOwnSurface } from './own_surface.js';

/** @import {Cage, Certificate, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Exportable, ExportOptions} from './protocol.js' */

/** @typedef {{Cage: typeof Cage, Minimizer: typeof Minimizer}} Core */

/**
 * The control mesh after some Catmull-Clark steps, which leave the surface as it is; after the first all faces are quads.
 * @param {Core} core
 * @param {Minimizer} run
 * @param {number} steps
 */
function refinedObj(core, run, steps) {
  const { problem, state } = run;
  const level = state.level + steps;
  const options = { ...problem.options, levels: /** @type {[number, number]} */ ([level, level]) };
  const refined = new core.Minimizer({ ...problem, start: state, options });
  try {
    return refined.controlObj();
  } finally {
    refined.dispose();
  }
}

/** The cage of a run as it was given, as OBJ text. @param {Core} core @param {Minimizer} run */
export function cageObj(core, { problem }) {
  const cage = new core.Cage(problem.cage);
  try {
    return cage.obj();
  } finally {
    cage.dispose();
  }
}

/** @param {Core} core @param {Minimizer} run @param {Mesh} mesh @param {number} density of it @param {ExportOptions} options */
function coloursFor(core, run, mesh, density, { colouring }) {
  if (!colouring) return null;
  const { wish = null } = colouring;
  const computed = createComputed(createOwnSurface(core));
  try {
    return coloursOf(colouring, mesh.curvatures, () =>
      wish ? computed.of(wish, run, mesh, density).values : new Float32Array(0),
    );
  } finally {
    computed.drop();
  }
}

/**
 * @param {Core} core
 * @param {Minimizer} run
 * @param {Exportable} what
 * @param {ExportOptions} options
 * @param {{patches: () => number, certificate: () => Certificate | null}} about the run: how many faces its evaluated mesh has,
 *   and its certificate, if that is ready
 * @returns {string | ArrayBuffer}
 * @throws {import('../../wasm/umbilic.js').InputError} if the mesh would be too large
 */
export function exported(core, run, what, options, about) {
  if (what === 'report') return run.report(about.certificate() ?? undefined);
  if (what === 'problem') return `${JSON.stringify(run.problem, null, 2)}\n`;
  if (what === 'control') return run.controlObj();
  if (what === 'quads') return refinedObj(core, run, options.steps ?? 1);
  const density = options.density ?? densityFor(about.patches(), SAVED_QUADS);
  if (what === 'limit') return run.limitObj(density);
  const mesh = run.limitMesh(density);
  const at = placed(mesh, options.extent);
  if (what === 'ply') return ply(at);
  if (what === 'stl') return stl(at);
  return glb(at, options.name ?? '', options.up ?? 'z', coloursFor(core, run, mesh, density, options));
}
