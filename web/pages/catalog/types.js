// SPDX-License-Identifier: MIT
/**
 * @file The types of the catalog page's state and actions; no code.
 */

/** @import {CatalogAddress} from '../../address/catalog.js' */
/** @import {Catalog, CatalogEntry, CatalogShape} from '../../files/catalog.js' */
/** @import {Theme} from '../../files/theme.js' */

/** "two-3.mvs_cross": shape and functional. @typedef {string} EntryId */

/** The filter of the rows. @typedef {Pick<CatalogAddress, 'genus' | 'arms' | 'group' | 'status' | 'search'>} Filter */

/**
 * The downloads of an entry: the generated cage, the final control mesh and the limit mesh as OBJ, and the limit mesh
 * as STL and GLB.
 * @typedef {'cage' | 'control' | 'limit' | 'stl' | 'glb'} Download
 */

/**
 * @typedef {object} State
 * @property {Catalog | null} catalog null until it is loaded
 * @property {string} problem why the catalog could not be loaded; empty if it could
 * @property {CatalogAddress} address sorting, filter, and the entry whose details are open
 * @property {string[]} notices sentences about invalid parts of the address
 * @property {EntryId[]} chosen entries chosen for comparison, in the order in which they were chosen
 * @property {{entry: EntryId, what: Download} | null} exporting
 * @property {string} exportProblem why the last download failed
 * @property {Theme} theme
 */

/** A row with its entries in the order of the columns. @typedef {{shape: CatalogShape, entries: Array<CatalogEntry | null>}} Row */

/**
 * @typedef {{type: 'catalogLoaded', catalog: Catalog}
 *   | {type: 'catalogFailed', message: string}
 *   | {type: 'sortPressed', key: string}
 *   | {type: 'filterChanged', change: Partial<Filter>}
 *   | {type: 'filterCleared'}
 *   | {type: 'addressFollowed', address: CatalogAddress, notices: string[]}
 *   | {type: 'entryOpened', entry: EntryId} | {type: 'entryClosed'}
 *   | {type: 'entryChosen', entry: EntryId, chosen: boolean} | {type: 'choiceCleared'}
 *   | {type: 'downloadPressed', entry: EntryId, what: Download}
 *   | {type: 'exported'} | {type: 'exportFailed', message: string}
 *   | {type: 'tablePressed'}
 *   | {type: 'noticesDismissed'}
 *   | {type: 'themeChosen', theme: Theme}} Action
 */

export {};
