// SPDX-License-Identifier: MIT
/**
 * @file The catalog's address: `index.html?sort=bending&direction=desc&genus=3&search=frame`.
 */
import { choice, formatAddress, isFunctional, parseAddress } from './fields.js';

/** @import {Field} from './fields.js' */

/**
 * @typedef {object} CatalogAddress
 * @property {string} sort `shape` (the paper's order), `genus`, or a functional whose energies order the rows
 * @property {'asc' | 'desc'} direction
 * @property {number | null} genus only shapes of this genus
 * @property {string} search
 */

/** @type {Field<number | null>} */
const genus = {
  fallback: null,
  read: (text) => (/^\d{1,3}$/.test(text) ? Number(text) : undefined),
  write: (value) => (value === null ? '' : String(value)),
  expected: 'a whole number',
};

/** @type {{[K in keyof CatalogAddress]: Field<CatalogAddress[K]>}} */
const fields = {
  sort: {
    fallback: 'shape',
    read: (text) => (isFunctional(text) ? text : undefined),
    write: String,
    expected: 'shape, genus or a functional such as bending',
  },
  direction: choice(/** @type {const} */ (['asc', 'desc']), 'asc'),
  genus,
  search: { fallback: '', read: (text) => text.slice(0, 100), write: String, expected: 'any text' },
};

/** @param {string} search @returns {{address: CatalogAddress, notices: string[]}} */
export const parseCatalogAddress = (search) => parseAddress(fields, search);

/** @param {CatalogAddress} address @returns {string} from the question mark on */
export const formatCatalogAddress = (address) => formatAddress(fields, address);
