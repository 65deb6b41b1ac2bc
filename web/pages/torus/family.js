// SPDX-License-Identifier: MIT
/**
 * @file The family of tori of revolution. Its parameter is the ratio a = r/R of the radius r of the tube to the radius
 * R of the circle of its centres. Holds the ratios at which energies are computed, known values, and blends of two
 * functionals. Pure; the energies come from the core.
 */

/** @import {FunctionalName, InvariantName} from '../../../wasm/types.js' */
/** @import {Weights} from '../../address/weights.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */
/** @import {Blend} from './types.js' */

const RATIO_STEPS = 400;
/** Ratios at which energies are computed, evenly spaced between 0 and 1. */
export const ratios = Array.from({ length: RATIO_STEPS - 1 }, (_, i) => (i + 1) / RATIO_STEPS);

/** The ratio of the Clifford torus, at which bending is least. */
export const CLIFFORD = Math.SQRT1_2;

/** Limits of third-order functionals as the tube becomes thin, in words, where they are above 0. @type {Partial<Record<FunctionalName, string>>} */
export const thinLimits = {
  mvs_cross: '8π⁴',
  mehlum_tarrou: '9π⁴⁄2',
  second_form_variation: '24π⁴',
  mean_curvature_variation: '8π⁴',
};

/**
 * The third-order invariants of a torus in closed form, with II positive on its outside. With R = 1 the only derivative
 * of curvature that does not vanish is c = dκ₂/ds around the tube, so that with κ₁ = 1/a the densities are κ₁c²,
 * (κ₁ + 2κ₂)c² and 3κ₁κ₂²c².
 * @param {number} a ratio between 0 and 1
 * @returns {Record<InvariantName, number>}
 */
export function torusInvariants(a) {
  const b = 1 - a ** 2;
  return {
    gradient_form: 16 * Math.PI ** 5 * a ** -0.5 * b ** -1.5,
    variation_form: 16 * Math.PI ** 5 * a ** -0.5 * (1 - 3 * a ** 2) * b ** -2.5,
    triple_form: 48 * Math.PI ** 7 * a ** 0.5 * (1 + 4 * a ** 2) * b ** -3.5,
  };
}

/**
 * The ratios that the paper's figure 5 prints as minimizers of w₁·bending + w₂·MVS_cross. The figure calls the first
 * functional Willmore, but these are ratios for the bending integral.
 */
export const printed = [
  { weights: /** @type {Blend['weights']} */ ([1, 1]), ratio: 0.23 },
  { weights: /** @type {Blend['weights']} */ ([0.95, 0.05]), ratio: 0.5 },
];

/** The second weight as a fraction of the sum of both, 0 to 1. @param {Blend['weights']} weights */
export function shareOf([first, second]) {
  return second / (first + second);
}

/** The weights of a share, rounded to thousandths so that addresses stay short. @param {number} share @returns {Blend['weights']} */
export function weightsOf(share) {
  const second = Math.round(1000 * share) / 1000;
  return [Math.round(1000 * (1 - second)) / 1000, second];
}

const SHARE_STEPS = 250;
/**
 * Shares at which the minimizing ratio is computed: denser near both ends, where it changes most, and including the
 * paper's.
 */
export const shares = [
  ...Array.from({ length: SHARE_STEPS + 1 }, (_, i) => (1 - Math.cos((Math.PI * i) / SHARE_STEPS)) / 2),
  ...printed.map(({ weights }) => shareOf(weights)),
].sort((a, b) => a - b);

/** @param {Blend} blend @returns {Weights} by name, as the address and the core use them */
export function namedWeights({ names, weights }) {
  return { [names[0]]: weights[0], [names[1]]: weights[1] };
}

/** @param {Weights} weights of two @returns {Blend} */
export function blendOf(weights) {
  const [first, second] = /** @type {Array<[FunctionalName, number]>} */ (Object.entries(weights));
  return { names: [first[0], second[0]], weights: [first[1], second[1]] };
}

/** @param {Blend} blend @param {TorusEnergies} energies */
export function blendedEnergy({ names, weights }, energies) {
  return weights[0] * energies[names[0]] + weights[1] * energies[names[1]];
}

/** Whether the paper's ratios are for these two functionals. @param {Blend} blend */
export function isThePapers({ names }) {
  return names[0] === 'bending' && names[1] === 'mvs_cross';
}

/**
 * The ratio of the torus that is drawn. A thin torus if the infimum is only approached by ever thinner ones (ratio 0),
 * Clifford's if all tori have the same energy (NaN).
 * @param {number} ratio
 */
export function drawnRatio(ratio) {
  if (Number.isNaN(ratio)) return CLIFFORD;
  return Math.max(ratio, 0.02);
}
