// SPDX-License-Identifier: MIT
/**
 * @file The types of the comparison page's state and actions; no code.
 */

/** @import {Mesh} from '../../../wasm/types.js' */
/** @import {EntryName} from '../../address/compare.js' */
/** @import {Catalog} from '../../files/catalog.js' */
/** @import {ViewAction, ViewState} from '../view_state.js' */

/**
 * A surface of unit size, with curvatures at points spread over its area; or why there is none.
 * @typedef {Mesh & {spread: Float32Array} | {problem: string}} Shown
 */

/**
 * @typedef {ViewState & Own} State
 *
 * @typedef {object} Own
 * @property {Catalog | null} catalog
 * @property {EntryName[]} entries shown side by side, from left to right
 * @property {Record<string, Shown>} surfaces by the names of their entries; missing ones are being loaded
 */

/**
 * @typedef {{type: 'catalogLoaded', catalog: Catalog}
 *   | {type: 'catalogFailed', message: string}
 *   | {type: 'surfaceLoaded', name: string, surface: Shown}
 *   | {type: 'entryChosen', index: number, change: Partial<EntryName>}
 *   | {type: 'entryAdded'}
 *   | {type: 'entryRemoved', index: number}
 *   | ViewAction} Action
 */

export {};
