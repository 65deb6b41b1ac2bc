// SPDX-License-Identifier: MIT
/**
 * @file The tori of revolution by their ratio a = r/R of the tube's radius to that of the circle of its centres: which ones are computed,
 * what is known of them, and blends of two functionals on them. Pure; the energies are the core's.
 */

/** @import {FunctionalName} from '../../../wasm/types.js' */
/** @import {Weights} from '../../address/weights.js' */
/** @import {TorusEnergies} from '../../worker/tori.js' */
/** @import {Blend} from './types.js' */

const RATIO_STEPS = 400;
/** Ratios at which energies are computed, evenly from near 0 to near 1. */
export const ratios = Array.from({ length: RATIO_STEPS - 1 }, (_, i) => (i + 1) / RATIO_STEPS);

/** Bending is least on the Clifford torus. */
export const CLIFFORD = Math.SQRT1_2;

/** What third-order functionals fall to as the tube thins, in words. @type {Partial<Record<FunctionalName, string>>} */
export const thinLimits = { mvs_cross: '8π⁴', mehlum_tarrou: '9π⁴⁄2', second_form_variation: '24π⁴' };

/**
 * The paper's figure 5: ratios that minimize w₁·bending + w₂·MVS_cross, as printed. It calls the first one Willmore; these are the ratios of
 * the bending integral.
 */
export const printed = [
  { weights: /** @type {Blend['weights']} */ ([1, 1]), ratio: 0.23 },
  { weights: /** @type {Blend['weights']} */ ([0.95, 0.05]), ratio: 0.5 },
];

/** The second weight's part of both, 0 to 1. @param {Blend['weights']} weights */
export function shareOf([first, second]) {
  return second / (first + second);
}

/** To the thousandth, so that an address stays short. @param {number} share @returns {Blend['weights']} */
export function weightsOf(share) {
  const second = Math.round(1000 * share) / 1000;
  return [Math.round(1000 * (1 - second)) / 1000, second];
}

const SHARE_STEPS = 250;
/**
 * Shares at which the minimizing ratio is computed, denser near both ends, where it changes most; the paper's are among them.
 */
export const shares = [
  ...Array.from({ length: SHARE_STEPS + 1 }, (_, i) => (1 - Math.cos((Math.PI * i) / SHARE_STEPS)) / 2),
  ...printed.map(({ weights }) => shareOf(weights)),
].sort((a, b) => a - b);

/** @param {Blend} blend @returns {Weights} as an address and the core have them */
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

/** Whether the paper's ratios are of this pair. @param {Blend} blend */
export function isThePapers({ names }) {
  return names[0] === 'bending' && names[1] === 'mvs_cross';
}

/**
 * The torus that is drawn for a minimizing ratio: a thin one where only ever thinner ones come closer, Clifford's where all are equal.
 * @param {number} ratio
 */
export function drawnRatio(ratio) {
  if (Number.isNaN(ratio)) return CLIFFORD;
  return Math.max(ratio, 0.02);
}
