// SPDX-License-Identifier: MIT
/**
 * @file The plane that cuts the surface: across which direction, where, and how its curves are drawn. Pure.
 */

/** @import {Camera} from '../../../address/camera.js' */
/** @import {State} from './types.js' */

/** @typedef {'x' | 'y' | 'z' | 'view'} SectionAxis */

/**
 * @typedef {object} Section
 * @property {boolean} shown
 * @property {SectionAxis} axis what the direction was chosen as
 * @property {[number, number, number]} direction across the plane, of length 1, in the coordinates of the file
 * @property {number} position from -1 to 1: from one end of the surface along the direction to the other
 * @property {number} comb how long the teeth of the comb are, from 0 to 1
 * @property {boolean} cut whether what is before the plane is cut away
 */

/** @type {Section} */
export const firstSection = { shown: false, axis: 'x', direction: [1, 0, 0], position: 0, comb: 0.5, cut: false };

const AXES = /** @type {const} */ ({ x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] });

/**
 * From the surface to the camera.
 * @param {Camera} camera
 * @param {boolean} generated whether z points upwards on the screen, as of generated shapes; otherwise y
 * @returns {[number, number, number]}
 */
function towards({ azimuth, elevation }, generated) {
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const [right, up, out] = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
  return generated ? [right, -out, up] : [right, up, out];
}

/**
 * The section across another direction. The camera's is that of the moment: turning the picture afterwards shows the section
 * from elsewhere.
 * @param {State} state
 * @param {SectionAxis} axis
 * @returns {Section}
 */
export function turnedSection({ view, document }, axis) {
  const generated = document.cage?.source.kind === 'generated';
  const direction = axis === 'view' ? towards(view.camera, generated) : AXES[axis];
  return { ...view.section, axis, direction: [direction[0], direction[1], direction[2]] };
}
