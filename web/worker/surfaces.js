// SPDX-License-Identifier: MIT
/**
 * @file The worker that makes the meshes of catalog entries, for downloads and for pictures.
 */
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { SAVED_QUADS, densityFor } from './density.js';
import { answerRequests } from './requests.js';

/** @import {Mesh} from '../../wasm/types.js' */
/** @import {CatalogCage, CatalogSurface} from '../files/catalog.js' */

/**
 * The generated cage, the final control mesh or the limit mesh as OBJ, or the latter's arrays; `surface` is not looked at for the cage.
 * Limit meshes have about `quads` quads at most.
 * @typedef {{what: 'cage' | 'control' | 'limit' | 'mesh', cage: CatalogCage, surface: CatalogSurface | null, quads?: number}} SurfaceQuestion
 */

/** The page's way to it; see requests.js. @typedef {(question: SurfaceQuestion) => Promise<string | Mesh>} MakeSurface */

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
function make({ what, cage, surface, quads = SAVED_QUADS }) {
  if (what === 'cage') {
    const generated = new Cage(cage);
    const obj = generated.obj();
    generated.dispose();
    return obj;
  }
  if (!surface) throw new Error('the entry has no surface');
  const start = { level: surface.level, points: Float64Array.from(surface.points) };
  // The limit surface with its caps is the same under every functional.
  const minimizer = new Minimizer({
    cage,
    terms: { bending: 1 },
    options: { levels: [surface.level, surface.level] },
    start,
  });
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
