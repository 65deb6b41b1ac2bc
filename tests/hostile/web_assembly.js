// SPDX-License-Identifier: MIT
/**
 * @file Runs a row of the tables of hostile inputs through the WebAssembly module, as a page does.
 */
import { InputError, Minimizer } from '../../wasm/umbilic.js';
import { stepsOfCage } from './row.js';
import { outcomeOf, wordsOf } from './verdict.js';

/** @typedef {import('./row.js').CageRow | import('./row.js').ProblemRow} FileRow */

/** @param {FileRow} row @returns {{ outcome: string, said: string }} */
function endOf(row) {
  try {
    const asked = row.kind === 'cage' ? { cage: { text: row.content() }, ...stepsOfCage } : row.content();
    const minimizer = new Minimizer(asked);
    try {
      while (!minimizer.step(10));
      const report = JSON.parse(minimizer.report());
      return { outcome: outcomeOf(report), said: wordsOf(report) };
    } finally {
      minimizer.dispose();
    }
  } catch (error) {
    if (error instanceof InputError) return { outcome: 'refused', said: error.message };
    return { outcome: `broken: ${error}`, said: '' };
  }
}

/** @param {FileRow} row @returns {import('./verdict.js').Ended} */
export function runInWebAssembly(row) {
  const before = process.cpuUsage();
  const end = endOf(row);
  const { user, system } = process.cpuUsage(before);
  return { ...end, seconds: (user + system) / 1e6 };
}
