// SPDX-License-Identifier: MIT
/**
 * @file The triangle of a blend: which functionals are at its corners, which point in it the weights are, and the weights
 * of a point. The shares are the weights, as on the page of tori: their sum is 1, and energies are not scaled. Pure.
 */

/** @import {FunctionalName} from '../../../../wasm/types.js' */
/** @import {Shares} from '../../../plot/triangle.js' */
/** @import {Corners, Settings} from './types.js' */

/** @typedef {Settings['weights']} Weights */

/** @type {Corners} */
export const defaultCorners = ['mean_curvature_variation', 'second_form_variation', 'bending'];

/** A stored document may be older than the triangle. @param {Settings} settings @returns {Corners} */
export const cornersOf = ({ corners }) => corners ?? defaultCorners;

/** Those that weigh. @param {Weights} weights */
const weighing = (weights) =>
  /** @type {FunctionalName[]} */ (Object.keys(weights)).filter((name) => weights[name] > 0);

/**
 * Corners at which all functionals of a blend are, if those are three at most. Others stay where they are.
 * @param {Corners} corners
 * @param {Weights} weights
 * @returns {Corners}
 */
export function fittedCorners(corners, weights) {
  const wanted = weighing(weights);
  const missing = wanted.filter((name) => !corners.includes(name));
  if (wanted.length > corners.length || !missing.length) return corners;
  return /** @type {Corners} */ (
    corners.map((corner) => (wanted.includes(corner) ? corner : (missing.shift() ?? corner)))
  );
}

/**
 * The point of a blend. `parts` are those of the whole blend; `shares` those among the corners, null where none of them
 * weighs; `outside` are the functionals that weigh and are at no corner.
 * @param {Corners} corners
 * @param {Weights} weights
 * @returns {{shares: Shares | null, parts: Shares, outside: FunctionalName[]}}
 */
export function pointOf(corners, weights) {
  /** @param {FunctionalName} name */
  const weightOf = (name) => (weights[name] > 0 && Number.isFinite(weights[name]) ? weights[name] : 0);
  const own = corners.map(weightOf);
  const sum = own.reduce((total, weight) => total + weight, 0);
  const outside = weighing(weights).filter((name) => !corners.includes(name));
  const whole = outside.reduce((total, name) => total + weightOf(name), sum);
  /** @param {number} total */
  const partsOf = (total) => /** @type {Shares} */ (own.map((weight) => (total > 0 ? weight / total : 0)));
  return { shares: sum > 0 ? partsOf(sum) : null, parts: partsOf(whole), outside };
}

/** Rounded to thousandths that sum to 1, so that addresses stay short. @param {Shares} shares @returns {Shares} */
export function roundedShares([top, left]) {
  const first = Math.round(1000 * top);
  const second = Math.min(1000 - first, Math.round(1000 * left));
  return [first / 1000, second / 1000, (1000 - first - second) / 1000];
}

/**
 * The weights of a point: the shares at the corners, and 0 for all others.
 * @param {Corners} corners
 * @param {Weights} weights as they were
 * @param {Shares} shares
 * @returns {Weights}
 */
export function weightsAt(corners, weights, shares) {
  const none = Object.fromEntries(Object.keys(weights).map((name) => [name, 0]));
  const rounded = roundedShares(shares);
  return /** @type {Weights} */ ({ ...none, ...Object.fromEntries(corners.map((name, i) => [name, rounded[i]])) });
}

/**
 * Chooses the functional of a corner. The corner's weight goes to it; if it is at another corner, the two change places
 * and the blend stays.
 * @param {Corners} corners
 * @param {Weights} weights
 * @param {number} index
 * @param {FunctionalName} name
 * @returns {{corners: Corners, weights: Weights}}
 */
export function withCorner(corners, weights, index, name) {
  const before = corners[index];
  const other = corners.indexOf(name);
  const chosen = /** @type {Corners} */ (corners.with(index, name));
  if (other >= 0) return { corners: /** @type {Corners} */ (chosen.with(other, before)), weights };
  return { corners: chosen, weights: { ...weights, [before]: 0, [name]: weights[name] + weights[before] } };
}
