// SPDX-License-Identifier: MIT
/**
 * @file The curves of plots. The convergence plot's curve has one piece per level, and no more points than pixels.
 */

/** @import {Sample} from '../pages/studio/state/types.js' */
/** @import {Scale} from './scales.js' */

/** @typedef {{x: number, y: number, width: number, height: number}} Box */

/**
 * Splits samples into pieces of one level each, in order.
 * @param {Sample[]} samples
 * @returns {Sample[][]}
 */
export function pieces(samples) {
  /** @type {Sample[][]} */
  const found = [];
  for (const sample of samples) {
    const piece = found.at(-1);
    if (piece && piece[0].level === sample.level) piece.push(sample);
    else found.push([sample]);
  }
  return found;
}

/**
 * Keeps at most about `limit` samples: the first, the last, and evenly picked ones between.
 * @param {Sample[]} samples
 * @param {number} limit >= 2
 * @returns {Sample[]}
 */
export function thinned(samples, limit) {
  if (samples.length <= limit) return samples;
  const step = (samples.length - 1) / (limit - 1);
  return Array.from({ length: limit }, (_, i) => samples[Math.round(i * step)]);
}

/**
 * The SVG path of one quantity over the evaluations. A piece with a single sample becomes a dot; values that the scale
 * cannot show leave gaps.
 * @param {Sample[][]} levels
 * @param {(sample: Sample) => number} value
 * @param {Scale} across
 * @param {Scale} up
 * @param {Box} box
 */
export function curvePath(levels, value, across, up, box) {
  let path = '';
  for (const piece of levels) {
    let pen = 'M';
    for (const sample of thinned(piece, box.width)) {
      const y = Math.min(1, up.position(value(sample)));
      if (!Number.isFinite(y)) {
        pen = 'M';
        continue;
      }
      const px = box.x + across.position(sample.evaluation) * box.width;
      const py = box.y + (1 - y) * box.height;
      path += `${pen}${px.toFixed(1)} ${py.toFixed(1)}${piece.length === 1 ? 'h0' : ''}`;
      pen = 'L';
    }
  }
  return path;
}

/**
 * The SVG path through points; those that a scale cannot show leave gaps.
 * @param {Array<[number, number]>} points
 * @param {Scale} across
 * @param {Scale} up
 * @param {Box} box
 */
export function linePath(points, across, up, box) {
  let path = '';
  let pen = 'M';
  for (const [x, y] of points) {
    const [px, py] = [box.x + across.position(x) * box.width, box.y + (1 - up.position(y)) * box.height];
    if (!Number.isFinite(px) || !Number.isFinite(py)) {
      pen = 'M';
      continue;
    }
    path += `${pen}${px.toFixed(1)} ${py.toFixed(1)}`;
    pen = 'L';
  }
  return path;
}
