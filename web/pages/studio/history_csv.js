// SPDX-License-Identifier: MIT
/**
 * @file The history of a run as comma-separated values (RFC 4180): one line per energy evaluation, numbers with all digits.
 */

/** @import {Sample} from './state/types.js' */

/** @param {Sample[]} samples @returns {string} */
export function historyCsv(samples) {
  const lines = samples.map(({ evaluation, level, energy, gradientNorm }) => [evaluation, level, energy, gradientNorm]);
  return [['evaluation', 'level', 'energy', 'gradient_norm'], ...lines].map((line) => `${line.join(',')}\r\n`).join('');
}
