// SPDX-License-Identifier: MIT
/**
 * @file What a program's end says of a row of the tables of hostile inputs, and whether it is what the row expects.
 */
import { limits } from './row.js';

/** @typedef {import('./row.js').Outcome} Outcome */

/**
 * How a program ended with a row: as rows name it, or in words where no row may. `said` is the message of a refusal, or what
 * the report says; `seconds` are those of the processor.
 * @typedef {{ outcome: Outcome | string, said: string, seconds: number }} Ended
 */

/**
 * Whether the energies of a report are the surface's, by what it says of them.
 * @param {any} report parsed, with null for what is not finite
 * @returns {Outcome | string}
 */
export function outcomeOf({ energies, levels, surface }) {
  if (![...surface.points].every(Number.isFinite)) return 'has points that are not finite';
  const { resolved, below_bound: belowBound, quadrature_error: error } = energies;
  const reported = levels.find((/** @type {any} */ level) => level.level === surface.level)?.energy_reported;
  return resolved && !belowBound && Number.isFinite(error) && Number.isFinite(reported) ? 'minimized' : 'doubtful';
}

/** @param {any} report @returns {string} the counts, groups, repairs and notes of its cage, and why the last level ended */
export function wordsOf({ cage, levels }) {
  const { vertices, faces, genus, boundaries, groups, repairs, notes } = cage;
  const counts = `${vertices} vertices, ${faces} faces, genus ${genus}, boundaries ${boundaries.length}`;
  const names = groups.map((/** @type {any} */ group) => `group ${group.name}`);
  return [counts, ...names, ...repairs, ...notes, levels.at(-1).stop].join('; ');
}

/** Whether a terminal obeys a character; the end of a line it may. @param {string} c */
const isControl = (c) => (c < ' ' && c !== '\n') || (c >= '\x7f' && c <= '\x9f');

/** @param {string} text @returns {string} as a terminal may see it */
export const printable = (text) => Array.from(text, (c) => (isControl(c) ? '?' : c)).join('');

/** @param {import('./row.js').Row} row @param {Ended} ended @returns {string[]} what is not as the row expects it, in words */
export function faults(row, { outcome, said, seconds }) {
  const found = [];
  if (outcome !== row.outcome) found.push(`${outcome}, not ${row.outcome}: ${said}`);
  else if (!said.includes(row.says)) found.push(`does not say "${row.says}": ${said}`);
  if (printable(said) !== said) found.push(`says what a terminal obeys: ${JSON.stringify(said)}`);
  if (seconds > limits.seconds) found.push(`takes ${seconds.toFixed(1)} s of the processor`);
  return found;
}
