// SPDX-License-Identifier: MIT
/**
 * @file What is computed at the vertices of a limit mesh while it is shown: the density of an energy, or the distance from
 * the cage's own surface.
 */
import { createDeviation } from './deviation.js';

/** @import {Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh, Terms} from '../../wasm/types.js' */
/** @import {createOwnSurface} from './own_surface.js' */

/**
 * What is to be computed. The energy need not be the one that is minimized.
 * @typedef {{of: 'deviation'} | {of: 'energy', terms: Terms}} Wish
 */

/** A number for each vertex, and the wish that they fulfil. @typedef {{wish: Wish, values: Float32Array}} ComputedValues */

/** @param {ReturnType<typeof createOwnSurface>} own */
export function createComputed(own) {
  const deviation = createDeviation(own);
  return {
    /**
     * @param {Wish} wish
     * @param {Minimizer} run
     * @param {Mesh} mesh its limit mesh
     * @param {number} density of it
     * @returns {ComputedValues}
     * @throws {import('../../wasm/umbilic.js').InputError} where the energy is infinite
     */
    of: (wish, run, mesh, density) => ({
      wish,
      values:
        wish.of === 'energy'
          ? run.limitMeshWithDensities(density, wish.terms).densities
          : deviation.of(run, mesh, density),
    }),

    /** Forgets what it has kept for the next time. */
    drop: () => deviation.drop(),
  };
}
