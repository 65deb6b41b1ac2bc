// SPDX-License-Identifier: MIT
/**
 * @file Loads one entry of the catalog with its surface.
 */
import { findEntry } from '../state/entry.js';
import { entryName } from '../address/compare.js';
import { loadCatalog, loadSurface } from './catalog.js';

/** @import {EntryName} from '../address/compare.js' */
/** @import {Weights} from '../address/weights.js' */
/** @import {CatalogEntry, CatalogSurface} from './catalog.js' */

/**
 * @param {EntryName} name
 * @returns {Promise<{entry: CatalogEntry, weights: Weights, surface: CatalogSurface} | {missing: string}>} `missing`: why there
 *   is none, in a sentence; never rejected
 */
export async function loadEntry(name) {
  // Both at once: the file of a minimizer is called after its shape and functional.
  const surface = loadSurface(`${entryName(name)}.json`);
  surface.catch(() => {}); // told below, unless there is no such entry
  try {
    const found = findEntry(await loadCatalog(), name);
    return 'missing' in found ? found : { ...found, surface: await surface };
  } catch (error) {
    return { missing: error instanceof Error ? error.message : String(error) };
  }
}
