// SPDX-License-Identifier: MIT
/**
 * @file A worker that is started before anyone needs it, so that it loads while the page reads what it was asked for.
 */

/** @import {WorkerLike} from './client.js' */

/**
 * @param {() => WorkerLike} create
 * @returns {() => WorkerLike} the one that was started, the first time, which says again what it said so far; then others
 */
export function createSpare(create) {
  /** @type {Array<(taker: WorkerLike) => void>} */
  const said = [];
  /** @type {WorkerLike | null} */
  let spare = create();
  spare.onmessage = (event) => said.push((taker) => taker.onmessage?.call(/** @type {Worker} */ (taker), event));
  spare.onerror = (event) => said.push((taker) => taker.onerror?.call(/** @type {Worker} */ (taker), event));
  return () => {
    const mine = spare;
    if (!mine) return create();
    spare = null;
    // Its taker listens by then, and what it says from now on comes later.
    void Promise.resolve().then(() => said.forEach((again) => again(mine)));
    return mine;
  };
}
