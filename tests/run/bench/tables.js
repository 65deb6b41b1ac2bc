// SPDX-License-Identifier: MIT
/**
 * @file Turns measurements of the benchmark into tables for the terminal and its README, exponents, and times to an
 * accuracy.
 */

/** @typedef {string | number} Cell */
/** @typedef {{ title: string, head: string[], rows: Cell[][] }} Table */
/** @typedef {[seconds: number, cpuSeconds: number, energy: number]} Step of a run: after an evaluation or a part of a metric */

/** A table as text. Columns are padded to their widest cell; the first is aligned to the left. @param {Table} table @returns {string} */
export function plainTable({ title, head, rows }) {
  const cells = [head, ...rows].map((row) => row.map(String));
  const widths = head.map((_, i) => Math.max(...cells.map((row) => row[i].length)));
  const lines = cells.map((row) =>
    row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '),
  );
  return `${title}\n\n${lines.join('\n')}\n`;
}

/** @param {Table} table @returns {string} */
export function markdownTable({ title, head, rows }) {
  const line = (/** @type {Cell[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [`${title}\n`, line(head), `|${head.map(() => '---').join('|')}|`, ...rows.map(line)].join('\n') + '\n';
}

/**
 * The exponent p of y = c x^p, by least squares of the logarithms.
 * @param {number[]} xs > 0, not all the same
 * @param {number[]} ys > 0
 * @returns {number}
 */
export function fitExponent(xs, ys) {
  const mean = (/** @type {number[]} */ values) => values.reduce((a, b) => a + b, 0) / values.length;
  const [u, v] = [xs.map(Math.log), ys.map(Math.log)];
  const [middleU, middleV] = [mean(u), mean(v)];
  const covariance = mean(u.map((x, i) => (x - middleU) * (v[i] - middleV)));
  return covariance / mean(u.map((x) => (x - middleU) ** 2));
}

/**
 * The first step after which the energy stays within a relative `tolerance` of `target`; undefined if the last step
 * does not.
 * @param {Step[]} steps
 * @param {number} target
 * @param {number} tolerance
 * @returns {Step | undefined}
 */
export function reached(steps, target, tolerance) {
  const off = steps.findLastIndex(([, , energy]) => !(Math.abs(energy - target) <= tolerance * Math.abs(target)));
  return steps[off + 1];
}

/**
 * Replaces the text between two lines.
 * @param {string} text
 * @param {string} begin the line before, which stays
 * @param {string} end the line after, which stays
 * @param {string} inner without a line break at its end
 * @returns {string}
 */
export function replaceBetween(text, begin, end, inner) {
  const [first, last] = [text.indexOf(begin), text.indexOf(end)];
  if (first < 0 || last < first) throw new Error(`expected the lines ${begin} and ${end}`);
  return `${text.slice(0, first + begin.length)}\n${inner}\n${text.slice(last)}`;
}

/** Three digits. @param {number} seconds */
export const digits = (seconds) => (seconds >= 100 ? seconds.toFixed(0) : seconds.toPrecision(3));

/** @param {number} fraction */
export const percent = (fraction) => `${(100 * fraction).toFixed(0)} %`;
