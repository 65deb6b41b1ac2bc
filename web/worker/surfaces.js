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
 * @param {Cage} control
 * @param {'limit' | 'mesh'} what
 * @param {number} quads
 */
function limit(control, what, quads) {
  // The limit surface with its caps is the same under every functional.
  const minimizer = new Minimizer(control, { weights: { bending: 1 }, levels: [0, 0] });
  try {
    const density = densityFor(control.counts.faces, quads);
    return what === 'limit' ? minimizer.limitObj(density) : minimizer.limitMesh(density);
  } finally {
    minimizer.dispose();
  }
}

/** @param {SurfaceQuestion} question @returns {string | Mesh} */
function make({ what, cage, surface, quads = SAVED_QUADS }) {
  const generated = Cage.generate(cage.generator, cage);
  try {
    if (what === 'cage') return generated.obj();
    if (!surface) throw new Error('the entry has no surface');
    const control = generated.refined(surface.level, surface.points);
    try {
      return what === 'control' ? control.obj() : limit(control, what, quads);
    } finally {
      control.dispose();
    }
  } finally {
    generated.dispose();
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
