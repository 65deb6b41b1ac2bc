// SPDX-License-Identifier: MIT
/**
 * @file The convergence plot: round ticks, scales that hold their values, curves with one piece per level and few
 * points.
 */
import { describe, expect, test } from '@jest/globals';
import { curvePath, linePath, pieces, thinned } from '../../web/plot/curves.js';
import { linearScale, logScale, scaleFor, settled } from '../../web/plot/scales.js';

/** @param {number} count @param {number} level @param {number} [start] */
const samplesOf = (count, level, start = 1) =>
  Array.from({ length: count }, (_, i) => ({
    evaluation: start + i,
    energy: 100 + 50 * Math.exp(-i / 10),
    gradientNorm: 10 ** (2 - i / 20),
    level,
  }));

describe('a linear scale', () => {
  test('that is closed ends at ticks outside the values', () => {
    const { domain, ticks } = linearScale(3936, 10136, 4, true);
    expect(domain).toEqual([2000, 12000]);
    expect(ticks).toEqual([2000, 4000, 6000, 8000, 10000, 12000]);
  });

  test('that is open ends at the values and has ticks inside', () => {
    const { domain, ticks, position } = linearScale(1, 173, 5, false);
    expect(domain).toEqual([1, 173]);
    expect(ticks).toEqual([50, 100, 150]);
    expect(position(1)).toBe(0);
    expect(position(173)).toBe(1);
  });

  test('of one value has room', () => {
    for (const value of [0, 7, -7]) {
      const { domain } = linearScale(value, value, 4, true);
      expect(domain[1]).toBeGreaterThan(domain[0]);
      expect(domain[0]).toBeLessThanOrEqual(value);
      expect(domain[1]).toBeGreaterThanOrEqual(value);
    }
  });

  test('of values that differ by round-off only is that of one value', () => {
    const { domain, ticks, position } = linearScale(25.2, 25.2 * (1 + 2e-15), 4, true);
    expect(domain).toEqual(linearScale(25.2, 25.2, 4, true).domain);
    expect(new Set(ticks).size).toBe(ticks.length);
    expect(Number.isFinite(position(25.2))).toBe(true);
  });
});

describe('a logarithmic scale', () => {
  test('has powers of ten as ticks, and no more than asked', () => {
    const { ticks, domain } = logScale(3e-9, 2e3, 4);
    expect(domain).toEqual([2e-9, 2e3]);
    expect(ticks.length).toBeLessThanOrEqual(5);
    for (const tick of ticks) expect(Math.log10(tick) % 1).toBeCloseTo(0, 9);
  });

  test('within a few powers has finer ticks', () => {
    const { ticks } = logScale(1.4, 40, 4);
    expect(ticks).toEqual([1, 2, 5, 10, 20, 50]);
    expect(logScale(4100, 210_000, 4).ticks).toEqual([2000, 1e4, 1e5, 5e5]);
  });

  test('puts the geometric mean in the middle', () => {
    const { position, domain } = logScale(1e-3, 1e5, 4);
    expect(position(Math.sqrt(domain[0] * domain[1]))).toBeCloseTo(0.5, 12);
  });

  test('is taken for values of one sign that span much, or when asked; never for zeros', () => {
    expect(scaleFor([1, 1000], 4, false).logarithmic).toBe(true);
    expect(scaleFor([1, 2], 4, false).logarithmic).toBe(false);
    expect(scaleFor([1, 2], 4, true).logarithmic).toBe(true);
    expect(scaleFor([0, 1000], 4, false).logarithmic).toBe(false);
    expect(scaleFor([0, NaN], 4, true).logarithmic).toBe(false);
  });
});

describe('a curve', () => {
  const box = { x: 10, y: 20, width: 100, height: 50 };
  const across = linearScale(1, 101, 5, false);

  test('has one piece for each level', () => {
    const levels = pieces([...samplesOf(5, 0), ...samplesOf(7, 1, 6)]);
    expect(levels.map((piece) => piece.length)).toEqual([5, 7]);
    const up = scaleFor([100, 150], 4, false);
    expect(curvePath(levels, (sample) => sample.energy, across, up, box).match(/M/g)).toHaveLength(2);
  });

  test('stays within its box', () => {
    const levels = pieces(samplesOf(101, 0));
    const up = scaleFor(
      levels[0].map((sample) => sample.energy),
      4,
      false,
    );
    const path = curvePath(levels, (sample) => sample.energy, across, up, box);
    const points = [...path.matchAll(/[ML]([\d.]+) ([\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
    expect(points.length).toBeGreaterThan(50);
    for (const [x, y] of points) {
      expect(x >= 10 && x <= 110).toBe(true);
      expect(y >= 20 && y <= 70).toBe(true);
    }
  });

  test('runs along the top of its box where it is above it', () => {
    const up = scaleFor([100, 110], 4, false);
    const path = curvePath([samplesOf(50, 0)], (sample) => sample.energy, across, up, box);
    const heights = [...path.matchAll(/[ML][\d.]+ ([\d.]+)/g)].map(([, y]) => Number(y));
    expect(Math.min(...heights)).toBe(20);
    expect(heights[0]).toBe(20);
    expect(heights[49]).toBeGreaterThan(60);
  });

  test('is shown without the few values that it began with', () => {
    const values = Array.from({ length: 200 }, (_, i) => (i < 5 ? 1000 - i : 100 - i / 10));
    expect(Math.max(...settled(values))).toBeLessThanOrEqual(100);
    expect(Math.min(...settled(values))).toBe(Math.min(...values));
    expect(settled([7])).toEqual([7]);
    expect(settled([NaN, 3, 9])).toEqual([3, 9]);
  });

  test('skips what cannot be shown', () => {
    const samples = samplesOf(5, 0);
    samples[2].gradientNorm = 0;
    const up = scaleFor(
      samples.map((sample) => sample.gradientNorm),
      4,
      true,
    );
    const path = curvePath([samples], (sample) => sample.gradientNorm, across, up, box);
    expect(path).not.toMatch(/NaN|Infinity/);
    expect(path.match(/M/g)).toHaveLength(2);
  });

  test('of many samples keeps the first, the last, and few between', () => {
    const samples = samplesOf(5000, 0);
    const few = thinned(samples, 300);
    expect(few).toHaveLength(300);
    expect(few[0]).toBe(samples[0]);
    expect(few[299]).toBe(samples[4999]);
  });
});

describe('a line through points', () => {
  const square = { x: 10, y: 20, width: 100, height: 100 };
  const across = linearScale(0, 1, 5, false);

  test('goes from the box’s bottom left to its top right with the values', () => {
    const path = linePath([[0, 1], [0.5, 10], [1, 100]], across, logScale(1, 100, 3), square); // prettier-ignore
    expect(path).toBe('M10.0 120.0L60.0 70.0L110.0 20.0');
  });

  test('leaves a gap where a scale cannot show a point', () => {
    const path = linePath([[0, 1], [0.5, 0], [1, 100]], across, logScale(1, 100, 3), square); // prettier-ignore
    expect(path).toBe('M10.0 120.0M110.0 20.0');
  });
});
