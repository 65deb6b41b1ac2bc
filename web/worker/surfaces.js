// SPDX-License-Identifier: MIT
/**
 * @file The worker that computes meshes of catalog entries, for downloads and pictures.
 */
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { glb } from '../files/glb.js';
import { placed } from '../files/placed.js';
import { stl } from '../files/stl.js';
import { SAVED_QUADS, densityFor } from './density.js';
import { answerRequests } from './requests.js';

/** @import {CageInput, Mesh, Report} from '../../wasm/types.js' */

/** The largest extent of a model in the units of its format: millimetres in STL, metres in GLB. */
const STL_EXTENT = 100;
const GLB_EXTENT = 1;

/**
 * Asks for the generated cage, the final control mesh or the limit mesh as OBJ, for the limit mesh as a file of STL or GLB, or
 * for its arrays (`mesh`), of the surface in a report. Limit meshes have at most about `quads` quads; `name` is that of the
 * model in the file.
 * @typedef {{what: 'cage' | 'control' | 'limit' | 'stl' | 'glb' | 'mesh', cage?: CageInput, report?: Report | null, quads?: number,
 *   name?: string}} SurfaceQuestion
 */

/** The page's function for asking this worker; see requests.js. @typedef {(question: SurfaceQuestion) => Promise<string | ArrayBuffer | Mesh>} MakeSurface */

/**
 * @param {Minimizer} minimizer
 * @param {'limit' | 'stl' | 'glb' | 'mesh'} what
 * @param {number} quads
 * @param {string} name
 */
function limit(minimizer, what, quads, name) {
  const density = densityFor(minimizer.controlMesh().edges.length / 4, quads);
  if (what === 'limit') return minimizer.limitObj(density);
  const mesh = minimizer.limitMesh(density);
  if (what === 'mesh') return mesh;
  return what === 'stl' ? stl(placed(mesh, STL_EXTENT)) : glb(placed(mesh, GLB_EXTENT), name, 'z');
}

/** @param {SurfaceQuestion} question @returns {string | ArrayBuffer | Mesh} */
function make({ what, cage, report, quads = SAVED_QUADS, name = '' }) {
  if (what === 'cage') {
    if (!cage) throw new Error('there is no cage');
    const generated = new Cage(cage);
    const obj = generated.obj();
    generated.dispose();
    return obj;
  }
  if (!report) throw new Error('the entry has no surface');
  const minimizer = new Minimizer(report);
  try {
    return what === 'control' ? minimizer.controlObj() : limit(minimizer, what, quads, name);
  } finally {
    minimizer.dispose();
  }
}

/** @param {string | ArrayBuffer | Mesh} made @returns {ArrayBuffer[]} */
function buffers(made) {
  if (typeof made === 'string') return [];
  if (made instanceof ArrayBuffer) return [made];
  return Object.values(made).map((array) => /** @type {ArrayBuffer} */ (array.buffer));
}

answerRequests(
  () => load({ threads: 1 }),
  (question) => {
    const answer = make(question);
    return { answer, transfer: buffers(answer) };
  },
);
