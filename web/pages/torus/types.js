// SPDX-License-Identifier: MIT
/**
 * @file The types of the torus page's state and of the actions that change it; nothing here runs.
 */

/** @import {FunctionalName, TorusMinimizer} from '../../../wasm/types.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */
/** @import {ViewAction, ViewState} from '../view_state.js' */

/** Two functionals and their weights, which are at least 0 and not both 0. @typedef {{names: [FunctionalName, FunctionalName], weights: [number, number]}} Blend */

/** The family, the same for every blend. @typedef {{energies: TorusEnergies[], alone: Record<FunctionalName, TorusMinimizer>}} Family */

/** The torus of least energy, and its energies; they are null where there is no such torus. @typedef {{minimizer: TorusMinimizer, energies: TorusEnergies | null}} Least */

/**
 * @typedef {ViewState & Own} State
 *
 * @typedef {object} Own
 * @property {Blend} blend
 * @property {Family | null} family `energies` at the ratios of family.js
 * @property {Least | null} least of the blend, or of one that was there a moment ago
 * @property {TorusMinimizer[]} path of the pair's blends, at the shares of family.js; empty until it is there
 * @property {number | null} pointed the place among the ratios whose energies are told
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
