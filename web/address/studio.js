// SPDX-License-Identifier: MIT
/**
 * @file The studio's address. `studio.html?shape=two-3&functional=mvs_cross` opens the catalog's minimizer.
 * `studio.html?shape=two-3`, and every address with `start=cage`, opens the cage with the settings for minimizing it.
 */
import { cameraField } from './camera.js';
import { choice, formatAddress, isFunctional, isShape, number, numberIn, parseAddress } from './fields.js';
import { studioShadingField } from './shading.js';
import { readWeights, weightsExpected, writeWeights } from './weights.js';

/** @import {CapName} from '../../wasm/types.js' */
/** @import {Shading} from '../colour/quantities.js' */
/** @import {Camera} from './camera.js' */
/** @import {Field} from './fields.js' */
/** @import {Weights} from './weights.js' */

/**
 * @typedef {object} StudioAddress
 * @property {string} shape a generator's name; empty if the surface came from a file
 * @property {string} functional the name of a functional or of a blend in the catalog, `blend` if `weights` holds, or
 *   empty
 * @property {'catalog' | 'cage'} start what is opened if a functional is named
 * @property {'hub' | 'flag'} family
 * @property {number} thickness
 * @property {Weights} weights
 * @property {CapName} cap
 * @property {'on' | 'off'} symmetry
 * @property {[number, number]} levels
 * @property {number} accuracy 0 where the levels are given
 * @property {Shading} shading
 * @property {Camera} camera
 */

/** The largest level that an address may ask for. */
const MAX_LEVEL = 6;

/** @type {Field<[number, number]>} */
const levels = {
  fallback: [0, 2],
  read(text) {
    const [first, last, ...more] = text.split('..').map(numberIn);
    const good = !more.length && Number.isInteger(first) && Number.isInteger(last) && first >= 0 && first <= last;
    return good && last <= MAX_LEVEL ? [first, last] : undefined;
  },
  write: (value) => value.join('..'),
  expected: `two levels such as 0..2, at most ${MAX_LEVEL}`,
};

/** @type {{[K in keyof StudioAddress]: Field<StudioAddress[K]>}} */
const fields = {
  shape: {
    fallback: 'two-3',
    read: (text) => (isShape(text) ? text : undefined),
    write: String,
    expected: 'a shape of the menu, such as two-3 or cube-frame',
    always: true,
  },
  functional: {
    fallback: '',
    read: (text) => (isFunctional(text) ? text : undefined),
    write: String,
    expected: 'a functional such as bending or mvs_cross',
  },
  start: choice(/** @type {const} */ (['catalog', 'cage']), 'catalog'),
  family: choice(/** @type {const} */ (['hub', 'flag']), 'flag'),
  thickness: number(1, 0.5, 1.5),
  weights: { fallback: {}, read: readWeights, write: writeWeights, expected: weightsExpected },
  cap: choice(/** @type {const} */ (['smooth', 'flat', 'none']), 'smooth'),
  symmetry: choice(/** @type {const} */ (['on', 'off']), 'on'),
  levels,
  accuracy: number(0, 0, 1),
  shading: studioShadingField,
  camera: cameraField,
};

/** @param {string} search @returns {{address: StudioAddress, notices: string[]}} */
export const parseStudioAddress = (search) => parseAddress(fields, search);

/** @param {StudioAddress} address @returns {string} from the question mark on */
export const formatStudioAddress = (address) => formatAddress(fields, address);
