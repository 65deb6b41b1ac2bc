// SPDX-License-Identifier: MIT
/**
 * @file The run that the user may well ask for next, made and prepared while the one on the screen rests, so that its
 * surface moves at once.
 */
import { cageFrom } from './sources.js';

/** @import {Cage, Minimizer} from '../../wasm/umbilic.js' */
/** @import {CageCounts, MinimizerOptions} from '../../wasm/types.js' */
/** @import {Generated, Source} from './protocol.js' */

/** @typedef {{minimizer: Minimizer, counts: CageCounts}} Opened */

/**
 * @param {object} surroundings
 * @param {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error}} surroundings.core
 * @param {(task: () => void) => void} surroundings.yieldThen runs the task after the messages that have arrived
 */
export function createExpectation({ core, yieldThen }) {
  /** @type {{key: string, opened: Opened} | null} */
  let expected = null;

  /** @param {Source} source @param {MinimizerOptions} options @returns {Opened} */
  function make(source, options) {
    const { cage, counts } = cageFrom(core.Cage, source);
    try {
      return { minimizer: new core.Minimizer(cage, options), counts };
    } finally {
      cage.dispose();
    }
  }

  /** One part of what the first step takes, at last the energies of the start. @param {Opened} mine */
  function advance(mine) {
    if (expected?.opened !== mine) return;
    const { minimizer } = mine;
    if (minimizer.progress.phase !== 'prepare') return void minimizer.energies;
    minimizer.step(1);
    yieldThen(() => advance(mine));
  }

  function drop() {
    expected?.opened.minimizer.dispose();
    expected = null;
  }

  /** @param {Source} source @param {MinimizerOptions} options */
  const keyOf = (source, options) => JSON.stringify({ source, options });

  return {
    /** What cannot be opened is not expected. @param {Generated} source @param {MinimizerOptions} options */
    begin(source, options) {
      drop();
      try {
        const opened = make(source, options);
        expected = { key: keyOf(source, options), opened };
        yieldThen(() => advance(opened));
      } catch (error) {
        if (!(error instanceof core.InputError)) throw error;
      }
    },

    /**
     * The run that was expected, as far as it is prepared, or a new one.
     * @param {Source} source @param {MinimizerOptions} options @returns {Opened} @throws {import('../../wasm/umbilic.js').InputError}
     */
    take(source, options) {
      if (expected && source.kind === 'generated' && expected.key === keyOf(source, options)) {
        const { opened } = expected;
        expected = null;
        return opened;
      }
      const opened = make(source, options);
      drop();
      return opened;
    },
  };
}
