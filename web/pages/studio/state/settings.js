// SPDX-License-Identifier: MIT
/**
 * @file The user's settings: their defaults, what is wrong with them, and the problem that they define.
 */

import { cornersOf, defaultCorners, fittedCorners } from './corners.js';

/** @import {CageInput, FunctionalName, Problem, SurfaceState} from '../../../../wasm/types.js' */
/** @import {Corners, Settings, Source} from './types.js' */

/** The largest level that the page offers. Each level has four times as many patches as the one before. */
export const MAX_LEVEL = 6;

/** The accuracies that the page offers, as parts of the limit. */
export const ACCURACIES = [0.05, 0.01, 0.003];

/** @type {Settings} */
export const defaultSettings = {
  functional: 'mvs_cross',
  weights: {
    bending: 0.5,
    willmore: 0,
    mvs: 0,
    mvs_cross: 0.5,
    mehlum_tarrou: 0,
    second_form_variation: 0,
    mean_curvature_variation: 0,
    curvedness_variation: 0,
  },
  corners: defaultCorners,
  cap: 'smooth',
  cap_rings: 4,
  symmetry: true,
  levels: [0, 2],
  accuracy: null,
  tolerance: 1e-6,
  max_iterations: 1000,
  constraints: {},
  fill: null,
  origin: 'cage',
};

/**
 * Changes settings. If the first level exceeds the last or vice versa, the other one follows.
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
 * The weights of the functionals, without those that are zero.
 * @param {Settings} settings
 * @returns {Partial<Record<FunctionalName, number>>}
 */
export function activeWeights({ functional, weights }) {
  if (functional !== 'blend') return { [functional]: 1 };
  return Object.fromEntries(Object.entries(weights).filter(([, weight]) => weight !== 0));
}

/**
 * Says why these settings cannot be minimized; null if they can.
 * @param {Settings} settings
 * @returns {string | null}
 */
export function problemWith(settings) {
  const weights = Object.values(activeWeights(settings));
  if (weights.some((weight) => !(weight >= 0 && Number.isFinite(weight)))) return 'Weights are numbers of at least 0.';
  if (!weights.length) return 'Give at least one functional a weight.';
  if (!(settings.tolerance >= 0 && Number.isFinite(settings.tolerance)))
    return 'The tolerance is a number of at least 0.';
  if (!(Number.isInteger(settings.max_iterations) && settings.max_iterations >= 0)) {
    return 'The iteration limit is a whole number of at least 0.';
  }
  return null;
}

/**
 * The problem of a run. Levels below that of `start` are left out.
 * @param {Source} source
 * @param {Settings} settings
 * @param {SurfaceState | null} start
 * @returns {Problem | string} the file's own text if the source is a problem
 */
export function problemOf(source, settings, start) {
  if (source.kind === 'problem') return new TextDecoder().decode(source.text);
  const { cap, cap_rings, symmetry, levels, accuracy, tolerance, max_iterations, constraints, fill } = settings;
  return {
    cage: cageOf(source),
    terms: activeWeights(settings),
    ...(fill && { fill }),
    ...(Object.keys(constraints).length > 0 && { constraints }),
    options: { cap, cap_rings, symmetry, levels, tolerance, max_iterations, ...(accuracy !== null && { accuracy }) },
    ...(start && { start }),
  };
}

/** Leaves out undefined parameters. @template {object} T @param {T} parameters @returns {Partial<T>} */
const given = (parameters) =>
  /** @type {Partial<T>} */ (Object.fromEntries(Object.entries(parameters).filter(([, value]) => value !== undefined)));

/** @param {Exclude<Source, {kind: 'problem'}>} source @returns {CageInput} */
function cageOf(source) {
  if (source.kind === 'text') return { name: source.name, text: source.text };
  return { generator: source.name, ...given({ ...source, kind: undefined, name: undefined }) };
}

/**
 * The source of a problem's cage; `name` is the name of the problem's file.
 * @param {CageInput} cage
 * @param {string} name
 * @returns {Exclude<Source, {kind: 'problem'}>}
 */
export function sourceOf(cage, name) {
  if ('text' in cage) return { kind: 'text', name: cage.name || name, text: cage.text };
  const { generator, family = 'flag', thickness = 1, ...parameters } = cage;
  return { kind: 'generated', name: generator, family, thickness, ...parameters };
}

/** @param {Settings['weights']} weights @param {Corners} corners as they were @returns {Pick<Settings, 'functional' | 'weights' | 'corners'>} */
export const blendOf = (weights, corners) => ({
  functional: 'blend',
  weights,
  corners: fittedCorners(corners, weights),
});

/**
 * The page's settings for a problem.
 * @param {Settings} settings
 * @param {Pick<Problem, 'terms' | 'fill' | 'constraints' | 'options'>} problem
 * @returns {Settings}
 */
export function settingsFrom(settings, { terms, fill, constraints = {}, options }) {
  const names = /** @type {FunctionalName[]} */ (Object.keys(terms));
  const none = Object.fromEntries(Object.keys(settings.weights).map((name) => [name, 0]));
  const weights = /** @type {Settings['weights']} */ ({ ...none, ...terms });
  const single = names.length === 1 && terms[names[0]] === 1;
  const asked = {
    ...settings,
    constraints,
    fill: fill ?? null,
    accuracy: options?.accuracy ?? null,
    ...(single ? { functional: names[0] } : blendOf(weights, cornersOf(settings))),
  };
  for (const name of /** @type {const} */ (['cap', 'cap_rings', 'symmetry', 'levels', 'tolerance', 'max_iterations'])) {
    if (options && name in options) Object.assign(asked, { [name]: options[name] });
  }
  return { ...asked, origin: 'cage' };
}
