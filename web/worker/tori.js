// SPDX-License-Identifier: MIT
/**
 * @file The worker for the torus family: energies and minimizers in closed form.
 */
import { load, torusEnergies, torusMinimizer } from '../../wasm/umbilic.js';
import { answerRequests } from './requests.js';

/** @import {FunctionalName, TorusMinimizer} from '../../wasm/types.js' */
/** @import {Weights} from '../address/weights.js' */

/** Asks for the energies of tori of these ratios, or for the torus of least energy for each of these weights. @typedef {{ratios: number[]} | {weights: Weights[]}} Question */

/** @typedef {Record<FunctionalName, number>} TorusEnergies */

/** @typedef {TorusEnergies[] | TorusMinimizer[]} Answer */

/** @param {Question} question @returns {Answer} */
function answer(question) {
  return 'ratios' in question ? question.ratios.map(torusEnergies) : question.weights.map(torusMinimizer);
}

answerRequests(
  () => load({ threads: 1 }),
  (question) => ({ answer: answer(question) }),
);
