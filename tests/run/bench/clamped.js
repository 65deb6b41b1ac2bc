// SPDX-License-Identifier: MIT
/**
 * @file The least energies of open surfaces of revolution that are clamped at what their cages hold (held_circles.js), by
 * formulas and by the spectral minimization of a meridian.
 */
import { gaussLegendre, legendre } from './gauss_legendre.js';
import { heldCircle, rippleEnergy } from './held_circles.js';
import { minimum } from './minimum.js';

const { PI, cos, sin, cosh, tanh } = Math;

/** @typedef {{ willmore: number, bending: number, doubt: number }} Least the doubt of `willmore` */

/**
 * The Willmore energy of surfaces of revolution over z in [-half, half] with a mirror, of which distance and slope are
 * given at z = half. The distance from the axis is the parabola with these and a sum of polynomials whose second
 * derivatives are the orthonormal Legendre polynomials of degree 2, 4, ..., which with their first derivatives are 0 at
 * the ends. Willmore's energy does not depend on size, so `half` is taken for the unit.
 * @param {number} distance
 * @param {number} slope
 * @param {number} half
 * @param {number} terms
 * @returns {(coefficients: number[]) => number}
 */
function meridianEnergy(distance, slope, half, terms) {
  const samples = gaussLegendre(5 * terms).map(({ x, weight }) => {
    const p = legendre(2 * terms + 2, x);
    const basis = Array.from({ length: terms }, (_, i) => {
      const k = 2 * i + 2;
      const norm = Math.sqrt(k + 0.5);
      const [below, above] = [2 * k - 1, 2 * k + 3];
      const integral = (p[k + 2] - p[k]) / ((2 * k + 1) * above) - (p[k] - p[k - 2]) / (below * (2 * k + 1));
      return [integral, (p[k + 1] - p[k - 1]) / (2 * k + 1), p[k]].map((value) => norm * value);
    });
    return { x, weight, basis };
  });
  return (coefficients) => {
    let energy = 0;
    for (const { x, weight, basis } of samples) {
      let [r, r1, r2] = [distance / half + (slope * (x * x - 1)) / 2, slope * x, slope];
      coefficients.forEach((c, i) => {
        r += c * basis[i][0];
        r1 += c * basis[i][1];
        r2 += c * basis[i][2];
      });
      const length = Math.hypot(1, r1);
      const mean = (1 / (r * length) - r2 / length ** 3) / 2;
      energy += weight * mean ** 2 * 2 * PI * r * length;
    }
    return energy;
  };
}

/**
 * The least of these.
 * @param {number} distance
 * @param {number} [slope]
 * @param {number} [half]
 * @param {number} [terms]
 */
export function leastMeridian(distance, slope = 0, half = 1, terms = 12) {
  const start = Array.from({ length: terms }, () => 0);
  return minimum(
    meridianEnergy(distance, slope, half, terms),
    start,
    start.map(() => 1 / (4 * PI * distance)),
  ).value;
}

/**
 * With the ripples of `boundaries` alike. By Gauss and Bonnet the integral of K is 2 pi times the Euler characteristic
 * less the boundary's turning, so that bending = 4 willmore - 2 ∫ K is least where willmore is.
 * @param {number} smooth the least Willmore energy without ripples
 * @param {import('./held_circles.js').HeldCircle} held
 * @param {number} meridian
 * @param {number} boundaries
 * @returns {Least}
 */
function least(smooth, held, meridian, boundaries) {
  const ripples = boundaries * rippleEnergy(held, meridian);
  const willmore = smooth + ripples;
  const gaussian = 2 * PI * (2 - boundaries) - boundaries * held.turning;
  return { willmore, bending: 4 * willmore - 2 * gaussian, doubt: ripples / held.around };
}

/** Between two circles at z = ±1, tangents along the axis. @param {number} radius @param {number} around */
export function clampedRevolution(radius, around) {
  const held = heldCircle(around, 0, 1);
  // Ripples along the normal alone: the meridian's curvature does not matter.
  return least(leastMeridian(radius * held.distance), held, 0, 2);
}

/** Within a cone of this half-angle from the sphere's centre. @param {number} degrees @param {number} around */
export function clampedSphere(degrees, around) {
  const angle = (degrees * PI) / 180;
  const held = heldCircle(around, -cos(angle), sin(angle));
  return least(2 * PI * (1 + cos(held.angle)), held, -sin(held.angle), 1);
}

/** Waist 1. Its Willmore energy is 0, and of second order where distance and angle change. @param {number} height @param {number} around */
export function clampedCatenoid(height, around) {
  const held = heldCircle(around, -tanh(height / 2), 1 / cosh(height / 2));
  return least(0, held, sin(held.angle), 2);
}
