// SPDX-License-Identifier: MIT
/**
 * @file The address of a comparison: `compare.html?entries=two-3.bending,two-3.mvs_cross&shading=mean`.
 */
import { cameraField } from './camera.js';
import { formatAddress, isFunctional, isShape, parseAddress } from './fields.js';
import { shadingField } from './shading.js';

/** @import {Shading} from '../colour/quantities.js' */
/** @import {Camera} from './camera.js' */
/** @import {Field} from './fields.js' */

/** An entry of the catalog by its names. @typedef {{shape: string, functional: string}} EntryName */

/** @typedef {{entries: EntryName[], shading: Shading, camera: Camera}} CompareAddress */

/** The smallest and the largest number of entries side by side. */
export const FEWEST = 2;
export const MOST = 4;

/** @type {EntryName[]} the paper's figure 1 */
const firstEntries = ['bending', 'mvs', 'mvs_cross'].map((functional) => ({ shape: 'two-3', functional }));

/** @param {EntryName} entry */
export const entryName = ({ shape, functional }) => `${shape}.${functional}`;

/** @type {Field<EntryName[]>} */
const entries = {
  fallback: firstEntries,
  read(text) {
    const names = text.split(',').map((part) => part.split('.'));
    const good = names.every(([shape, functional, ...more]) => {
      return isShape(shape) && isFunctional(functional ?? '') && !more.length;
    });
    if (!good || names.length < FEWEST || names.length > MOST) return undefined;
    return names.map(([shape, functional]) => ({ shape, functional }));
  },
  write: (value) => value.map(entryName).join(','),
  expected: `${FEWEST} to ${MOST} entries such as two-3.bending,two-3.mvs_cross`,
  always: true,
};

/** @type {{[K in keyof CompareAddress]: Field<CompareAddress[K]>}} */
const fields = { entries, shading: shadingField, camera: cameraField };

/** @param {string} search @returns {{address: CompareAddress, notices: string[]}} */
export const parseCompareAddress = (search) => parseAddress(fields, search);

/** @param {CompareAddress} address @returns {string} from the question mark on */
export const formatCompareAddress = (address) => formatAddress(fields, address);
