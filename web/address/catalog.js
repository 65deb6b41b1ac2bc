// SPDX-License-Identifier: MIT
/**
 * @file The catalog's address: `index.html?sort=bending&direction=desc&genus=3&status=converged&search=frame&entry=cube-frame.mvs`.
 */
import { choice, formatAddress, isFunctional, isShape, parseAddress } from './fields.js';

/** @import {EntryStatus} from '../files/catalog.js' */
/** @import {Field} from './fields.js' */

/**
 * @typedef {object} CatalogAddress null or empty means no filter
 * @property {string} sort `shape` (the paper's order), `genus`, or a functional whose energies order the rows
 * @property {'asc' | 'desc'} direction
 * @property {number | null} genus only shapes of this genus
 * @property {number | null} arms only shapes whose junctions have this many arms
 * @property {string} group only shapes with this symmetry, a Schoenflies symbol
 * @property {EntryStatus | ''} status only shapes that have an entry with this status
 * @property {string} search
 * @property {string} entry the entry whose details are open, as "shape.functional"; empty if none
 */

/** @type {EntryStatus[]} */
export const statuses = ['converged', 'upper_bound', 'zero_attained', 'infimum_not_attained', 'none_found'];

/** @type {Field<number | null>} */
const wholeNumber = {
  fallback: null,
  read: (text) => (/^\d{1,3}$/.test(text) ? Number(text) : undefined),
  write: (value) => (value === null ? '' : String(value)),
  expected: 'a whole number',
};

/** @param {string} text */
function isEntry(text) {
  const [shape, functional, ...more] = text.split('.');
  return isShape(shape) && isFunctional(functional ?? '') && !more.length;
}

/** @type {{[K in keyof CatalogAddress]: Field<CatalogAddress[K]>}} */
const fields = {
  sort: {
    fallback: 'shape',
    read: (text) => (isFunctional(text) ? text : undefined),
    write: String,
    expected: 'shape, genus or a functional such as bending',
  },
  direction: choice(/** @type {const} */ (['asc', 'desc']), 'asc'),
  genus: wholeNumber,
  arms: wholeNumber,
  group: {
    fallback: '',
    read: (text) => (/^[A-Z][a-z0-9]{0,4}$/.test(text) ? text : undefined),
    write: String,
    expected: 'a Schoenflies symbol such as D3h',
  },
  status: {
    fallback: '',
    read: (text) => statuses.find((status) => status === text),
    write: String,
    expected: `one of ${statuses.join(', ')}`,
  },
  search: { fallback: '', read: (text) => text.slice(0, 100), write: String, expected: 'any text' },
  entry: {
    fallback: '',
    read: (text) => (isEntry(text) ? text : undefined),
    write: String,
    expected: 'an entry such as two-3.bending',
  },
};

/** @param {string} search @returns {{address: CatalogAddress, notices: string[]}} */
export const parseCatalogAddress = (search) => parseAddress(fields, search);

/** @param {CatalogAddress} address @returns {string} from the question mark on */
export const formatCatalogAddress = (address) => formatAddress(fields, address);
