// SPDX-License-Identifier: MIT
/**
 * @file The types of the catalog's one state object and of the actions that change it; nothing here runs.
 */

/** @import {Catalog, CatalogEntry, CatalogShape, EntryStatus} from '../../files/catalog.js' */
/** @import {Theme} from '../../files/theme.js' */

/** "two-3.mvs_cross": shape and functional. @typedef {string} EntryId */

/** What rows are ordered by: the catalog's own order, the genus, or the energy under a functional, by its name. @typedef {string} SortKey */

/** @typedef {{key: SortKey, direction: 'ascending' | 'descending'}} Sort */

/**
 * Which rows are shown; null and '' let all of them pass. A row has a status if one of its entries does.
 * @typedef {{genus: number | null, arms: number | null, group: string | null, status: EntryStatus | null, search: string}} Filter
 */

/** What the address tells: the order, the rows, and the entry whose details are open. @typedef {{sort: Sort, filter: Filter, entry: EntryId | null}} Place */

/**
 * What can be downloaded of an entry: the generated cage, the final control mesh and the limit mesh as OBJ, and the latter as STL and GLB.
 * @typedef {'cage' | 'control' | 'limit' | 'stl' | 'glb'} Download
 */

/**
 * @typedef {object} State
 * @property {Catalog | null} catalog null until it is loaded
 * @property {string} problem why it cannot be
 * @property {Place} place
 * @property {EntryId[]} chosen for comparison, in the order in which they were
 * @property {{entry: EntryId, what: Download} | null} exporting
 * @property {string} exportProblem why the last download failed
 * @property {Theme} theme
 */

/** A row with its entries in the order of the columns. @typedef {{shape: CatalogShape, entries: Array<CatalogEntry | null>}} Row */

/**
 * @typedef {{type: 'catalogLoaded', catalog: Catalog}
 *   | {type: 'catalogFailed', message: string}
 *   | {type: 'sortPressed', key: SortKey}
 *   | {type: 'filterChanged', change: Partial<Filter>}
 *   | {type: 'filterCleared'}
 *   | {type: 'addressFollowed', place: Place}
 *   | {type: 'entryOpened', entry: EntryId} | {type: 'entryClosed'}
 *   | {type: 'entryChosen', entry: EntryId, chosen: boolean} | {type: 'choiceCleared'}
 *   | {type: 'downloadPressed', entry: EntryId, what: Download}
 *   | {type: 'exported'} | {type: 'exportFailed', message: string}
 *   | {type: 'tablePressed'}
 *   | {type: 'themeChosen', theme: Theme}} Action
 */

export {};
