// SPDX-License-Identifier: MIT
/**
 * @file What a cage holds instead of a circle, and the least energies of surfaces that are clamped there.
 */
import { describe, expect, test } from '@jest/globals';
import { clampedCatenoid, clampedRevolution, clampedSphere, leastMeridian } from './clamped.js';
import { gaussLegendre } from './gauss_legendre.js';
import { heldCircle, rippleEnergy } from './held_circles.js';

const { PI, cos, sin, cosh, sinh, tanh } = Math;

test('a Gauss-Legendre rule of n points is exact up to degree 2 n - 1', () => {
  for (const n of [1, 2, 5, 16]) {
    const integral = (/** @type {number} */ k) =>
      gaussLegendre(n).reduce((sum, { x, weight }) => sum + weight * x ** k, 0);
    for (let k = 0; k < 2 * n; ++k) expect(integral(k)).toBeCloseTo(k % 2 ? 0 : 2 / (k + 1), 13);
    expect(Math.abs(integral(2 * n) - 2 / (2 * n + 1))).toBeGreaterThan(1e-13);
  }
});

describe('the spline through n points of a circle', () => {
  test('is nearer to the axis by step^4 / 720 in the mean, and by nothing at the points', () => {
    for (const around of [32, 64]) {
      const { distance, samples } = heldCircle(around, 0, 1);
      const step = (2 * PI) / around;
      expect(((1 - distance) * 720) / step ** 4).toBeCloseTo(1, 1);
      for (const sample of samples) expect(sample.distance).toBeLessThan(1);
      expect(samples.reduce((sum, { weight }) => sum + weight, 0)).toBeCloseTo(step, 13);
    }
  });

  test('keeps derivatives along the axis, and turns others by their radial part alone', () => {
    for (const degrees of [30, 60, 120]) {
      const angle = (degrees * PI) / 180;
      const held = heldCircle(32, cos(angle), sin(angle));
      const shorter = heldCircle(32, 0, 1).distance;
      expect(held.angle).toBeCloseTo(Math.atan2(sin(angle), cos(angle) * shorter), 8);
    }
    expect(heldCircle(16, 0, 1).angle).toBeCloseTo(PI / 2, 14);
  });

  test('turns by 2 pi in its plane, and by nothing across it', () => {
    expect(heldCircle(16, -1, 0).turning).toBeCloseTo(2 * PI, 12);
    expect(heldCircle(16, 1, 0).turning).toBeCloseTo(-2 * PI, 12);
    expect(heldCircle(16, 0, 1).turning).toBeCloseTo(0, 12);
  });

  test('ripples with an amplitude of 2 (step / 2 pi)^4, which costs pi / 2 n^3 times its square on a cylinder', () => {
    for (const around of [32, 64]) {
      // The error of cubic interpolation is step^4 t^2 (1 - t)^2 / 24, whose first cosine has 3 / pi^4.
      const amplitude = ((2 * PI) / around) ** 4 / 8 / PI ** 4;
      const first = (PI / 2) * around ** 3 * amplitude ** 2;
      const all = 1 + 2 ** -5 + 3 ** -5 + 4 ** -5;
      expect(rippleEnergy(heldCircle(around, 0, 1), 0) / first / all).toBeCloseTo(1, 1);
    }
  });

  test('does not leave a disk by its ripples', () => {
    expect(rippleEnergy(heldCircle(16, -1, 0), 0)).toBeCloseTo(0, 20);
  });
});

describe('a clamped meridian', () => {
  test.each([
    [0.3, 8.1443604],
    [0.5, 5.8607471],
    [1, 3.1239888],
    [2, 1.5702457],
  ])('of distance %d and slope 0 has at least %d, as shooting says', (radius, willmore) => {
    expect(leastMeridian(radius)).toBeCloseTo(willmore, 6);
    expect(leastMeridian(radius, 0, 1, 16)).toBeCloseTo(leastMeridian(radius), 8);
  });

  test('has nothing at a catenoid, and a zone of a sphere at that', () => {
    expect(leastMeridian(cosh(0.5), sinh(0.5), 0.5)).toBeCloseTo(0, 12);
    // x = sin, z = cos of an angle that begins and ends a sixth of a turn from the poles
    expect(leastMeridian(sin(PI / 3), -1 / Math.tan(PI / 3), cos(PI / 3))).toBeCloseTo(2 * PI * 2 * cos(PI / 3), 8);
  });
});

test('what is held tends to circles as the fourth power of the step', () => {
  /** @type {[(around: number) => number, number][]} */
  const truths = [
    [(around) => clampedRevolution(1, around).willmore, leastMeridian(1)],
    [(around) => clampedSphere(30, around).willmore, 2 * PI * (1 - cos(PI / 6))],
    [(around) => clampedSphere(150, around).bending, 4 * PI * (1 + cos(PI / 6))],
    [(around) => clampedCatenoid(1, around).bending, 8 * PI * tanh(0.5)],
  ];
  for (const [of, exact] of truths) {
    const [coarse, fine] = [of(64) - exact, of(128) - exact];
    expect(Math.log2(coarse / fine)).toBeCloseTo(4, 0);
    expect(Math.abs(coarse / exact)).toBeLessThan(3e-7);
  }
});
