// SPDX-License-Identifier: MIT
/**
 * @file The worker that computes meshes of catalog entries, for downloads and pictures.
 */
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { SAVED_QUADS, densityFor } from './density.js';
import { answerRequests } from './requests.js';

/** @import {CageInput, Mesh, Report} from '../../wasm/types.js' */

/**
 * Asks for the generated cage, the final control mesh or the limit mesh as OBJ, or for the arrays of the limit mesh
 * (`mesh`), of the surface in a report. Limit meshes have at most about `quads` quads.
 * @typedef {{what: 'cage' | 'control' | 'limit' | 'mesh', cage?: CageInput, report?: Report | null, quads?: number}} SurfaceQuestion
 */

/** The page's function for asking this worker; see requests.js. @typedef {(question: SurfaceQuestion) => Promise<string | Mesh>} MakeSurface */

/**
 * @param {Minimizer} minimizer
 * @param {'limit' | 'mesh'} what
 * @param {number} quads
 */
function limit(minimizer, what, quads) {
  const density = densityFor(minimizer.controlMesh().edges.length / 4, quads);
  return what === 'limit' ? minimizer.limitObj(density) : minimizer.limitMesh(density);
}

/** @param {SurfaceQuestion} question @returns {string | Mesh} */
function make({ what, cage, report, quads = SAVED_QUADS }) {
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
    return what === 'control' ? minimizer.controlObj() : limit(minimizer, what, quads);
  } finally {
    minimizer.dispose();
  }
}

/** @param {string | Mesh} made @returns {ArrayBuffer[]} */
function buffers(made) {
  if (typeof made === 'string') return [];
  return Object.values(made).map((array) => /** @type {ArrayBuffer} */ (array.buffer));
}

answerRequests(load, (question) => {
  const answer = make(question);
  return { answer, transfer: buffers(answer) };
});
