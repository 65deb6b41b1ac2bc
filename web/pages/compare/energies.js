// SPDX-License-Identifier: MIT
/**
 * @file The energies of entries side by side, with the smallest of each functional marked. Pure.
 */
import { functionals } from '../../words/functionals.js';

/** @import {FunctionalName} from '../../../wasm/types.js' */
/** @import {CatalogEntry} from '../../files/catalog.js' */

/** @typedef {{value: number | null, least: boolean}} Cell `value` is null if there is none or it diverges */

/**
 * Energies whose relative difference is smaller count as equal: they belong to one surface, or to one shape from two
 * runs.
 */
const SAME = 1e-9;

/**
 * A row for each functional, a cell for each entry; no row for a functional that is newer than all entries. Several
 * equal energies may be the smallest; a single energy is not marked.
 * @param {Array<CatalogEntry | null>} entries
 * @returns {Array<{functional: FunctionalName, cells: Cell[]}>}
 */
export function energyTable(entries) {
  const minimized = entries.flatMap((entry) => (entry?.minimizer ? [entry] : []));
  const told = functionals.filter(({ id }) => !minimized.length || minimized.some(({ energies }) => id in energies));
  return told.map(({ id }) => {
    const values = entries.map((entry) => (entry?.minimizer ? (entry.energies[id] ?? null) : null));
    const known = values.filter((value) => value !== null);
    const least = Math.min(...known);
    const cells = values.map((value) => ({
      value,
      least: value !== null && known.length > 1 && value <= least + SAME * Math.abs(least),
    }));
    return { functional: id, cells };
  });
}
