// SPDX-License-Identifier: MIT
/**
 * @file What all threads do together beside what as many independent processes would do, on a surface without symmetry.
 */
import { bench } from './programs.js';
import { digits, percent } from './tables.js';

/** Times per second: by one thread, by all threads each for itself, by all together. @typedef {{ work: string, patches: number, threads: number, alone: number, apart: number, together: number }} ThreadsRow */

/** @returns {ThreadsRow[]} */
export const measure = () => bench('native', 'threads');

/** @param {ThreadsRow[]} rows @returns {import('./tables.js').Table[]} */
export const tables = (rows) => [
  {
    title: `MVS_cross of the genus-2 frame with moved points, without symmetry: ${rows[0].threads} threads together, beside one, and beside ${rows[0].threads} that work each for itself`,
    head: ['patches', 'work', 'one thread, ms', 'together, ms', 'faster by', 'of what independent ones do'],
    rows: rows.map(({ patches, work, alone, apart, together }) => [
      ...[patches, work, digits(1000 / alone), digits(1000 / together)],
      ...[(together / alone).toFixed(2), percent(together / apart)],
    ]),
  },
];

/** @param {ThreadsRow[]} rows @returns {import('./tables.js').Table[]} */
export const summary = (rows) => {
  const works = [...new Set(rows.map(({ work }) => work))];
  const patches = [...new Set(rows.map((row) => row.patches))];
  return [
    {
      title: `${rows[0].threads} threads together, MVS_cross of the genus-2 frame without symmetry: how many times as fast as one (in brackets the part of what as many independent processes do):`,
      head: ['patches', ...works],
      rows: patches.map((count) => [
        count,
        ...works.map((work) => {
          const row = rows.find((other) => other.work === work && other.patches === count);
          return row ? `${(row.together / row.alone).toFixed(2)} (${percent(row.together / row.apart)})` : '';
        }),
      ]),
    },
  ];
};
