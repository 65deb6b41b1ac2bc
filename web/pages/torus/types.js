// SPDX-License-Identifier: MIT
/**
 * @file The types of the torus page's state and actions; no code.
 */

/** @import {FunctionalName, TorusMinimizer} from '../../../wasm/types.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */
/** @import {ViewAction, ViewState} from '../view_state.js' */

/** Two functionals and their weights, which are at least 0 and not both 0. @typedef {{names: [FunctionalName, FunctionalName], weights: [number, number]}} Blend */

/** Energies at the ratios of family.js, and the minimizer of each functional alone. @typedef {{energies: TorusEnergies[], alone: Record<FunctionalName, TorusMinimizer>}} Family */

/** The torus of least energy, and its energies, null if no torus attains the minimum. @typedef {{minimizer: TorusMinimizer, energies: TorusEnergies | null}} Least */

/**
 * @typedef {ViewState & Own} State
 *
 * @typedef {object} Own
 * @property {Blend} blend
 * @property {Family | null} family null until it is computed
 * @property {Least | null} least of the blend, or of a previous one while the new one is computed
 * @property {TorusMinimizer[]} path minimizers of the pair's blends at the shares of family.js; empty until computed
 * @property {number | null} pointed index of the ratio whose energies are printed
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
 *   | ViewAction} Action
 */

export {};
