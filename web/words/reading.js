// SPDX-License-Identifier: MIT
/**
 * @file What is said of the point of a surface that is pointed at.
 */
import { significant } from './numbers.js';

/** @import {Computed} from '../colour/quantities.js' */

/** Digits of all numbers. */
const DIGITS = 4;

/** @param {number} value */
const number = (value) => significant(value, DIGITS);

/** A number with its name, which stay on one line. @param {string} name @param {number} value */
const named = (name, value) => `${name}\u00a0${number(value)}`;

/**
 * @param {{kappa1: number, kappa2: number, computed: number | null, point: [number, number, number]}} reading curvatures in
 *   1/length
 * @param {Computed | null} of what is computed
 * @returns {{curvatures: string, place: string}} two lines
 */
export function readingWords({ kappa1, kappa2, computed, point }, of) {
  const [mean, gauss] = [(kappa1 + kappa2) / 2, kappa1 * kappa2];
  const told = {
    energy: `energy density\u00a0${number(computed ?? NaN)} per length², `,
    deviation: `moved by ${number(computed ?? NaN)}, `,
  };
  return {
    curvatures: `${named('κ₁', kappa1)}, ${named('κ₂', kappa2)}, ${named('H', mean)} per length, ${named('K', gauss)} per length²`,
    place: `${of && computed !== null ? told[of] : ''}at (${point.map(number).join(', ')})`,
  };
}
