// SPDX-License-Identifier: MIT
/**
 * @file What the user asks for: defaults, what is wrong with it, and the minimizer's options that it amounts to.
 */

/** @import {FunctionalName, MinimizerOptions} from '../../wasm/types.js' */
/** @import {Settings} from './types.js' */

/** Most levels that the page offers; each is four times the patches of the one before. */
export const MAX_LEVEL = 6;

/** @type {Settings} */
export const defaultSettings = {
  functional: 'mvs_cross',
  weights: { bending: 0.5, willmore: 0, mvs: 0, mvs_cross: 0.5, mehlum_tarrou: 0, second_form_variation: 0 },
  cap: 'smooth',
  symmetry: true,
  levels: [0, 2],
  tolerance: 1e-6,
  maxIterations: 1000,
  origin: 'cage',
};

/**
 * The settings with a change. When one end of the levels passes the other, it takes it along.
 * @param {Settings} settings
 * @param {Partial<Settings>} change
 * @returns {Settings}
 */
export function changeSettings(settings, change) {
  const changed = { ...settings, ...change };
  const [first, last] = changed.levels;
  if (first > last) changed.levels = first === settings.levels[0] ? [last, last] : [first, first];
  return changed;
}

/**
 * Weights of the six functionals that are not zero.
 * @param {Settings} settings
 * @returns {Partial<Record<FunctionalName, number>>}
 */
export function activeWeights({ functional, weights }) {
  if (functional !== 'blend') return { [functional]: 1 };
  return Object.fromEntries(Object.entries(weights).filter(([, weight]) => weight !== 0));
}

/**
 * Why nothing can be minimized with these settings, in words; null when it can.
 * @param {Settings} settings
 * @returns {string | null}
 */
export function problemWith(settings) {
  const weights = Object.values(activeWeights(settings));
  if (weights.some((weight) => !(weight >= 0 && Number.isFinite(weight)))) return 'Weights are numbers of at least 0.';
  if (!weights.length) return 'Give at least one functional a weight.';
  if (!(settings.tolerance >= 0 && Number.isFinite(settings.tolerance)))
    return 'The tolerance is a number of at least 0.';
  if (!(Number.isInteger(settings.maxIterations) && settings.maxIterations >= 0)) {
    return 'The iteration limit is a whole number of at least 0.';
  }
  return null;
}

/**
 * @param {Settings} settings
 * @param {number} levelOffset level, counted from the cage, of the mesh that the run starts from
 * @returns {MinimizerOptions}
 */
export function optionsOf(settings, levelOffset) {
  const [first, last] = settings.levels.map((level) => Math.max(0, level - levelOffset));
  return {
    weights: activeWeights(settings),
    cap: settings.cap,
    symmetry: settings.symmetry,
    levels: [first, last],
    tolerance: settings.tolerance,
    maxIterations: settings.maxIterations,
  };
}
