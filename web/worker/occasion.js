// SPDX-License-Identifier: MIT
/**
 * @file Something done now and then, at most once per interval and only for a share of the time.
 */

/** No side work may take more than this part of the time. */
const SIDE_SHARE = 0.25;

export class Occasion {
  #interval;
  #now;
  #due = 0;

  /** @param {number} interval milliseconds @param {() => number} now */
  constructor(interval, now) {
    this.#interval = interval;
    this.#now = now;
  }

  get due() {
    return this.#now() >= this.#due;
  }

  /** Not before an interval from now. */
  postpone() {
    this.#due = this.#now() + this.#interval;
  }

  /** @param {() => void} work */
  do(work) {
    const start = this.#now();
    work();
    const end = this.#now();
    this.#due = Math.max(start + this.#interval, end + (end - start) / SIDE_SHARE);
  }
}
