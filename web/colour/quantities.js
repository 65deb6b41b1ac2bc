// SPDX-License-Identifier: MIT
/**
 * @file The quantities that can colour a surface, with their units and colour maps: functions of the principal curvatures
 * κ1 ≥ κ2, the density of the energy and the distance from the cage's own surface, which the worker computes while they are
 * shown; and the patterns that can be drawn on it instead.
 */

/** @import {MapName} from './maps.js' */

/** @typedef {'stripes' | 'isophotes'} Pattern */
/** What is no function of curvatures. @typedef {'energy' | 'deviation'} Computed */
/** @typedef {'mean' | 'gaussian' | 'kappa1' | 'kappa2' | 'magnitude' | 'difference' | Computed | 'energy_log' | Pattern | 'plain'} Shading */

/** Along which the colours of a quantity are spread, if not evenly. @typedef {{to: (value: number) => number, from: (place: number) => number}} Axis */

/**
 * @typedef {object} Quantity
 * @property {Shading} shading
 * @property {string} name
 * @property {string} symbol
 * @property {string} unit
 * @property {boolean} signed signed quantities have a range symmetric about 0
 * @property {MapName} map
 * @property {(kappa1: number, kappa2: number) => number} [value] of curvatures; what is computed is a number by itself
 * @property {Axis} [axis] its ranges, and all that follows from them, are in places of this axis
 * @property {string} glsl the place of the same as `value`, in terms of `k.x` and `k.y`, or of what is computed `d`
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
 * The same with as many colours from 0.1 to 1 as from 1 to 10: a few places may have nearly all of the energy.
 * @type {Quantity}
 */
export const energyDecades = {
  ...energyDensity,
  shading: 'energy_log',
  name: 'Energy density, by decades',
  axis: { to: Math.log10, from: (place) => 10 ** place },
  glsl: 'log(max(d, 1e-30)) / 2.302585093',
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
export const allQuantities = [...quantities, energyDensity, energyDecades, deviation];

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
export function computedOf(shading) {
  if (shading === 'energy_log') return 'energy';
  return shading === 'energy' || shading === 'deviation' ? shading : null;
}

/** Where a value is on a quantity's axis. @param {Pick<Quantity, 'axis'>} quantity @param {number} value */
export const placeOf = ({ axis }, value) => (axis ? axis.to(value) : value);

/** The value at a place of its axis. @param {Pick<Quantity, 'axis'>} quantity @param {number} place */
export const valueAt = ({ axis }, place) => (axis ? axis.from(place) : place);

/** Largest number of values from which a range is computed; the percentiles of this many are accurate enough. */
const MAX_SAMPLES = 4096;

/**
 * The finite places of a quantity's values at evenly picked vertices.
 * @param {Quantity} quantity
 * @param {Float32Array} curvatures κ1, κ2 per vertex
 * @param {Float32Array | null} [computed] the values of a quantity that is no function of curvatures
 * @returns {Float64Array}
 */
export function sampleValues(quantity, curvatures, computed = null) {
  const { value: of } = quantity;
  if (!of && !computed) return new Float64Array(0);
  const vertices = curvatures.length / 2;
  const count = Math.min(vertices, MAX_SAMPLES);
  const values = new Float64Array(count);
  let kept = 0;
  for (let i = 0; i < count; i++) {
    const vertex = Math.floor((i * vertices) / count);
    const [kappa1, kappa2] = [curvatures[2 * vertex], curvatures[2 * vertex + 1]];
    const value = of ? of(kappa1, kappa2) : placeOf(quantity, computed?.[vertex] ?? NaN);
    if (Number.isFinite(value)) values[kept++] = value;
  }
  return values.subarray(0, kept);
}
