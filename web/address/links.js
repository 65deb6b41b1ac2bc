// SPDX-License-Identifier: MIT
/**
 * @file The links from one page to another.
 */
import { formatCatalogAddress, parseCatalogAddress } from './catalog.js';
import { formatCompareAddress, parseCompareAddress } from './compare.js';
import { formatStudioAddress, parseStudioAddress } from './studio.js';

/** @import {EntryName} from './compare.js' */

/** The address of a catalog entry in the studio. @param {EntryName} entry */
export function studioLink({ shape, functional }) {
  return `./studio.html${formatStudioAddress({ ...parseStudioAddress('').address, shape, functional })}`;
}

/** The address of an entry’s details in the catalog. @param {EntryName} entry */
export function entryLink({ shape, functional }) {
  const { address } = parseCatalogAddress('');
  return `./index.html${formatCatalogAddress({ ...address, entry: `${shape}.${functional}` })}`;
}

/** The address of a comparison of several entries. @param {EntryName[]} entries */
export function compareLink(entries) {
  return `./compare.html${formatCompareAddress({ ...parseCompareAddress('').address, entries })}`;
}
