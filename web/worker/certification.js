// SPDX-License-Identifier: MIT
/**
 * @file Computes a certificate in the worker, one step at a time between messages. Keeps the result for the report
 * until the surface changes.
 */

/** @import {Certificate, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Message} from './protocol.js' */

/**
 * @param {object} surroundings
 * @param {(message: Message) => void} surroundings.post
 * @param {(task: () => void) => void} surroundings.yieldThen runs the task after the messages that have arrived
 */
export function createCertification({ post, yieldThen }) {
  /** @type {Certificate | null} */
  let certificate = null;
  let ready = false;
  /** Whether a lower surface is wanted once it is ready. */
  let descends = false;

  function drop() {
    certificate?.dispose();
    certificate = null;
    ready = false;
    descends = false;
  }

  /** @param {number} run @param {Certificate} mine */
  function tellLower(run, mine) {
    descends = false;
    post({ type: 'descended', run, state: mine.descent() });
  }

  /** @param {number} run @param {Minimizer} minimizer */
  function begin(run, minimizer) {
    drop();
    const mine = minimizer.certify();
    certificate = mine;
    yieldThen(() => advance(run, mine));
  }

  /** @param {number} run @param {Certificate} mine */
  function advance(run, mine) {
    if (certificate !== mine) return;
    const done = mine.step(1);
    post({ type: 'certificateAdvanced', run, progress: mine.progress });
    if (!done) return yieldThen(() => advance(run, mine));
    ready = true;
    post({ type: 'certified', run, report: mine.report });
    if (descends) yieldThen(() => certificate === mine && tellLower(run, mine));
  }

  return {
    /** Begins a certificate of the minimizer's best surface. @param {number} run @param {Minimizer} minimizer */
    begin,

    /** Tells a lower surface near the minimizer's best, when its certificate is ready. @param {number} run @param {Minimizer} minimizer */
    descend(run, minimizer) {
      if (certificate && ready) return tellLower(run, certificate);
      if (!certificate) begin(run, minimizer);
      descends = true;
    },

    /** Abandons the certificate, unless it is ready, which the page then knows. @param {number} run */
    abandon(run) {
      if (!certificate || ready) return;
      drop();
      post({ type: 'certificateAbandoned', run });
    },

    /** Whether one is being computed. */
    get works() {
      return certificate !== null && !ready;
    },

    /** The certificate of the current surface; null unless it is ready. */
    ready: () => (ready ? certificate : null),

    drop,
  };
}
