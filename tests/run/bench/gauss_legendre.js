// SPDX-License-Identifier: MIT
/**
 * @file The Gauss-Legendre rule, and Legendre's polynomials.
 */

/** P_0(x), ..., P_n(x), n >= 1. @param {number} n @param {number} x @returns {number[]} */
export function legendre(n, x) {
  const values = [1, x];
  for (let k = 2; k <= n; ++k) values.push(((2 * k - 1) * x * values[k - 1] - (k - 1) * values[k - 2]) / k);
  return values;
}

/**
 * Exact for polynomials of degree 2 n - 1 over [-1, 1]. Newton's method finds the zeros x of P_n; their weights are
 * 2 / ((1 - x²) P_n'(x)²).
 * @param {number} n
 * @returns {{ x: number, weight: number }[]}
 */
export function gaussLegendre(n) {
  return Array.from({ length: n }, (_, i) => {
    let x = Math.cos((Math.PI * (i + 0.75)) / (n + 0.5));
    let slope = NaN;
    for (let iteration = 0; iteration < 10; ++iteration) {
      const values = legendre(n, x);
      slope = (n * (x * values[n] - values[n - 1])) / (x * x - 1);
      x -= values[n] / slope;
    }
    return { x, weight: 2 / ((1 - x * x) * slope * slope) };
  });
}
