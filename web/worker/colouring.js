// SPDX-License-Identifier: MIT
/**
 * @file The colours of a mesh's vertices for a file, the same as on the screen.
 */
import { MAP_SIZE, mapColours } from '../colour/maps.js';
import { toLinearRgb } from '../colour/oklab.js';
import { placeOf, quantityOf } from '../colour/quantities.js';
import { shareBelow } from '../colour/range.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Wish} from './computed.js' */
/** @import {Colours} from '../files/glb.js' */

/**
 * What colours the surface, the places of the values at the ends of the colour map, and what has to be computed for it, if anything.
 * @typedef {{shading: Shading, low: number, high: number, wish?: Wish | null}} Colouring
 */

const ONE = 65535;

/**
 * @param {Colouring} colouring
 * @param {Float32Array} curvatures κ1, κ2 per vertex
 * @param {() => Float32Array} computed values per vertex, if the shading is no function of curvatures
 * @returns {Colours | null} null if the shading gives no colours of its own
 */
export function coloursOf({ shading, low, high }, curvatures, computed) {
  const quantity = quantityOf(shading);
  if (!quantity) return null;
  const { value, map, signed } = quantity;
  const shown = value ? null : computed();
  const palette = mapColours(map).map((lab) => toLinearRgb(lab).map((part) => Math.round(ONE * clamped(part))));
  const count = curvatures.length / 2;
  const colours = new Uint16Array(4 * count);
  for (let i = 0; i < count; i++) {
    const number = value ? value(curvatures[2 * i], curvatures[2 * i + 1]) : placeOf(quantity, shown?.[i] ?? 0);
    const entry = Math.round((MAP_SIZE - 1) * clamped(shareBelow(signed, { low, high }, number)));
    colours.set([...palette[entry], ONE], 4 * i);
  }
  return colours;
}

/** To [0, 1]; what is no number is 0. @param {number} value */
const clamped = (value) => Math.min(1, Math.max(0, value || 0));
