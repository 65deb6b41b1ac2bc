// SPDX-License-Identifier: MIT
/**
 * @file What is prepared while a surface rests, so that the next one moves at once: the first level of the open run, and
 * the run that the user will probably start next.
 */

/** @import {Minimizer} from '../../wasm/umbilic.js' */
/** @import {Problem} from '../../wasm/types.js' */

/**
 * The largest number of patches of a level that is prepared in advance; a larger one takes memory that viewing does not
 * need.
 */
const MOST_PATCHES_AHEAD = 4000;

/**
 * @param {object} surroundings
 * @param {{Minimizer: typeof Minimizer, InputError: new (message: string) => Error}} surroundings.core
 * @param {(task: () => void) => void} surroundings.yieldThen runs the task after the messages that have arrived
 */
export function createPreparing({ core, yieldThen }) {
  /** @type {{key: string, minimizer: Minimizer} | null} */
  let expected = null;

  /** Does one part of the preparation; the last part computes the energies of the start. @param {Minimizer} mine */
  function advance(mine) {
    if (expected?.minimizer !== mine) return;
    if (mine.progress.phase !== 'prepare') return void mine.energies;
    mine.step(1);
    yieldThen(() => advance(mine));
  }

  function drop() {
    expected?.minimizer.dispose();
    expected = null;
  }

  return {
    /**
     * Prepares the first step of a level, in parts between the messages.
     * @param {Minimizer} minimizer at rest
     * @param {number} patches of its level
     * @param {() => boolean} rests whether it is still open, and at rest
     * @param {() => void} done called once nothing is left to prepare
     */
    ahead(minimizer, patches, rests, done) {
      const next = () => {
        if (!rests()) return;
        if (patches > MOST_PATCHES_AHEAD || minimizer.progress.phase !== 'prepare') return done();
        minimizer.step(1);
        yieldThen(next);
      };
      next();
    },

    /** Begins to prepare a run, unless the problem cannot be opened. @param {Problem} problem of a generated cage */
    expect(problem) {
      drop();
      try {
        const minimizer = new core.Minimizer(problem);
        expected = { key: JSON.stringify(problem), minimizer };
        yieldThen(() => advance(minimizer));
      } catch (error) {
        if (!(error instanceof core.InputError)) throw error;
      }
    },

    /**
     * The prepared run if it is for this problem, however far its preparation has come; otherwise a new one.
     * @param {Problem | string} problem @returns {Minimizer} @throws {import('../../wasm/umbilic.js').InputError}
     */
    take(problem) {
      const generated = typeof problem !== 'string' && 'generator' in Object(problem?.cage) && !problem.start;
      if (expected && generated && expected.key === JSON.stringify(problem)) {
        const { minimizer } = expected;
        expected = null;
        return minimizer;
      }
      const minimizer = new core.Minimizer(problem);
      drop();
      return minimizer;
    },
  };
}
