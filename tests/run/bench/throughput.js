// SPDX-License-Identifier: MIT
/**
 * @file Evaluations of energy and gradient per second by instruction set, as a fraction of the peak, and the time of
 * each phase of a level.
 */
import { bench } from './programs.js';
import { percent } from './tables.js';

/** @typedef {{ instructionSet: string, flopsPerSecond: number }} Peak */
/** @typedef {{ instructionSet: string, functional: string, cap: string, patches: number, samples: number, samplesPerSecond: number, flopsPerSample: number, tableBytes: number }} Throughput */
/** @typedef {{ phase: string, seconds: number }} PhaseSeconds */
/** @typedef {{ peaks: Peak[], throughput: Throughput[], phases: PhaseSeconds[] }} Speed */
/** @typedef {{ name: string, peak: Peak, rows: Throughput[] }} Column */
/** @typedef {{ native: Speed, wasm: Speed }} Speeds */

const rounds = 3;

/** The best value of each measurement. @param {Speed[]} runs @returns {Speed} */
function best(runs) {
  return {
    peaks: runs[0].peaks.map((row, i) => ({
      ...row,
      flopsPerSecond: Math.max(...runs.map((run) => run.peaks[i].flopsPerSecond)),
    })),
    throughput: runs[0].throughput.map((row, i) => ({
      ...row,
      samplesPerSecond: Math.max(...runs.map((run) => run.throughput[i].samplesPerSecond)),
    })),
    phases: runs[0].phases.map((row, i) => ({
      ...row,
      seconds: Math.min(...runs.map((run) => run.phases[i].seconds)),
    })),
  };
}

/** @returns {Speeds} */
export function measure() {
  const runs = Array.from({ length: rounds }, () => ({
    native: bench('native', 'throughput'),
    wasm: bench('wasm', 'throughput'),
  }));
  return { native: best(runs.map((run) => run.native)), wasm: best(runs.map((run) => run.wasm)) };
}

/** @param {Speeds} speeds @returns {Column[]} portable first, WebAssembly last */
function columnsOf({ native, wasm }) {
  const column = (/** @type {Speed} */ speed, /** @type {Peak} */ peak, name = peak.instructionSet) => ({
    name,
    peak,
    rows: speed.throughput.filter((row) => row.instructionSet === peak.instructionSet),
  });
  return [
    ...native.peaks.map((peak) => column(native, peak)),
    ...wasm.peaks.map((peak) => column(wasm, peak, 'WebAssembly')),
  ];
}

/** @param {Throughput} row @param {Peak} peak */
const fraction = (row, peak) => percent((row.samplesPerSecond * row.flopsPerSample) / peak.flopsPerSecond);

/** @param {Speeds} speeds @returns {import('./tables.js').Table[]} */
export function tables(speeds) {
  const columns = columnsOf(speeds);
  const portable = columns[0].rows;
  const wasm = columns[columns.length - 1].rows;
  const names = columns.map(({ name }) => name);
  const { patches } = portable[0];
  return [
    {
      title: `Energy and gradient, genus-2 flag frame, level 3, ${patches} patches, one core: million samples/s, capped patches included`,
      head: ['functional', 'cap', 'samples', ...names, 'WebAssembly/portable', 'tables MB'],
      rows: portable.map((row, i) => [
        ...[row.functional, row.cap, row.samples],
        ...columns.map(({ rows }) => (rows[i].samplesPerSecond / 1e6).toFixed(2)),
        (wasm[i].samplesPerSecond / row.samplesPerSecond).toFixed(2),
        (row.tableBytes / 1e6).toFixed(2),
      ]),
    },
    {
      title: 'The same as a fraction of the measured peak of independent multiply-adds in registers',
      head: ['functional', 'cap', 'flops per sample', ...names],
      rows: [
        ...portable.map((row, i) => [
          ...[row.functional, row.cap, Math.round(row.flopsPerSample)],
          ...columns.map(({ peak, rows }) => fraction(rows[i], peak)),
        ]),
        ['peak, Gflop/s', '', '', ...columns.map(({ peak }) => (peak.flopsPerSecond / 1e9).toFixed(1))],
      ],
    },
    {
      title: 'Seconds per phase, MVS_cross, the same level',
      head: ['phase', 'native', 'WebAssembly', 'ratio'],
      rows: speeds.native.phases.map((row, i) => {
        const { seconds } = speeds.wasm.phases[i];
        return [row.phase, row.seconds.toFixed(5), seconds.toFixed(5), (row.seconds / seconds).toFixed(2)];
      }),
    },
  ];
}

/** @param {Speeds} speeds @returns {import('./tables.js').Table[]} */
export function summary(speeds) {
  const columns = columnsOf(speeds);
  const portable = columns[0].rows;
  const wasm = columns[columns.length - 1].rows;
  const shown = portable.map((_, i) => i).filter((i) => ['bending', 'mvs_cross'].includes(portable[i].functional));
  return [
    {
      title:
        'Energy and gradient, genus-2 frame at level 3, million samples/s (in brackets the fraction of the measured multiply-add peak):',
      head: ['functional', 'cap', ...columns.map(({ name }) => name), 'WebAssembly / portable'],
      rows: shown.map((i) => [
        portable[i].functional,
        `\`${portable[i].cap}\``,
        ...columns.map(
          ({ peak, rows }) => `${(rows[i].samplesPerSecond / 1e6).toFixed(1)} (${fraction(rows[i], peak)})`,
        ),
        (wasm[i].samplesPerSecond / portable[i].samplesPerSecond).toFixed(2),
      ]),
    },
  ];
}
