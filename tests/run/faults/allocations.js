// SPDX-License-Identifier: MIT
/**
 * @file Allocations of the C contract that fail (tests/faults/allocations.cpp).
 */
import path from 'node:path';
import { capture, root } from '../process.js';

/** @typedef {import('./row.js').Row} Row */

/** A failure becomes a status, or the code does without the memory; with threads, a position may not come. */
const good = ['out of memory', 'coped', 'not reached'];

/**
 * @param {number} first how many allocations of loading and the first step fail; 0 for all
 * @param {number} later how many of all others
 * @returns {Promise<Row[]>}
 */
export async function failAllocations(first, later) {
  const program = path.join(root, 'build/native/tests/umbilic_faults');
  const { code, text } = await capture(program, ['--first', String(first), '--later', String(later)], { minutes: 60 });
  const parts = text.split('\n').filter((line) => line.startsWith('{'));
  if (code !== 0 || !parts.length) throw new Error(`${program} ended with ${code}: ${text}`);
  return parts.map(rowOf);
}

/** @param {string} json what the program says of one part @returns {Row} */
function rowOf(json) {
  const { part, mode, positions, allocations, outcomes } = JSON.parse(json);
  /** @type {Row} */
  const row = { fault: `allocation, ${mode}, of ${allocations} (${part})`, positions, outcomes: {}, wrong: [] };
  for (const [outcome, { count, first }] of Object.entries(outcomes)) {
    row.outcomes[outcome] = count;
    if (!good.includes(outcome)) row.wrong.push(`${outcome} at ${first}`);
  }
  return row;
}
