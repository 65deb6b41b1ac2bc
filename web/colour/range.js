// SPDX-License-Identifier: MIT
/**
 * @file The range of values that a colour map spans. It ignores the few extreme curvatures near extraordinary vertices,
 * has round ends, and changes rarely while the surface moves.
 */

/** @typedef {{low: number, high: number, ticks: number[]}} Range */

/** The fractions of the values that lie below the low end, and below the high end, of the range. */
export const LOW_PERCENTILE = 0.02;
export const HIGH_PERCENTILE = 0.98;

const NICE_ENDS = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];
const NICE_STEPS = [1, 2, 2.5, 5, 10];

/**
 * The smallest of `mantissas`·10^k that is at least `value` > 0.
 * @param {number} value
 * @param {number[]} mantissas
 */
function roundUp(value, mantissas) {
  const exponent = Math.floor(Math.log10(value));
  const scale = 10 ** Math.abs(exponent);
  const mantissa = mantissas.find((m) => m * 10 ** exponent >= value * (1 - 1e-9)) ?? 10;
  return exponent < 0 ? mantissa / scale : mantissa * scale;
}

/**
 * The value below which `fraction` of the sorted values lie.
 * @param {Float64Array} sorted
 * @param {number} fraction
 */
function percentile(sorted, fraction) {
  const position = fraction * (sorted.length - 1);
  const i = Math.floor(position);
  return sorted[i] + (position - i) * ((sorted[i + 1] ?? sorted[i]) - sorted[i]);
}

/**
 * The 2nd to 98th percentile, rounded outwards; symmetric about 0 for signed quantities.
 * @param {Float64Array} values finite; reordered
 * @param {boolean} signed
 * @returns {Range}
 */
export function robustRange(values, signed) {
  if (!values.length) return signed ? symmetric(1) : { low: 0, high: 1, ticks: [0, 0.5, 1] };
  values.sort();
  const low = percentile(values, LOW_PERCENTILE);
  const high = percentile(values, HIGH_PERCENTILE);
  const largest = Math.max(Math.abs(low), Math.abs(high));
  if (!(largest > 0)) return signed ? symmetric(1) : { low: 0, high: 1, ticks: [0, 0.5, 1] };
  if (signed) return symmetric(roundUp(largest, NICE_ENDS));
  const start = low < largest / 3 ? 0 : low;
  const step = roundUp(Math.max(high - start, largest * 1e-3) / 4, NICE_STEPS);
  const first = Math.floor(start / step + 1e-9);
  const last = Math.max(first + 1, Math.ceil(high / step - 1e-9));
  const ticks = Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
  return { low: ticks[0], high: ticks[ticks.length - 1], ticks };
}

/** A range by decades has no more of them: what lies below is dark. */
const MOST_DECADES = 8;

/** The whole numbers between two, at most about `STEPS` + 1 of them in equal steps. @param {number} low @param {number} high */
function wholeTicks(low, high) {
  const step = Math.max(1, Math.ceil((high - low) / STEPS));
  const first = Math.ceil(low);
  return Array.from({ length: Math.max(0, Math.floor((high - first) / step) + 1) }, (_, i) => first + i * step);
}

/**
 * The 2nd to 98th percentile of logarithms, rounded outwards to whole decades.
 * @param {Float64Array} values finite logarithms to the base 10; reordered
 * @returns {Range}
 */
export function decadeRange(values) {
  if (!values.length) return { low: -1, high: 1, ticks: [-1, 0, 1] };
  values.sort();
  const high = Math.ceil(percentile(values, HIGH_PERCENTILE) - 1e-9) + 0; // no -0
  const low = Math.floor(percentile(values, LOW_PERCENTILE) + 1e-9);
  const lowest = Math.max(Math.min(low, high - 1), high - MOST_DECADES);
  return givenDecades(lowest, high);
}

/** A range of logarithms with these ends. @param {number} low @param {number} high above it @returns {Range} */
export function givenDecades(low, high) {
  return { low, high, ticks: [low, ...wholeTicks(low, high).filter((tick) => tick > low && tick < high), high] };
}

/** How many steps a range that is given has between its ticks, about. */
const STEPS = 4;

/**
 * A range with these ends: its ticks are the ends, and round numbers between them.
 * @param {number} low
 * @param {number} high above it
 * @returns {Range}
 */
export function givenRange(low, high) {
  const step = roundUp((high - low) / STEPS, NICE_STEPS);
  const first = Math.ceil(low / step + 1e-9);
  const count = Math.max(0, Math.floor(high / step - 1e-9) - first + 1);
  const round = Array.from({ length: count }, (_, i) => Number(((first + i) * step).toPrecision(12)));
  return { low, high, ticks: [low, ...round.filter((tick) => tick > low && tick < high), high] };
}

/** What keeps two numbers from being the ends of a range; null if nothing does. @param {number} low @param {number} high */
export function problemOfRange(low, high) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return 'Both ends must be numbers.';
  return high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high))
    ? null
    : 'The first must be less than the second.';
}

/**
 * The value that has the middle of the colours: 0 if the quantity has a sign and the range has 0 inside, so that colours
 * tell the sign.
 * @param {boolean} signed
 * @param {Pick<Range, 'low' | 'high'>} range
 */
export const middleOf = (signed, { low, high }) => (signed && low < 0 && high > 0 ? 0 : (low + high) / 2);

/**
 * Which part of the colours lies below a value: not in [0, 1] outside of the range.
 * @param {boolean} signed
 * @param {Pick<Range, 'low' | 'high'>} range
 * @param {number} value
 */
export function shareBelow(signed, { low, high }, value) {
  const middle = middleOf(signed, { low, high });
  const side = value - middle;
  return 0.5 + (0.5 * side) / (side < 0 ? middle - low : high - middle);
}

/** How many isolines a range has, at most. */
const MOST_ISOLINES = 20;

/** The distance of two isolines: a round number, of which 0 is a multiple. @param {Range} range */
export const isolineStep = ({ low, high }) => roundUp((high - low) / MOST_ISOLINES, NICE_STEPS);

/**
 * From the largest of the values to its opposite, rounded outwards: nothing lies outside.
 * @param {Float32Array} values
 * @returns {Range}
 */
export function fullRange(values) {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return symmetric(largest > 0 && Number.isFinite(largest) ? roundUp(largest, NICE_ENDS) : 1);
}

/** @param {number} end @returns {Range} */
function symmetric(end) {
  return { low: -end, high: end, ticks: [-end, -end / 2, 0, end / 2, end] };
}

/**
 * Keeps `previous` as long as it is good enough, so that the legend does not flicker: `next` must not exceed it, nor
 * leave much of it unused.
 * @param {Range | null} previous
 * @param {Range} next
 * @returns {Range}
 */
export function calmRange(previous, next) {
  if (!previous) return next;
  const width = previous.high - previous.low;
  const overshoot = Math.max(next.high - previous.high, previous.low - next.low) / width;
  const used = (next.high - next.low) / width;
  return overshoot <= 0.02 && used >= 0.6 ? previous : next;
}

/** @param {Range} a @param {Range} b ends are round numbers, so they can be compared exactly */
export function sameRange(a, b) {
  return a.low === b.low && a.high === b.high && a.ticks.length === b.ticks.length;
}
