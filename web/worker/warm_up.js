// SPDX-License-Identifier: MIT
/**
 * @file Runs the heavy parts of the core on a small cage while the page rests. A browser compiles WebAssembly well only
 * after it has run for a while, and a call that goes on stays as it was compiled: without this the first metric of a
 * large cage takes three times as long, and Cancel waits for it.
 */

/** Units of work that begin a level, prepare a metric, factor it and evaluate a few energies. */
const UNITS = 13;

/**
 * @param {{Minimizer: typeof import('../../wasm/umbilic.js').Minimizer}} core
 * @param {(task: () => void) => void} yieldThen runs the task after the messages that have arrived meanwhile
 * @param {() => void} [done]
 */
export function warmUp({ Minimizer }, yieldThen, done = () => {}) {
  yieldThen(() => {
    const minimizer = new Minimizer({
      cage: { generator: 'two-3' },
      terms: { mvs_cross: 1 },
      options: { levels: [2, 2] },
    });
    let units = 0;
    const next = () => {
      minimizer.step(1);
      if (++units < UNITS) {
        yieldThen(next);
      } else {
        minimizer.dispose();
        done();
      }
    };
    yieldThen(next);
  });
}
