// SPDX-License-Identifier: MIT
/**
 * @file Loads one entry of the catalog with its report.
 */
import { findEntry } from './state/entry.js';
import { entryName } from '../../address/compare.js';
import { loadCatalog, loadReport } from '../../files/catalog.js';

/** @import {EntryName} from '../../address/compare.js' */
/** @import {Report} from '../../../wasm/types.js' */
/** @import {CatalogEntry} from '../../files/catalog.js' */

/**
 * @param {EntryName} name
 * @returns {Promise<{entry: CatalogEntry, report: Report} | {missing: string, retry?: boolean}>} `missing` is a
 *   sentence that says why there is none, and `retry` whether it may be there another time; the promise is never rejected
 */
export async function loadEntry(name) {
  // Loads both files at once: a minimizer's file is named after its shape and functional.
  const report = loadReport(`${entryName(name)}.json`);
  report.catch(() => {}); // handled below, unless the entry is missing anyway
  try {
    const found = findEntry(await loadCatalog(), name);
    return 'missing' in found ? found : { ...found, report: await report };
  } catch (error) {
    return { missing: error instanceof Error ? error.message : String(error), retry: true };
  }
}
