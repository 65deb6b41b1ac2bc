// SPDX-License-Identifier: MIT
/**
 * @file The cost of L-BFGS itself, measured on a quadratic function with the identity metric.
 */
import { bench } from './programs.js';

/** @typedef {{ unknowns: number, memory: number, secondsPerIteration: number }} Overhead */
/** @typedef {{ native: Overhead[], wasm: Overhead[] }} Overheads */

/** @returns {Overheads} */
export function measure() {
  return { native: bench('native', 'overhead'), wasm: bench('wasm', 'overhead') };
}

/** @param {Overhead} row @returns {number} */
const nanoseconds = ({ unknowns, memory, secondsPerIteration }) => (1e9 * secondsPerIteration) / (unknowns * memory);

/** @param {Overheads} rows @returns {import('./tables.js').Table[]} */
export function tables({ native, wasm }) {
  return [
    {
      title: `L-BFGS beside evaluation and metric, memory ${native[0].memory}: an iteration, and ns per unknown and pair`,
      head: ['unknowns', 'native µs', 'ns', 'WebAssembly µs', 'ns'],
      rows: native.map((row, i) => [
        row.unknowns,
        ...[row, wasm[i]].flatMap((each) => [
          (1e6 * each.secondsPerIteration).toFixed(1),
          nanoseconds(each).toFixed(2),
        ]),
      ]),
    },
  ];
}

/** @param {Overheads} rows @returns {import('./tables.js').Table[]} */
export function summary({ native, wasm }) {
  return [
    {
      title: `L-BFGS beside evaluations and metric, memory ${native[0].memory}, ns per unknown and curvature pair:`,
      head: ['unknowns', ...native.map((row) => String(row.unknowns))],
      rows: [
        ['native', ...native.map((row) => nanoseconds(row).toFixed(2))],
        ['WebAssembly', ...wasm.map((row) => nanoseconds(row).toFixed(2))],
      ],
    },
  ];
}
