// SPDX-License-Identifier: MIT
/**
 * @file When a run goes on: one unit of work at a time, between the messages that arrive. What the work is, it does not
 * know.
 */

/** `stepping` ends with the next energy evaluation, `running` when told. @typedef {'resting' | 'stepping' | 'running'} Pace */

/**
 * @param {object} surroundings
 * @param {(task: () => void) => void} surroundings.yieldThen runs the task after the messages that have arrived
 * @param {() => number} surroundings.now milliseconds
 */
export function createPacing({ yieldThen, now }) {
  /** @type {Pace} */
  let pace = 'resting';
  let ticking = false;
  /** Milliseconds that the last unit of work took. */
  let cost = Infinity;
  /** @type {() => void} */
  let advance = () => {};

  const goes = () => pace !== 'resting';

  function tick() {
    ticking = false;
    if (!goes()) return;
    advance();
    if (goes()) keepTicking();
  }

  /** Schedules the next unit after the messages that have arrived, so that pause and cancel wait for at most one. */
  function keepTicking() {
    if (ticking) return;
    ticking = true;
    yieldThen(tick);
  }

  return {
    get pace() {
      return pace;
    },
    get cost() {
      return cost;
    },

    /** Goes on until it rests. @param {'stepping' | 'running'} asked @param {() => void} unit the work of one turn */
    go(asked, unit) {
      pace = asked;
      advance = unit;
      keepTicking();
    },

    rest() {
      pace = 'resting';
    },

    /** Does work whose cost is to be known. @template T @param {() => T} work @returns {T} */
    timed(work) {
      const start = now();
      const done = work();
      cost = now() - start;
      return done;
    },
  };
}
