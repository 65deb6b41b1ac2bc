// SPDX-License-Identifier: MIT
/**
 * @file What is sent of a surface: its meshes, without what the page knows of them, and its deviation while that is shown.
 */
import { createDeviation } from './deviation.js';
import { createOwnSurface } from './own_surface.js';
import { createTopologyFilter } from './topology.js';

/** @import {Cage, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Recalled, Surfaced} from './protocol.js' */

/** @param {{Cage: typeof Cage, Minimizer: typeof Minimizer}} core */
export function createSurfacing(core) {
  const known = { limit: createTopologyFilter(), control: createTopologyFilter() };
  const own = createOwnSurface(core);
  const deviation = createDeviation(own);
  let deviating = false;

  /** @param {boolean} on whether deviations are sent from now on */
  function deviate(on) {
    deviating = on;
    if (!on) deviation.drop();
  }

  return {
    deviate,

    /** Begins another run, of which the page knows nothing. @param {boolean} on as of `deviate` */
    begin(on) {
      known.limit.forget();
      known.control.forget();
      deviation.drop();
      deviate(on);
    },

    /**
     * @param {Minimizer} run
     * @param {Mesh} limit its limit mesh
     * @param {number} density of it
     * @returns {Pick<Surfaced, 'limit' | 'density' | 'control' | 'deviations'>}
     */
    of: (run, limit, density) => ({
      limit: known.limit.update(limit, run.progress.level, density),
      density,
      control: known.control.update(run.controlMesh(), run.progress.level),
      ...(deviating && { deviations: deviation.of(run, limit, density) }),
    }),

    /**
     * Where it began: the limit mesh of the cage's own surface, and the cage.
     * @param {Minimizer} run
     * @param {number} density
     * @returns {Pick<Recalled, 'limit' | 'density' | 'cage'>}
     */
    recalled(run, density) {
      const limit = own.of(run).limitMesh(density);
      if (!deviating) own.drop();
      return { limit, density, cage: own.cageOf(run) };
    },
  };
}
