// SPDX-License-Identifier: MIT
/**
 * @file Counts of passed, failed and skipped tests, and the line that shows them.
 */

/** @typedef {{ passed: number, failed: number, skipped: number }} Tally */

/** @param {boolean} ok @returns {Tally} the tally of one check */
export function one(ok) {
  return { passed: Number(ok), failed: Number(!ok), skipped: 0 };
}

/** @param {Tally[]} tallies @returns {Tally} */
export function sum(tallies) {
  const total = { passed: 0, failed: 0, skipped: 0 };
  for (const { passed, failed, skipped } of tallies) {
    total.passed += passed;
    total.failed += failed;
    total.skipped += skipped;
  }
  return total;
}

/**
 * A run without tests counts as failed, because its caller expected some.
 * @param {Tally} tally
 * @returns {Tally}
 */
export function expectSome(tally) {
  return tally.passed + tally.failed + tally.skipped > 0 ? tally : { ...tally, failed: 1 };
}

/** @param {Tally} tally @returns {string} "3 passed, 0 failed", and the skipped ones if there are any */
export function line({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`;
}
