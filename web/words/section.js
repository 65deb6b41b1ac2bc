// SPDX-License-Identifier: MIT
/**
 * @file What is said of a section.
 */
import { counted, significant } from './numbers.js';

/**
 * @param {{curves: number, least: number, largest: number} | null} cut null if nothing is cut; curvatures in 1/length
 * @returns {string}
 */
export function sectionWords(cut) {
  if (!cut) return '';
  if (!cut.curves) return 'The plane does not meet the surface.';
  const [least, largest] = [cut.least, cut.largest].map((value) => significant(value, 3));
  return `${counted(cut.curves, 'curve')}, curvature ${least} to ${largest} per length`;
}
