// SPDX-License-Identifier: MIT
/**
 * @file Complete runs from the catalog's cages to level 3 with symmetry, natively and as WebAssembly.
 */
import { benchRun } from './programs.js';
import { digits, reached } from './tables.js';

/** @typedef {import('./programs.js').RunRow} RunRow */
/** @typedef {{ seconds: number, secondsToTenthPercent: number, energy: number, evaluations: number[], metrics: string[], stops: string[] }} Timed */
/** @typedef {{ shape: string, functional: string, group: string, patches: number, native: Timed, wasm: Timed }} ShapeRow */

/** All frames of the catalog with at most six arms per junction, and the shapes without junctions. */
const shapes = [
  ...['two-3', 'two-4', 'two-6', 'tetrahedron-frame', 'cube-frame', 'octahedron-frame', 'hexagonal-prism-frame'],
  ...['truncated-tetrahedron-frame', 'dodecahedron-frame', 'torus', 'cube'],
];
const functionals = ['bending', 'mvs_cross'];

/** @param {RunRow} run @returns {Timed} */
function timed({ seconds, levels, steps }) {
  const { energy, energyReported } = levels[levels.length - 1];
  return {
    seconds,
    secondsToTenthPercent: reached(steps, energy, 1e-3)?.[0] ?? seconds,
    energy: energyReported,
    evaluations: levels.map((level) => level.evaluations),
    metrics: levels.map((level) => level.metric),
    stops: levels.map((level) => level.stop),
  };
}

/** @returns {ShapeRow[]} */
export function measure() {
  return shapes.flatMap((cage) =>
    functionals.map((functional) => {
      const choice = { cage, functional, lastLevel: 3, metric: 'auto', symmetry: /** @type {const} */ ('symmetric') };
      const [native, wasm] = [benchRun('native', choice), benchRun('wasm', choice, 2)];
      const { patches } = native.levels[native.levels.length - 1];
      return { shape: cage, functional, group: native.group, patches, native: timed(native), wasm: timed(wasm) };
    }),
  );
}

/** Ratios of the evaluations of successive levels. @param {number[]} evaluations */
const growth = (evaluations) => evaluations.slice(1).map((count, i) => (count / evaluations[i]).toFixed(1));

/** A single name if all are the same. @param {string[]} names */
const joined = (names) => (new Set(names).size === 1 ? names[0] : names.join('/'));

const clock = 'seconds since the start of the run, setup included';
const meaning =
  'to 0.1 %: from then on the energy by the minimizing rule stays within 0.1 % of that at the end of level 3';

/** @param {ShapeRow[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: `Cage to level 3 with symmetry, ${clock}; ${meaning}`,
      head: [
        ...['shape', 'functional', 'group', 'patches', 'energy', 'native to 0.1 %', 'to the end'],
        ...['WebAssembly to 0.1 %', 'to the end', 'evaluations', 'growth', 'metric', 'stop'],
      ],
      rows: rows.map(({ native, wasm, ...row }) => [
        ...[row.shape, row.functional, row.group, row.patches, native.energy.toPrecision(6)],
        ...[native, wasm].flatMap((run) => [digits(run.secondsToTenthPercent), digits(run.seconds)]),
        native.evaluations.join('/'),
        growth(native.evaluations).join('/'),
        joined(native.metrics),
        joined(native.stops),
      ]),
    },
  ];
}

/** @param {ShapeRow[]} rows @returns {import('./tables.js').Table[]} */
export function summary(rows) {
  return [
    {
      title: `From the cage to level 3 with symmetry, ${clock}; ${meaning}:`,
      head: [
        ...['shape', 'functional', 'patches', 'evaluations per level', 'native: to 0.1 %', 'end'],
        ...['WebAssembly: to 0.1 %', 'end', 'last level'],
      ],
      rows: rows.map(({ native, wasm, ...row }) => [
        ...[row.shape, row.functional, row.patches, native.evaluations.join(', ')],
        ...[native, wasm].flatMap((run) => [digits(run.secondsToTenthPercent), digits(run.seconds)]),
        native.stops[native.stops.length - 1],
      ]),
    },
  ];
}
