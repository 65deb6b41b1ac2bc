// SPDX-License-Identifier: MIT
/**
 * @file What is said of the point of a surface that is pointed at.
 */
import { significant } from './numbers.js';

/** Digits of all numbers. */
const DIGITS = 4;

/** @param {number} value */
const number = (value) => significant(value, DIGITS);

/**
 * @param {{kappa1: number, kappa2: number, deviation: number | null, point: [number, number, number]}} reading curvatures in
 *   1/length
 * @returns {{curvatures: string, place: string}} two lines
 */
export function readingWords({ kappa1, kappa2, deviation, point }) {
  const [mean, gauss] = [(kappa1 + kappa2) / 2, kappa1 * kappa2];
  const moved = deviation === null ? '' : `moved by ${number(deviation)}, `;
  return {
    curvatures: `κ₁ ${number(kappa1)}, κ₂ ${number(kappa2)}, H ${number(mean)} per length, K ${number(gauss)} per length²`,
    place: `${moved}at (${point.map(number).join(', ')})`,
  };
}
