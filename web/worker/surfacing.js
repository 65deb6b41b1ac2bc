// SPDX-License-Identifier: MIT
/**
 * @file What is sent of a surface: its meshes, without what the page knows of them, and what is computed of it while that is shown.
 */
import { createComputed } from './computed.js';
import { createOwnSurface } from './own_surface.js';
import { createTopologyFilter } from './topology.js';

/** @import {Cage, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Wish} from './computed.js' */
/** @import {Recalled, Surfaced} from './protocol.js' */

/** @param {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error}} core */
export function createSurfacing(core) {
  const known = { limit: createTopologyFilter(), control: createTopologyFilter() };
  const own = createOwnSurface(core);
  const computed = createComputed(own);
  /** @type {Wish | null} */
  let wish = null;

  /** @param {Wish | null} next what is computed from now on */
  function wishFor(next) {
    wish = next;
    if (wish?.of !== 'deviation') computed.drop();
  }

  /** @param {Minimizer} run @param {Mesh} limit @param {number} density @returns {Pick<Surfaced, 'computed'>} */
  function valuesOf(run, limit, density) {
    if (!wish) return {};
    try {
      return { computed: computed.of(wish, run, limit, density) };
    } catch (error) {
      // Where an energy is infinite, it has no density; the surface is shown all the same.
      if (error instanceof core.InputError) return {};
      throw error;
    }
  }

  return {
    wishFor,

    /** Begins another run, of which the page knows nothing. @param {Wish | null} next as of `wishFor` */
    begin(next) {
      known.limit.forget();
      known.control.forget();
      computed.drop();
      wishFor(next);
    },

    /**
     * @param {Minimizer} run
     * @param {Mesh} limit its limit mesh
     * @param {number} density of it
     * @returns {Pick<Surfaced, 'limit' | 'density' | 'control' | 'computed'>}
     */
    of: (run, limit, density) => ({
      limit: known.limit.update(limit, run.progress.level, density),
      density,
      control: known.control.update(run.controlMesh(), run.progress.level),
      ...valuesOf(run, limit, density),
    }),

    /**
     * Where it began: the limit mesh of the cage's own surface, and the cage.
     * @param {Minimizer} run
     * @param {number} density
     * @returns {Pick<Recalled, 'limit' | 'density' | 'cage'>}
     */
    recalled(run, density) {
      const limit = own.of(run).limitMesh(density);
      if (wish?.of !== 'deviation') own.drop();
      return { limit, density, cage: own.cageOf(run) };
    },
  };
}
