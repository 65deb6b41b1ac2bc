// SPDX-License-Identifier: MIT
/**
 * @file The minimum of a smooth function of few variables.
 */

/**
 * The minimum of f near `start` by BFGS with central differences.
 * @param {(x: number[]) => number} f
 * @param {number[]} start
 * @param {number[]} scales about the inverse of each variable's second derivative
 * @returns {{ value: number, x: number[] }}
 */
export function minimum(f, start, scales) {
  const n = start.length;
  const gradient = (/** @type {number[]} */ x) =>
    x.map((_, i) => {
      const h = 1e-5;
      const moved = (/** @type {number} */ s) => f(x.map((value, j) => (j === i ? value + s * h : value)));
      return (8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * h);
    });
  const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    a.reduce((sum, value, i) => sum + value * b[i], 0);
  const inverse = start.map((_, i) => start.map((__, j) => (i === j ? scales[i] : 0)));
  let [x, value, slope] = [start, f(start), gradient(start)];
  for (let iteration = 0; iteration < 2000; ++iteration) {
    const direction = inverse.map((row) => -dot(row, slope));
    const descent = dot(direction, slope);
    if (!(descent < -1e-13 * Math.abs(value))) break;
    let length = 1;
    let next = x;
    let nextValue = NaN;
    for (; length > 1e-12; length /= 2) {
      next = x.map((v, i) => v + length * direction[i]);
      nextValue = f(next);
      if (nextValue <= value + 1e-4 * length * descent) break;
    }
    if (length <= 1e-12) break;
    const nextSlope = gradient(next);
    const s = next.map((v, i) => v - x[i]);
    const y = nextSlope.map((v, i) => v - slope[i]);
    const sy = dot(s, y);
    if (sy > 0) {
      const hy = inverse.map((row) => dot(row, y));
      const factor = (1 + dot(y, hy) / sy) / sy;
      for (let i = 0; i < n; ++i)
        for (let j = 0; j < n; ++j) inverse[i][j] += factor * s[i] * s[j] - (hy[i] * s[j] + s[i] * hy[j]) / sy;
    }
    [x, value, slope] = [next, nextValue, nextSlope];
  }
  return { value, x };
}
