// SPDX-License-Identifier: MIT
/**
 * @file The legend's range: robust, round, symmetric for signed quantities, calm while a surface moves; and the
 * quantities themselves.
 */
import { describe, expect, test } from '@jest/globals';
import { quantities, quantityOf, sampleValues } from '../../web/colour/quantities.js';
import { calmRange, fullRange, isolineStep, robustRange, sameRange } from '../../web/colour/range.js';

/** @typedef {import('../../web/colour/quantities.js').Quantity} Quantity */

/** Evenly spread values. @param {number} low @param {number} high */
const spread = (low, high) => Float64Array.from({ length: 1001 }, (_, i) => low + ((high - low) * i) / 1000);

/** @param {import('../../web/colour/quantities.js').Shading} shading */
const quantity = (shading) => /** @type {Quantity & Required<Pick<Quantity, 'value'>>} */ (quantityOf(shading));

describe('a range', () => {
  test('of a signed quantity is symmetric about 0, with 0 a tick', () => {
    const { low, high, ticks } = robustRange(spread(-0.7, 3.1), true);
    expect(low).toBe(-high);
    expect(ticks).toContain(0);
    expect(high).toBe(4); // the 98th percentile is 3.024
  });

  test('spans the 2nd to the 98th percentile, whatever the extremes are', () => {
    const values = spread(-1, 1);
    values[0] = -1e9;
    values[1000] = 1e12;
    expect(robustRange(values, true).high).toBe(1);
  });

  test('of a magnitude starts at 0, unless the magnitudes are nearly one', () => {
    expect(robustRange(spread(0.1, 2), false)).toEqual({ low: 0, high: 2, ticks: [0, 0.5, 1, 1.5, 2] });
    const narrow = robustRange(spread(9.9, 10.1), false);
    expect(narrow.low).toBeLessThanOrEqual(9.904);
    expect(narrow.low).toBeGreaterThan(9.5);
    expect(narrow.high).toBeGreaterThanOrEqual(10.096);
    expect(narrow.high).toBeLessThan(10.5);
  });

  test('of one value, of zeros and of nothing is not empty', () => {
    for (const values of [new Float64Array(9).fill(2), new Float64Array(9), new Float64Array(0)]) {
      for (const signed of [true, false]) {
        const { low, high, ticks } = robustRange(values.slice(), signed);
        expect(high).toBeGreaterThan(low);
        expect(ticks.every(Number.isFinite)).toBe(true);
        for (const value of values) expect(low <= value && value <= high).toBe(true);
      }
    }
  });

  test('has round ends at every scale', () => {
    for (const scale of [1e-6, 1e-3, 1, 1e5]) {
      const { high } = robustRange(spread(-1.3 * scale, 1.3 * scale), true);
      expect(high / scale).toBeCloseTo(1.5, 9);
    }
  });

  test('stays while the surface moves a little, grows when it must, and shrinks when most of it is unused', () => {
    const before = robustRange(spread(-2.4, 2.4), true);
    const little = robustRange(spread(-2, 2), true);
    const more = robustRange(spread(-5, 5), true);
    const less = robustRange(spread(-0.4, 0.4), true);
    expect(calmRange(null, before)).toBe(before);
    expect(calmRange(before, little)).toBe(before);
    expect(calmRange(before, more)).toBe(more);
    expect(calmRange(before, less)).toBe(less);
  });

  test('is the same when its ends and ticks are', () => {
    const range = robustRange(spread(-2.4, 2.4), true);
    expect(sameRange(range, robustRange(spread(-2.41, 2.41), true))).toBe(true);
    expect(sameRange(range, robustRange(spread(-5, 5), true))).toBe(false);
  });
});

describe('a full range', () => {
  test('has the farthest value inside, is symmetric, and is not empty where all are 0', () => {
    const { low, high } = fullRange(Float32Array.of(0, 0, 0, -0.037));
    expect([low, high]).toEqual([-0.04, 0.04]);
    expect(fullRange(new Float32Array(3))).toEqual({ low: -1, high: 1, ticks: [-1, -0.5, 0, 0.5, 1] });
  });
});

describe('the step of isolines', () => {
  test.each([
    [-4, 4, 0.5],
    [0, 1, 0.05],
    [-3e-7, 3e-7, 5e-8],
    [10, 13, 0.2],
  ])('from %d to %d is %d, round, with at most 20 in the range', (low, high, step) => {
    expect(isolineStep({ low, high, ticks: [] }) / step).toBeCloseTo(1, 9);
  });
});

describe('the quantities', () => {
  test('of a sphere of radius 2 are what they are', () => {
    const of = (/** @type {import('../../web/colour/quantities.js').Shading} */ shading) =>
      quantity(shading).value(0.5, 0.5);
    expect(of('mean')).toBe(0.5);
    expect(of('gaussian')).toBe(0.25);
    expect(of('magnitude')).toBeCloseTo(Math.SQRT1_2, 12);
    expect(of('difference')).toBe(0);
  });

  test('satisfy H² − K = ((κ₁ − κ₂)/2)²', () => {
    const [kappa1, kappa2] = [1.7, -0.4];
    const [h, k] = [quantity('mean').value(kappa1, kappa2), quantity('gaussian').value(kappa1, kappa2)];
    expect(h * h - k).toBeCloseTo(((kappa1 - kappa2) / 2) ** 2, 12);
    expect(quantity('difference').value(kappa1, kappa2)).toBeCloseTo(2 * Math.sqrt(h * h - k), 12);
  });

  test('have a diverging map exactly when they have a sign', () => {
    for (const { signed, map } of quantities) expect(map).toBe(signed ? 'diverging' : 'sequential');
    expect(quantityOf('plain')).toBeNull();
  });

  test('are sampled without what is not finite', () => {
    const curvatures = Float32Array.from([1, 0, NaN, 0, Infinity, 2, 3, 1]);
    expect([...sampleValues(quantity('kappa1'), curvatures)]).toEqual([1, 3]);
  });

  test('are sampled from all over a large mesh', () => {
    const vertices = 100_000;
    const curvatures = Float32Array.from({ length: 2 * vertices }, (_, i) => Math.floor(i / 2));
    const values = sampleValues(quantity('kappa1'), curvatures);
    expect(values.length).toBeLessThanOrEqual(5000);
    expect(values[0]).toBe(0);
    expect(values[values.length - 1]).toBeGreaterThan(0.999 * (vertices - 1));
  });
});
