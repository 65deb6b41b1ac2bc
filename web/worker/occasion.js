// SPDX-License-Identifier: MIT
/**
 * @file Work that is done from time to time: at most once per interval, and only for a fraction of the time.
 */

/** The largest fraction of the time that side work may take. */
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

  /** Waits at least one interval from now. */
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
