// SPDX-License-Identifier: MIT
/**
 * @file Whether limits and error bars hold the truth where it is known: runs every problem of known_limits.js with the
 * command line, and leaves none out of the table.
 */
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { root } from '../process.js';
import { knownLimits } from './known_limits.js';

/** @typedef {import('../../../wasm/types.js').Limit} Limit */
/**
 * @typedef {object} LimitRow
 * @property {string} what
 * @property {string} cage
 * @property {string} cap
 * @property {string} functional
 * @property {string} levels that could be evaluated
 * @property {number} truth
 * @property {number} doubt
 * @property {Limit['status'] | 'failed'} status
 * @property {number | null} value the limit, or the least level's energy where there is none
 * @property {number | null} bar null where there is no limit
 * @property {number | null} lower what the limit is not below
 * @property {number} seconds
 * @property {string} [message] of a run that failed
 * @property {LimitRow} [usual] with the usual tolerance, where the row has another
 */

const built = path.join(root, 'build/native/umbilic');

/** @param {Record<string, number>} terms */
const sum = (terms) =>
  Object.entries(terms)
    .map(([name, weight]) => (weight === 1 ? name : `${weight} ${name}`))
    .join(' + ');

/** @param {string} program @param {import('./known_limits.js').Known} known @returns {LimitRow} */
function measured(program, { what, truth, doubt, cage, problem }) {
  const { cap = 'smooth' } = problem.options ?? {};
  const begin = performance.now();
  const args = ['optimize', '-', '--report', '-', '--quiet'];
  const { stdout, stderr } = spawnSync(program, args, {
    input: JSON.stringify(problem),
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  const seconds = (performance.now() - begin) / 1000;
  const row = { what, cage, cap, functional: sum(problem.terms), truth, doubt, seconds };
  if (!stdout)
    return { ...row, levels: '', status: 'failed', value: null, bar: null, lower: null, message: stderr.trim() };
  const { levels, limit } = JSON.parse(stdout);
  const evaluable = levels.filter((/** @type {any} */ level) => level.evaluable);
  const { status, energy, error, lower } = limit;
  const numbers = evaluable.map((/** @type {any} */ level) => level.level);
  return { ...row, levels: `${numbers[0]} to ${numbers.at(-1)}`, status, value: energy, bar: error, lower };
}

/** @param {string} [program] the command line @returns {LimitRow[]} */
export function measure(program = built) {
  return knownLimits.map((known, i) => {
    const row = measured(program, known);
    const { tolerance, ...options } = known.problem.options ?? {};
    if (tolerance) row.usual = measured(program, { ...known, problem: { ...known.problem, options } });
    process.stderr.write(
      `${i + 1}/${knownLimits.length} ${row.what}, ${row.cage}: ${verdict(row)} (${row.seconds.toFixed(1)} s)\n`,
    );
    return row;
  });
}

/** How far the value is from the truth, beyond what is not known of that itself. @param {LimitRow} row */
const off = ({ value, truth, doubt }) => Math.max(0, Math.abs(/** @type {number} */ (value) - truth) - doubt);

/** @param {LimitRow} row @returns {row is LimitRow & { value: number, bar: number }} */
const hasBar = (row) => row.status === 'converging' && row.bar !== null;

/** @param {LimitRow & { bar: number }} row */
const inside = (row) => off(row) <= row.bar;

/** @param {LimitRow} row */
function verdict(row) {
  if (row.status === 'failed') return row.message ?? 'failed';
  if (!hasBar(row)) return row.status.replaceAll('_', ' ');
  return inside(row) ? 'yes' : '**no**';
}

/** @param {number | null} x @param {number} [digits] */
const short = (x, digits = 2) => (x === null ? '' : x === 0 ? '0' : x.toPrecision(digits));

/** @param {number[]} values */
function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length / 2;
  return (sorted[Math.floor(middle - 0.25)] + sorted[Math.floor(middle)]) / 2;
}

/** Whether the true error is known: not where it is less than what is not known of the truth. @param {LimitRow} row */
const tellsError = (row) => row.doubt === 0 || off(row) > 0;

/** What rows say together. @param {LimitRow[]} rows */
function held(rows) {
  const bars = rows.filter(hasBar);
  const known = bars.filter(tellsError);
  const ratio = median(known.map((row) => (off(row) === 0 ? Infinity : row.bar / off(row))));
  return (
    `${bars.length} have a bar, and ${bars.filter(inside).length} of these hold the truth. ` +
    `The median of bar / true error is ${ratio.toPrecision(2)}, of the ${known.length} whose error is known.`
  );
}

/** @param {LimitRow[]} rows @returns {string} */
export function conclusion(rows) {
  const usual = rows.map((row) => row.usual ?? row);
  return `${rows.length} rows; ${held(rows)} All with the usual tolerance: ${held(usual)}`;
}

/** @param {LimitRow[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: conclusion(rows),
      head: ['what', 'cage', 'cap', 'functional', 'levels', 'value', 'bar', 'truth', 'off', 'off / bar', 'inside?'],
      rows: rows.map((row) => [
        ...[row.what, row.cage, row.cap, row.functional, row.levels, short(row.value, 9), short(row.bar)],
        ...[short(row.truth, 9), row.value === null ? '' : short(off(row))],
        hasBar(row) ? short(off(row) / row.bar) : '',
        verdict(row),
      ]),
    },
  ];
}

export const summary = tables;
