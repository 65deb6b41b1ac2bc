// SPDX-License-Identifier: MIT
/**
 * @file The types of the torus page's state and of the actions that change it; nothing here runs.
 */

/** @import {FunctionalName, TorusMinimizer} from '../../../wasm/types.js' */
/** @import {Camera} from '../../address/camera.js' */
/** @import {Shading} from '../../colour/quantities.js' */
/** @import {Theme} from '../../files/theme.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */

/** Two functionals and their weights, which are at least 0 and not both 0. @typedef {{names: [FunctionalName, FunctionalName], weights: [number, number]}} Blend */

/** The family, the same for every blend. @typedef {{energies: TorusEnergies[], alone: Record<FunctionalName, TorusMinimizer>}} Family */

/** The torus of least energy, and its energies; they are null where there is no such torus. @typedef {{minimizer: TorusMinimizer, energies: TorusEnergies | null}} Least */

/**
 * @typedef {object} State
 * @property {Blend} blend
 * @property {Family | null} family `energies` at the ratios of family.js
 * @property {Least | null} least of the blend, or of one that was there a moment ago
 * @property {TorusMinimizer[]} path of the pair's blends, at the shares of family.js; empty until it is there
 * @property {number | null} pointed the place among the ratios whose energies are told
 * @property {Shading} shading
 * @property {Camera} camera
 * @property {number} fits how often the view was asked to fit the torus
 * @property {Theme} theme
 * @property {string[]} notices sentences that the reader has not dismissed
 */

/**
 * @typedef {{type: 'familyComputed', family: Family}
 *   | {type: 'leastComputed', blend: Blend, least: Least}
 *   | {type: 'pathComputed', names: Blend['names'], path: TorusMinimizer[]}
 *   | {type: 'computationFailed', message: string}
 *   | {type: 'shareChosen', share: number}
 *   | {type: 'weightsChosen', weights: Blend['weights']}
 *   | {type: 'functionalChosen', index: 0 | 1, name: FunctionalName}
 *   | {type: 'ratioPointed', index: number | null}
 *   | {type: 'shadingChosen', shading: Shading}
 *   | {type: 'cameraMoved', camera: Camera}
 *   | {type: 'fitPressed'}
 *   | {type: 'themeChosen', theme: Theme}
 *   | {type: 'noticesDismissed'}} Action
 */

export {};
