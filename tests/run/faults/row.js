// SPDX-License-Identifier: MIT
/**
 * @file What is told of one kind of fault.
 */

/**
 * @typedef {object} Row
 * @property {string} fault
 * @property {number} positions at which it happened
 * @property {Record<string, number>} outcomes how often each
 * @property {string[]} wrong outcomes that must not be, with an example of each
 */

/**
 * Counts an outcome.
 * @param {Row} row
 * @param {string} outcome
 * @param {string} wrong what is wrong with it; empty if nothing is
 */
export function count(row, outcome, wrong = '') {
  row.outcomes[outcome] = (row.outcomes[outcome] ?? 0) + 1;
  if (wrong) row.wrong.push(wrong);
  row.positions += 1;
}

/** A line of the table. @param {Row} row */
export function line({ fault, positions, outcomes, wrong }) {
  const words = Object.entries(outcomes).map(([outcome, times]) => `${times} ${outcome}`);
  return `${fault.padEnd(76)}${String(positions).padStart(9)}   ${[...words, ...wrong.map((what) => `WRONG: ${what}`)].join(', ')}`;
}
