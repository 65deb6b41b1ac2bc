// SPDX-License-Identifier: MIT
/**
 * @file The types of the comparison's state and of the actions that change it; nothing here runs.
 */

/** @import {Mesh} from '../../../wasm/types.js' */
/** @import {Camera} from '../../address/camera.js' */
/** @import {EntryName} from '../../address/compare.js' */
/** @import {Shading} from '../../colour/quantities.js' */
/** @import {Catalog} from '../../files/catalog.js' */
/** @import {Theme} from '../../files/theme.js' */

/**
 * A surface of unit size with curvatures spread over its area, or why there is none.
 * @typedef {Mesh & {spread: Float32Array} | {problem: string}} Shown
 */

/**
 * @typedef {object} State
 * @property {Catalog | null} catalog
 * @property {EntryName[]} entries side by side, from the left
 * @property {Record<string, Shown>} surfaces by their entries' names; those that are missing are being loaded
 * @property {Shading} shading
 * @property {Camera} camera of all of them
 * @property {number} fits how often the view was asked to fit the surfaces
 * @property {Theme} theme
 * @property {string[]} notices sentences that the reader has not dismissed
 */

/**
 * @typedef {{type: 'catalogLoaded', catalog: Catalog}
 *   | {type: 'catalogFailed', message: string}
 *   | {type: 'surfaceLoaded', name: string, surface: Shown}
 *   | {type: 'entryChosen', index: number, change: Partial<EntryName>}
 *   | {type: 'entryAdded'}
 *   | {type: 'entryRemoved', index: number}
 *   | {type: 'shadingChosen', shading: Shading}
 *   | {type: 'cameraMoved', camera: Camera}
 *   | {type: 'fitPressed'}
 *   | {type: 'themeChosen', theme: Theme}
 *   | {type: 'noticesDismissed'}} Action
 */

export {};
