// SPDX-License-Identifier: MIT
/**
 * @file The address of the torus family: `torus.html?weights=bending:1,mvs_cross:1`.
 */
import { cameraField } from './camera.js';
import { formatAddress, parseAddress } from './fields.js';
import { shadingField } from './shading.js';
import { readWeights, weightsExpected, writeWeights } from './weights.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Camera} from './camera.js' */
/** @import {Field} from './fields.js' */
/** @import {Weights} from './weights.js' */

/** @typedef {{weights: Weights, shading: Shading, camera: Camera}} TorusAddress `weights` has two functionals */

/** @type {Field<Weights>} */
const weights = {
  fallback: { bending: 1, mvs_cross: 1 },
  read(text) {
    const read = readWeights(text);
    return read && Object.keys(read).length === 2 ? read : undefined;
  },
  write: writeWeights,
  expected: `two ${weightsExpected}`,
  always: true,
};

/** @type {{[K in keyof TorusAddress]: Field<TorusAddress[K]>}} */
const fields = { weights, shading: shadingField, camera: cameraField };

/** @param {string} search @returns {{address: TorusAddress, notices: string[]}} */
export const parseTorusAddress = (search) => parseAddress(fields, search);

/** @param {TorusAddress} address @returns {string} from the question mark on */
export const formatTorusAddress = (address) => formatAddress(fields, address);
