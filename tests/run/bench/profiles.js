// SPDX-License-Identifier: MIT
/**
 * @file Closed surfaces of revolution of genus 1 of least energy, by the spectral minimization of their profile. It knows
 * nothing of meshes: the profile is a Fourier series, its integrals are sums over equal steps, which converge as fast as
 * the series does.
 *
 * A profile (r(t), z(t)) with a mirror has r = sum a_k cos k t and z = sum b_k sin k t. With v = |(r', z')| its curvature
 * is N / v^3, N = r' z'' - z' r'', and that around the axis z' / (r v). Both change along the profile only.
 */
import { minimum } from './minimum.js';

const { PI } = Math;

/** @typedef {{ bending: number, mvs_cross: number }} Energies */

/**
 * The energies of profiles with `terms` terms.
 * @param {number} terms
 * @returns {(coefficients: number[]) => Energies} of a_0, ..., a_terms, b_1, ..., b_terms
 */
export function profileEnergies(terms) {
  const steps = 8 * terms;
  const waves = Array.from({ length: steps }, (_, i) =>
    Array.from({ length: terms + 1 }, (__, k) => {
      const angle = (2 * PI * k * (i + 0.5)) / steps;
      return [Math.cos(angle), Math.sin(angle)];
    }),
  );
  return (c) => {
    let [area, bending, variation] = [0, 0, 0];
    for (const wave of waves) {
      let [r, r1, r2, r3, z1, z2, z3] = [c[0], 0, 0, 0, 0, 0, 0];
      for (let k = 1; k <= terms; ++k) {
        const [cosine, sine] = wave[k];
        const [a, b] = [c[k], c[terms + k]];
        r += a * cosine;
        r1 -= k * a * sine;
        r2 -= k * k * a * cosine;
        r3 += k ** 3 * a * sine;
        z1 += k * b * cosine;
        z2 -= k * k * b * sine;
        z3 -= k ** 3 * b * cosine;
      }
      const v = Math.hypot(r1, z1);
      const v1 = (r1 * r2 + z1 * z2) / v;
      const n = r1 * z2 - z1 * r2;
      const along = n / v ** 3;
      const around = z1 / (r * v);
      const alongSlope = (r1 * z3 - z1 * r3) / v ** 4 - (3 * n * v1) / v ** 5;
      const aroundSlope = z2 / (r * v * v) - (z1 * (r1 * v + r * v1)) / (r * r * v ** 3);
      const element = ((2 * PI) / steps) * 2 * PI * r * v;
      area += element;
      bending += element * (along ** 2 + around ** 2);
      variation += element * (alongSlope ** 2 + aroundSlope ** 2);
    }
    return { bending, mvs_cross: area * variation };
  };
}

/**
 * The least weighted sum, from a torus whose tube is a circle.
 * @param {Energies} weights
 * @param {number} [terms]
 * @param {number} [ratio] of that torus
 */
export function leastProfile(weights, terms = 12, ratio = 0.5) {
  const energies = profileEnergies(terms);
  const start = Array.from({ length: 2 * terms + 1 }, (_, i) =>
    i === 0 ? 1 / ratio : i === 1 || i === terms + 1 ? 1 : 0,
  );
  // The curvature of high frequencies grows with the sixth power; these are short steps for them to begin with.
  const scales = start.map((_, i) => 1e-3 / (1 + (i <= terms ? i : i - terms) ** 4));
  const energy = (/** @type {number[]} */ c) => {
    const { bending, mvs_cross } = energies(c);
    return weights.bending * bending + weights.mvs_cross * mvs_cross;
  };
  return minimum(energy, start, scales);
}
