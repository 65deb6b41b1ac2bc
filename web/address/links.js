// SPDX-License-Identifier: MIT
/**
 * @file The links from one page to another.
 */
import { formatCompareAddress, parseCompareAddress } from './compare.js';
import { formatStudioAddress, parseStudioAddress } from './studio.js';

/** @import {EntryName} from './compare.js' */

/** To an entry of the catalog in the studio. @param {EntryName} entry */
export function studioLink({ shape, functional }) {
  return `./studio.html${formatStudioAddress({ ...parseStudioAddress('').address, shape, functional })}`;
}

/** To several side by side. @param {EntryName[]} entries */
export function compareLink(entries) {
  return `./compare.html${formatCompareAddress({ ...parseCompareAddress('').address, entries })}`;
}
