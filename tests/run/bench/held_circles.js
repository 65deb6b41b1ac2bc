// SPDX-License-Identifier: MIT
/**
 * @file What an open cage of revolution holds at its boundary instead of a circle and the tangents there, and what this
 * makes of a clamped surface's energy.
 *
 * Position is held as the uniform cubic B-spline s through n points of the circle, and the derivative across the boundary
 * as the spline of the same kind (core/driver/boundary_rows.h): of the unit circle, and of a derivative with the radial
 * and axial parts d_r and d_z, these are s(t) and (d_r s(t), d_z). The distance from the axis and the angle of the
 * conormal ripple around the boundary, n times.
 *
 * The first variation of the energy of a minimizer of revolution has coefficients that are constant along the boundary.
 * So to first order what counts is the mean distance and the mean angle: the spline's minimum is that of the surface of
 * revolution that is clamped at these.
 *
 * Of second order the ripples remain, which die out within 1/n of the boundary. There the surface is nearly flat, and
 * what they cost nearly the least ¼ ∫ (Δu)² of normal displacements u = ν cos nφ on a circle of radius 1, with the
 * derivative ω cos nφ inward: in a disk (A r^n + B r^(n+2)) cos nφ has π/2 (n + 1) (n ν + ω)², outside of one it is
 * n - 1, on a cylinder n; so for a boundary of geodesic curvature γ it is n + γ. What is neglected is smaller by 1/n.
 */
import { gaussLegendre } from './gauss_legendre.js';

const { PI, cos, sin, hypot, atan2 } = Math;

/** The control points' weights in a uniform cubic B-spline over [0, 1] and its first two derivatives. @param {number} t */
const bases = (t) => {
  const s = 1 - t;
  return [
    [s ** 3 / 6, (3 * t ** 3 - 6 * t ** 2 + 4) / 6, (3 * s ** 3 - 6 * s ** 2 + 4) / 6, t ** 3 / 6],
    [-(s ** 2) / 2, (3 * t ** 2 - 4 * t) / 2, (4 * s - 3 * s ** 2) / 2, t ** 2 / 2],
    [s, 3 * t - 2, 3 * s - 2, t],
  ];
};

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** `a` without its part along the unit vector b. @param {number[]} a @param {number[]} b */
function across(a, b) {
  const along = dot(a, b);
  return a.map((value, i) => value - along * b[i]);
}

/** @typedef {{ angle: number, polar: number, distance: number, weight: number }} Sample polar weights sum up to 2 pi / n */
/**
 * @typedef {object} HeldCircle
 * @property {number} around
 * @property {number} distance mean over the polar angle, from the axis
 * @property {number} angle mean of the inward conormal's, from the radial to the axial direction
 * @property {number} turning the boundary's integral of its geodesic curvature
 * @property {Sample[]} samples of one of its n equal parts
 */

/**
 * Where a circle of radius 1 is held through `around` points, with the derivative (radial, axial) inward.
 * @param {number} around
 * @param {number} radial
 * @param {number} axial
 * @returns {HeldCircle}
 */
export function heldCircle(around, radial, axial) {
  const step = (2 * PI) / around;
  const control = 6 / (4 + 2 * cos(step)); // so that the spline passes through the circle's points
  const points = [-1, 0, 1, 2].map((i) => [control * cos(i * step), control * sin(i * step), 0]);
  const combined = (/** @type {number[]} */ weights) =>
    [0, 1, 2].map((axis) => weights.reduce((sum, weight, i) => sum + weight * points[i][axis], 0));
  let turning = 0;
  const samples = gaussLegendre(16).map(({ x, weight }) => {
    const [at, first, second] = bases((x + 1) / 2).map(combined);
    const speed = hypot(...first);
    const tangent = first.map((value) => value / speed);
    const distance = hypot(...at);
    const outward = at.map((value) => value / distance);
    const inner = across([radial * at[0], radial * at[1], axial], tangent);
    const conormal = inner.map((value) => value / hypot(...inner));
    const polarSpeed = (at[0] * first[1] - at[1] * first[0]) / distance ** 2;
    turning += ((around * weight) / 2) * (dot(second, conormal) / speed);
    return {
      angle: atan2(conormal[2], dot(conormal, outward)),
      polar: atan2(at[1], at[0]),
      distance,
      weight: (polarSpeed * weight) / 2,
    };
  });
  const mean = (/** @type {(sample: Sample) => number} */ of) =>
    samples.reduce((sum, sample) => sum + of(sample) * sample.weight, 0) / step;
  return { around, distance: mean((s) => s.distance), angle: mean((s) => s.angle), turning, samples };
}

/** Higher ones cost less than a thousandth of the first: amplitudes fall as the fourth power. */
const kHarmonics = 4;

/**
 * The Willmore energy of the ripples.
 * @param {HeldCircle} held
 * @param {number} meridian the meridian's curvature times the boundary's distance from the axis: positive where it bends to
 * the side that a quarter turn from the axial to the radial direction takes the conormal to
 */
export function rippleEnergy(held, meridian) {
  const { around, distance, angle, samples } = held;
  const [radial, axial] = [cos(angle), sin(angle)];
  let energy = 0;
  for (let k = 1; k <= kHarmonics; ++k) {
    const n = k * around;
    const amplitude = (/** @type {(sample: Sample) => number} */ of) =>
      samples.reduce((sum, s) => sum + (around / PI) * s.weight * of(s) * cos(n * s.polar), 0);
    const outward = amplitude((s) => (s.distance - distance) / distance);
    const turned = -amplitude((s) => s.angle - angle);
    const slope = turned - meridian * outward * radial; // at a point that moved inward, the surface itself has turned
    energy += (PI / 2) * (n - radial) * (n * outward * axial + slope) ** 2;
  }
  return energy;
}
