// SPDX-License-Identifier: MIT
/**
 * @file Runs of cages without symmetry to a wanted accuracy: frames of genus 2 and 3 whose points were moved, a cage with
 * the valences of an animal's, and a fish of which only the head is free; on one thread and on all.
 */
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import path from 'node:path';
import { root } from '../process.js';
import { benchText, timeReport } from './programs.js';
import { digits } from './tables.js';

/** @typedef {{ cage: string, functional: string, accuracy: string, threads: number, evaluations: number, metrics: number, levels: number, seconds: number, cpuSeconds: number, limit: string }} Row */

const cages = ['moved-two-3', 'moved-two-4', 'moved-tetrahedron-frame', 'animal'];
const functionals = ['bending', 'mvs_cross'];
const accuracies = ['draft', 'good', 'fine'];
const fish = path.join(root, 'web/samples/fish.obj');

/** @param {number[]} values */
const sum = (values) => values.reduce((one, other) => one + other, 0);

/** @returns {Row[]} */
export function measure() {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  try {
    const inputs = cages.map((cage) => {
      const file = path.join(folder, `${cage}.obj`);
      writeFileSync(file, benchText('cage', cage));
      return { cage, args: [file] };
    });
    inputs.push({ cage: 'fish, head free', args: [fish, '--hold', 'body'] });
    return inputs.flatMap((input) =>
      functionals.flatMap((functional) =>
        accuracies.flatMap((accuracy) =>
          [1, availableParallelism()].map((threads) => row(input, functional, accuracy, threads)),
        ),
      ),
    );
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {{cage: string, args: string[]}} input @param {string} functional @param {string} accuracy @param {number} threads @returns {Row} */
function row({ cage, args }, functional, accuracy, threads) {
  const asked = ['--functional', functional, '--accuracy', accuracy, '--threads', String(threads)];
  const { report, seconds, cpuSeconds } = timeReport([...args, ...asked]);
  const { levels, limit } = report;
  const evaluations = sum(levels.map((level) => level.evaluations));
  const metrics = sum(levels.map((level) => level.metrics));
  const counts = { evaluations, metrics, levels: levels.length };
  return { cage, functional, accuracy, threads, ...counts, seconds, cpuSeconds, limit: limit.status };
}

/** @param {Row[]} rows @returns {import('./tables.js').Table[]} */
export function tables(rows) {
  return [
    {
      title: 'Cages without symmetry, to an accuracy; metrics are Hessians, or Sobolev products for bending:',
      head: ['cage', 'functional', 'accuracy', 'threads', 'levels', 'evaluations', 'metrics', 's', 'CPU s', 'limit'],
      rows: rows.map((row) => [
        ...[row.cage, row.functional, row.accuracy, row.threads, row.levels, row.evaluations, row.metrics],
        ...[digits(row.seconds), digits(row.cpuSeconds), row.limit],
      ]),
    },
  ];
}

export const summary = tables;
