// SPDX-License-Identifier: MIT
/**
 * @file A worker's entry: makes the meshes of catalog entries, for downloads. Answers every request in its turn.
 */
import { Cage, Minimizer, load } from '../../wasm/umbilic.js';
import { SAVED_QUADS, densityFor } from './density.js';

/** @import {Mesh} from '../../wasm/types.js' */
/** @import {CatalogCage, CatalogSurface} from '../files/catalog.js' */

/**
 * The generated cage, the final control mesh or the limit mesh as OBJ, or the latter's arrays; `surface` is not looked at for the cage.
 * @typedef {{request: number, what: 'cage' | 'control' | 'limit' | 'mesh', cage: CatalogCage, surface: CatalogSurface | null, quads?: number}} SurfaceCommand
 */

/** @typedef {{request: number, made: string | Mesh} | {request: number, failure: string}} SurfaceMessage */

/**
 * @param {Cage} control
 * @param {'limit' | 'mesh'} what
 */
function limit(control, what) {
  // The limit surface with its caps is the same under every functional.
  const minimizer = new Minimizer(control, { weights: { bending: 1 }, levels: [0, 0] });
  try {
    const density = densityFor(control.counts.faces, SAVED_QUADS);
    return what === 'limit' ? minimizer.limitObj(density) : minimizer.limitMesh(density);
  } finally {
    minimizer.dispose();
  }
}

/** @param {SurfaceCommand} command @returns {string | Mesh} */
function make({ what, cage, surface }) {
  const generated = Cage.generate(cage.generator, cage);
  try {
    if (what === 'cage') return generated.obj();
    if (!surface) throw new Error('the entry has no surface');
    const control = generated.refined(surface.level, surface.points);
    try {
      return what === 'control' ? control.obj() : limit(control, what);
    } finally {
      control.dispose();
    }
  } finally {
    generated.dispose();
  }
}

self.onmessage = async (/** @type {MessageEvent<SurfaceCommand>} */ { data }) => {
  /** @type {SurfaceMessage} */
  let message;
  try {
    await load();
    message = { request: data.request, made: make(data) };
  } catch (error) {
    message = { request: data.request, failure: error instanceof Error ? error.message : String(error) };
  }
  self.postMessage(message);
};
