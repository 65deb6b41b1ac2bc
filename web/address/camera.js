// SPDX-License-Identifier: MIT
/**
 * @file A camera as a few numbers in an address, independent of the window's size: `camera=38.7,22.1,1`.
 */
import { numberIn } from './fields.js';

/** @import {Field} from './fields.js' */

/**
 * The surface's axis points up on the screen; there is no roll.
 * @typedef {object} Camera
 * @property {number} azimuth degrees about the axis, -180 to 180
 * @property {number} elevation degrees above the plane across the axis, -90 to 90
 * @property {number} distance 1 if the surface just fits the view; otherwise a multiple of that distance
 * @property {[number, number, number]} target the point it looks at, relative to the surface's centre, in radii
 */

/** Whether what is farther away looks smaller. @typedef {'perspective' | 'orthographic'} Projection */

/** The directions from which a camera looks along an axis of the picture's space. */
export const axisViews = /** @type {const} */ ({
  front: { azimuth: 0, elevation: 0 },
  right: { azimuth: 90, elevation: 0 },
  top: { azimuth: 0, elevation: 90 },
});

/** @typedef {keyof typeof axisViews} AxisView */

/** The axis along which a camera looks, if it does. @param {Camera} camera @returns {AxisView | null} */
export function axisViewOf({ azimuth, elevation }) {
  const names = /** @type {AxisView[]} */ (Object.keys(axisViews));
  return names.find((name) => axisViews[name].azimuth === azimuth && axisViews[name].elevation === elevation) ?? null;
}

/** The initial camera of every surface. @type {Camera} */
export const firstCamera = { azimuth: 38.7, elevation: 22.1, distance: 1, target: [0, 0, 0] };

/** The smallest and the largest distance of the camera. */
export const NEAREST = 0.05;
export const FARTHEST = 8;
/** The largest distance of the target from the centre. */
const ASIDE = 20;

/** @param {number} value @param {number} decimals */
const rounded = (value, decimals) => Number(value.toFixed(decimals)) + 0;

/**
 * Rounds to the digits that an address keeps: tenths of a degree, thousandths of the size.
 * @param {Camera} camera
 * @returns {Camera}
 */
export function roundCamera({ azimuth, elevation, distance, target }) {
  const [x, y, z] = target.map((value) => rounded(value, 3));
  return {
    azimuth: rounded(azimuth, 1),
    elevation: rounded(elevation, 1),
    distance: rounded(distance, 3),
    target: [x, y, z],
  };
}

/** @param {Camera} a @param {Camera} b */
export function sameCamera(a, b) {
  return write(a) === write(b);
}

/** @param {Camera} camera */
function write(camera) {
  const { azimuth, elevation, distance, target } = roundCamera(camera);
  return [azimuth, elevation, distance, ...(target.some(Boolean) ? target : [])].join(',');
}

/** @param {string} text @returns {Camera | undefined} */
function read(text) {
  const numbers = text.split(',').map(numberIn);
  const [azimuth, elevation, distance, x = 0, y = 0, z = 0] = numbers;
  const inside =
    (numbers.length === 3 || numbers.length === 6) &&
    Math.abs(azimuth) <= 180 &&
    Math.abs(elevation) <= 90 &&
    distance >= NEAREST &&
    distance <= FARTHEST &&
    [x, y, z].every((value) => Math.abs(value) <= ASIDE);
  return inside ? roundCamera({ azimuth, elevation, distance, target: [x, y, z] }) : undefined;
}

/** @type {Field<Camera>} */
export const cameraField = {
  fallback: firstCamera,
  read,
  write,
  expected: 'azimuth and elevation in degrees, distance, and where it is not 0 the target, with commas between',
};
