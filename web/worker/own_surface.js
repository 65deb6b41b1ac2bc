// SPDX-License-Identifier: MIT
/**
 * @file The cage's own surface, from which a run began or could have begun.
 */

/** @import {Cage, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh, Problem} from '../../wasm/types.js' */

/** @param {{Cage: typeof Cage, Minimizer: typeof Minimizer}} core */
export function createOwnSurface(core) {
  /** The run whose cage's own surface is known, and at which level. @type {{run: Minimizer, level: number, surface: Minimizer} | null} */
  let known = null;

  function drop() {
    known?.surface.dispose();
    known = null;
  }

  return {
    /**
     * The cage's own surface, at the level at which a run is.
     * @param {Minimizer} run
     * @returns {Minimizer} the same one while the run stays at this level; belongs to this module
     */
    of(run) {
      const { level } = run.progress;
      if (known?.run === run && known.level === level) return known.surface;
      drop();
      /** @type {Problem} */
      const problem = { ...run.problem, options: { ...run.problem.options, levels: [level, level] } };
      delete problem.start;
      known = { run, level, surface: new core.Minimizer(problem) };
      return known.surface;
    },

    /** The control mesh of a run's cage as it was given. @param {Minimizer} run @returns {Mesh} */
    cageOf(run) {
      const cage = new core.Cage(run.problem.cage);
      try {
        return cage.mesh();
      } finally {
        cage.dispose();
      }
    },

    drop,
  };
}
