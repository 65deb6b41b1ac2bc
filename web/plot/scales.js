// SPDX-License-Identifier: MIT
/**
 * @file Axes: map a range of values to [0, 1], with round ticks.
 */

/**
 * @typedef {object} Scale
 * @property {boolean} logarithmic
 * @property {[number, number]} domain
 * @property {number[]} ticks
 * @property {(value: number) => number} position 0 at the start of the domain, 1 at its end
 */

/** @param {number} span @param {number} count */
function niceStep(span, count) {
  const raw = span / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  return ([1, 2, 5].find((m) => m * power >= raw * (1 - 1e-9)) ?? 10) * power;
}

/** Values whose relative difference is smaller get no ticks between them. */
const ROUND_OFF = 1e-10;

/**
 * A linear scale with about `count` intervals. The domain ends at ticks if `closed`, else at the values.
 * @param {number} low
 * @param {number} high
 * @param {number} count
 * @param {boolean} closed
 * @returns {Scale}
 */
export function linearScale(low, high, count, closed) {
  const wide = high - low > ROUND_OFF * Math.max(Math.abs(low), Math.abs(high));
  const span = wide ? high - low : Math.abs(low) || 1;
  const step = niceStep(span, count);
  const first = (closed ? Math.floor : Math.ceil)(low / step + (closed ? 1e-9 : -1e-9));
  const end = wide ? high : low + span;
  const last = (closed ? Math.ceil : Math.floor)(end / step + (closed ? -1e-9 : 1e-9));
  const ticks = Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
  const [start, stop] = closed ? [ticks[0], ticks[ticks.length - 1]] : [low, end];
  return { logarithmic: false, domain: [start, stop], ticks, position: (value) => (value - start) / (stop - start) };
}

/**
 * A logarithmic scale. Its domain ends at round numbers (1, 2 or 5 times a power of ten) around the values. It has at
 * most about `count` ticks, at powers of ten, or at more round numbers if there are few powers.
 * @param {number} low > 0
 * @param {number} high >= low
 * @param {number} count
 * @returns {Scale}
 */
export function logScale(low, high, count) {
  const first = Math.floor(Math.log10(low));
  const powers = Array.from({ length: Math.ceil(Math.log10(high)) - first + 2 }, (_, i) => first + i);
  const round = powers.flatMap((power) => [1, 2, 5].map((mantissa) => Number(`${mantissa}e${power}`)));
  const start = round.findLast((tick) => tick <= low * (1 + 1e-9)) ?? round[0];
  const end = round.find((tick) => tick >= high * (1 - 1e-9) && tick > start) ?? round[round.length - 1];
  const inside = powers.filter((power) => Number(`1e${power}`) >= start && Number(`1e${power}`) <= end);
  const every = Math.max(1, Math.ceil(inside.length / count));
  const fine = round.filter((tick) => tick >= start && tick <= end);
  const coarse = inside.filter((_, i) => i % every === 0).map((power) => Number(`1e${power}`));
  let ticks = coarse;
  if (inside.length < 3) ticks = fine.length <= count + 2 ? fine : [...new Set([start, ...coarse, end])];
  const [a, b] = [Math.log(start), Math.log(end)];
  return { logarithmic: true, domain: [start, end], ticks, position: (value) => (Math.log(value) - a) / (b - a) };
}

/** The fraction of the energies, the highest ones, that may lie above the plot. */
const UNSETTLED = 0.04;

/**
 * The values without the few highest. Energies fall steeply at first; with those values the rest would be a flat line.
 * @param {number[]} values
 */
export function settled(values) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  return sorted.slice(0, Math.max(1, Math.ceil(sorted.length * (1 - UNSETTLED))));
}

/** From this ratio on, a range is easier to read on a logarithmic scale. */
const WIDE = 12;

/**
 * A scale for these values: logarithmic if asked, or if they have one sign and span a wide range.
 * @param {number[]} values
 * @param {number} count about how many ticks
 * @param {boolean} preferLog
 * @returns {Scale}
 */
export function scaleFor(values, count, preferLog) {
  const usable = values.filter((value) => Number.isFinite(value) && (!preferLog || value > 0));
  if (!usable.length) return linearScale(0, 1, count, true);
  const low = usable.reduce((a, b) => Math.min(a, b));
  const high = usable.reduce((a, b) => Math.max(a, b));
  if (low > 0 && (preferLog || high / low > WIDE)) return logScale(low, high, count);
  return linearScale(low, high, count, true);
}
