// SPDX-License-Identifier: MIT
/**
 * @file The quantities that can colour a surface, with their units and colour maps: functions of the principal curvatures
 * κ1 ≥ κ2, the density of the energy and the distance from the cage's own surface, which the worker computes while they are
 * shown; and the patterns that can be drawn on it instead.
 */

/** @import {MapName} from './maps.js' */

/** @typedef {'stripes' | 'isophotes'} Pattern */
/** What is no function of curvatures. @typedef {'energy' | 'deviation'} Computed */
/** @typedef {'mean' | 'gaussian' | 'kappa1' | 'kappa2' | 'magnitude' | 'difference' | Computed | Pattern | 'plain'} Shading */

/**
 * @typedef {object} Quantity
 * @property {Shading} shading
 * @property {string} name
 * @property {string} symbol
 * @property {string} unit
 * @property {boolean} signed signed quantities have a range symmetric about 0
 * @property {MapName} map
 * @property {(kappa1: number, kappa2: number) => number} [value] of curvatures; what is computed is a number by itself
 * @property {string} glsl the same as `value`, in terms of `k.x` and `k.y`, or of what is computed `d`
 */

/** Those of curvatures. @type {Array<Quantity & Required<Pick<Quantity, 'value'>>>} */
export const quantities = [
  {
    shading: 'mean',
    name: 'Mean curvature',
    symbol: 'H = (κ₁ + κ₂) / 2',
    unit: '1/length',
    signed: true,
    map: 'diverging',
    value: (kappa1, kappa2) => (kappa1 + kappa2) / 2,
    glsl: '0.5 * (k.x + k.y)',
  },
  {
    shading: 'gaussian',
    name: 'Gaussian curvature',
    symbol: 'K = κ₁κ₂',
    unit: '1/length²',
    signed: true,
    map: 'diverging',
    value: (kappa1, kappa2) => kappa1 * kappa2,
    glsl: 'k.x * k.y',
  },
  {
    shading: 'kappa1',
    name: 'Largest principal curvature',
    symbol: 'κ₁',
    unit: '1/length',
    signed: true,
    map: 'diverging',
    value: (kappa1) => kappa1,
    glsl: 'k.x',
  },
  {
    shading: 'kappa2',
    name: 'Smallest principal curvature',
    symbol: 'κ₂',
    unit: '1/length',
    signed: true,
    map: 'diverging',
    value: (_, kappa2) => kappa2,
    glsl: 'k.y',
  },
  {
    shading: 'magnitude',
    name: 'Curvature magnitude',
    symbol: '√(κ₁² + κ₂²)',
    unit: '1/length',
    signed: false,
    map: 'sequential',
    value: (kappa1, kappa2) => Math.hypot(kappa1, kappa2),
    glsl: 'length(k)',
  },
  {
    shading: 'difference',
    name: 'Curvature difference',
    symbol: '|κ₁ − κ₂|',
    unit: '1/length',
    signed: false,
    map: 'sequential',
    value: (kappa1, kappa2) => Math.abs(kappa1 - kappa2),
    glsl: 'abs(k.x - k.y)',
  },
];

/**
 * Where the energy is: the integrand of the weighted functionals with their powers of the area A, which integrates to the
 * energy. Energies have no unit.
 * @type {Quantity}
 */
export const energyDensity = {
  shading: 'energy',
  name: 'Energy density',
  symbol: 'dE / dA',
  unit: '1/length²',
  signed: false,
  map: 'sequential',
  glsl: 'd',
};

/**
 * The signed distance from the cage's own surface, along its normal: 0 where nothing has moved.
 * @type {Quantity}
 */
export const deviation = {
  shading: 'deviation',
  name: 'Deviation',
  symbol: '(X − X₀)·n₀',
  unit: 'length',
  signed: true,
  map: 'diverging',
  glsl: 'd',
};

/** @type {Quantity[]} */
export const allQuantities = [...quantities, energyDensity, deviation];

/**
 * The shadings that show how smooth the normals are: dark and light lines that follow the viewer.
 * @type {Array<{shading: Pattern, name: string}>}
 */
export const patterns = [
  { shading: 'stripes', name: 'Reflection stripes' },
  { shading: 'isophotes', name: 'Isophotes' },
];

/** The pattern of a shading, if it is one. @param {Shading} shading @returns {Pattern | null} */
export const patternOf = (shading) => patterns.find((pattern) => pattern.shading === shading)?.shading ?? null;

/** The words of an address for shadings by some quantities, by patterns or by nothing. @param {Quantity[]} some @returns {Shading[]} */
export const shadingsOf = (some) => [...[...some, ...patterns].map(({ shading }) => shading), 'plain'];

/**
 * The quantity of a shading; null for patterns and plain.
 * @param {Shading} shading
 * @returns {Quantity | null}
 */
export function quantityOf(shading) {
  return allQuantities.find((quantity) => quantity.shading === shading) ?? null;
}

/** A shading that the worker computes, if it is one. @param {Shading} shading @returns {Computed | null} */
export const computedOf = (shading) => (shading === 'energy' || shading === 'deviation' ? shading : null);

/** Largest number of values from which a range is computed; the percentiles of this many are accurate enough. */
const MAX_SAMPLES = 4096;

/**
 * The finite values of a quantity at evenly picked vertices.
 * @param {Quantity} quantity
 * @param {Float32Array} curvatures κ1, κ2 per vertex
 * @param {Float32Array | null} [computed] the values of a quantity that is no function of curvatures
 * @returns {Float64Array}
 */
export function sampleValues({ value: of }, curvatures, computed = null) {
  if (!of && !computed) return new Float64Array(0);
  const vertices = curvatures.length / 2;
  const count = Math.min(vertices, MAX_SAMPLES);
  const values = new Float64Array(count);
  let kept = 0;
  for (let i = 0; i < count; i++) {
    const vertex = Math.floor((i * vertices) / count);
    const value = of ? of(curvatures[2 * vertex], curvatures[2 * vertex + 1]) : (computed?.[vertex] ?? NaN);
    if (Number.isFinite(value)) values[kept++] = value;
  }
  return values.subarray(0, kept);
}
