// SPDX-License-Identifier: MIT
/**
 * @file The two colour maps. They are curves in OKLab with equal distances between entries, so that equal steps of a
 * quantity look like equal steps of colour.
 */
import { distance, encode, fromLch, toLinearRgb } from './oklab.js';

/** @import {Triple} from './oklab.js' */

/** @typedef {'diverging' | 'sequential'} MapName */

/** Number of entries of a map. */
export const MAP_SIZE = 256;

const FINE_STEPS = 2000;

/** A point of a Bézier curve, by De Casteljau's algorithm. @param {Triple[]} controls @param {number} t @returns {Triple} */
function bezier(controls, t) {
  let points = controls;
  while (points.length > 1) {
    points = points
      .slice(1)
      .map((point, i) => /** @type {Triple} */ (point.map((value, k) => (1 - t) * points[i][k] + t * value)));
  }
  return points[0];
}

/**
 * `count` points of the Bézier curve at equal distances along it.
 * @param {Triple[]} controls
 * @param {number} count
 * @returns {Triple[]}
 */
function uniformCurve(controls, count) {
  const fine = Array.from({ length: FINE_STEPS + 1 }, (_, i) => bezier(controls, i / FINE_STEPS));
  const lengths = [0];
  for (let i = 1; i < fine.length; i++) lengths.push(lengths[i - 1] + distance(fine[i], fine[i - 1]));
  const total = lengths[FINE_STEPS];
  let i = 0;
  return Array.from({ length: count }, (_, k) => {
    const target = (total * k) / (count - 1);
    while (i < FINE_STEPS - 1 && lengths[i + 1] < target) i++;
    const t = (target - lengths[i]) / (lengths[i + 1] - lengths[i]);
    return /** @type {Triple} */ (fine[i].map((value, c) => (1 - t) * value + t * fine[i + 1][c]));
  });
}

/**
 * Half of the diverging map, from a pale neutral to a saturated end. Both halves have the same lightnesses and
 * chromas, so neither sign looks stronger.
 * @param {number} hue
 */
function arm(hue) {
  return uniformCurve([fromLch(0.95, 0.0, hue), fromLch(0.8, 0.115, hue), fromLch(0.56, 0.16, hue)], MAP_SIZE / 2);
}

/**
 * The map's colours in OKLab, from its low end to its high end. `diverging` is blue for negative, pale at zero, red
 * for positive.
 * @param {MapName} name
 * @returns {Triple[]}
 */
export function mapColours(name) {
  if (name === 'diverging') return [...arm(255).reverse(), ...arm(32)];
  return uniformCurve(
    [
      fromLch(0.34, 0.11, 288),
      fromLch(0.46, 0.13, 262),
      fromLch(0.62, 0.1, 190),
      fromLch(0.76, 0.17, 145),
      fromLch(0.93, 0.16, 108),
    ],
    MAP_SIZE,
  );
}

/**
 * The map as sRGB bytes, red green blue alpha for each entry.
 * @param {MapName} name
 * @returns {Uint8Array}
 */
export function mapBytes(name) {
  const bytes = new Uint8Array(4 * MAP_SIZE);
  mapColours(name).forEach((lab, i) => {
    bytes.set([...toLinearRgb(lab).map((value) => Math.round(255 * encode(value))), 255], 4 * i);
  });
  return bytes;
}

/**
 * The map as a CSS gradient.
 * @param {MapName} name
 * @param {string} direction as in CSS, 'to right'
 * @param {number} [middle] where the middle of the colours is, from 0 to 1
 */
export function mapGradient(name, direction, middle = 0.5) {
  const bytes = mapBytes(name);
  const stops = Array.from({ length: 33 }, (_, k) => {
    const i = 4 * Math.round((k * (MAP_SIZE - 1)) / 32);
    const part = k <= 16 ? (k / 16) * middle : middle + (k / 16 - 1) * (1 - middle);
    return `rgb(${bytes[i]} ${bytes[i + 1]} ${bytes[i + 2]}) ${(100 * part).toFixed(2)}%`;
  });
  return `linear-gradient(${direction}, ${stops.join(', ')})`;
}
