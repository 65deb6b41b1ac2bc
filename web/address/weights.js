// SPDX-License-Identifier: MIT
/**
 * @file Weights of functionals in an address: `bending:1,mvs_cross:0.5`.
 */
import { functionals } from '../words/functionals.js';
import { numberIn } from './fields.js';

/** @import {FunctionalName} from '../../wasm/types.js' */

/** Weights of functionals; those that are not named are 0. @typedef {Partial<Record<FunctionalName, number>>} Weights */

export const weightsExpected = 'weights such as bending:1,mvs_cross:0.5';

/** @param {string} text @returns {Weights | undefined} undefined unless some weight is positive */
export function readWeights(text) {
  /** @type {Weights} */
  const weights = {};
  for (const part of text.split(',')) {
    const [name, number, ...more] = part.split(':');
    const id = functionals.find((functional) => functional.id === name)?.id;
    const weight = numberIn(number ?? '');
    if (!id || id in weights || more.length || !(weight >= 0 && Number.isFinite(weight))) return undefined;
    weights[id] = weight;
  }
  return Object.values(weights).some((weight) => weight > 0) ? weights : undefined;
}

/** @param {Weights} weights */
export function writeWeights(weights) {
  return Object.entries(weights)
    .map(([name, weight]) => `${name}:${weight}`)
    .join(',');
}
