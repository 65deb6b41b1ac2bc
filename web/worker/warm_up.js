// SPDX-License-Identifier: MIT
/**
 * @file Runs the expensive parts of the core on a small cage while the page is idle. A browser optimizes WebAssembly
 * only after it has run for a while, and a call in progress keeps its unoptimized code. Without this warm-up the first
 * metric of a large cage takes three times as long, and Cancel has to wait for it.
 */

/** Enough units of work to begin a level, build and factor a metric, and evaluate a few energies. */
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
