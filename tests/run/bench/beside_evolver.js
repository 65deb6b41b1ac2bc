// SPDX-License-Identifier: MIT
/**
 * @file Compares umbilic with schedules of Surface Evolver on the same surface, the genus-2 bending minimizer, on one
 * core.
 */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { evolverInstalled, evolverMissing, evolverTable, exactBending, runEvolver } from '../evolver.js';
import { output } from '../process.js';
import { benchRun, timeUmbilic } from './programs.js';
import { digits, reached } from './tables.js';

/** @typedef {{ seconds: number, cpuSeconds: number }} Times */
/**
 * @typedef {object} UmbilicRow
 * @property {'whole' | 'sector'} domain 'sector': umbilic uses the symmetry, as Evolver does with a sector
 * @property {Times | null} tenthPercent from the start of the run, with the process's CPU time
 * @property {Times | null} twentiethPercent 0.05 %
 * @property {Times} process of `umbilic optimize` to level 2, from its start to its end
 * @property {number} energy at the end
 * @property {number} vertices at the end
 */
/** @typedef {{ umbilic: UmbilicRow[], evolver: import('../evolver.js').EvolverRow[] | null }} Both */

const lastLevel = 2;

/** @param {'whole' | 'sector'} domain @param {string} cage file @returns {UmbilicRow} */
function umbilicRow(domain, cage) {
  const symmetry = domain === 'whole' ? 'unsymmetric' : 'symmetric';
  const run = benchRun('native', { cage: 'two-3', functional: 'bending', lastLevel, metric: 'auto', symmetry }, 5);
  const at = (/** @type {number} */ tolerance) => {
    const step = reached(run.steps, exactBending, tolerance);
    return step ? { seconds: step[0], cpuSeconds: step[1] } : null;
  };
  const last = run.levels[run.levels.length - 1];
  return {
    domain,
    tenthPercent: at(1e-3),
    twentiethPercent: at(5e-4),
    process: timeUmbilic([
      ...['optimize', cage, '--functional', 'bending', '--levels', `0..${lastLevel}`, '--quiet'],
      ...(domain === 'whole' ? ['--no-symmetry'] : []),
    ]),
    energy: last.energyReported,
    vertices: last.patches - 2, // Euler's formula for a closed quad mesh of genus 2
  };
}

/** @returns {Promise<Both>} */
export async function measure() {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  try {
    const cage = path.join(folder, 'two-3.obj');
    if (output('build/native/umbilic', ['cage', 'two-3', '-o', cage]) === undefined) throw new Error('no cage');
    const umbilic = [umbilicRow('sector', cage), umbilicRow('whole', cage)];
    if (!evolverInstalled()) {
      console.error(evolverMissing);
      return { umbilic, evolver: null };
    }
    return { umbilic, evolver: await runEvolver({ log: console.error }) };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {UmbilicRow[]} umbilic @param {string} domain */
const ofDomain = (umbilic, domain) => /** @type {UmbilicRow} */ (umbilic.find((row) => row.domain === domain));

/** Evolver's CPU time to 0.1 % for each of umbilic's. @param {Both} both @returns {import('./tables.js').Cell[][]} */
function ratios({ umbilic, evolver }) {
  return (evolver ?? []).map((row) => {
    const own = ofDomain(umbilic, row.domain);
    const [at, here] = [row.tenthPercent, own.tenthPercent];
    const named = [row.domain, row.schedule, row.quantity.replace('_sq_mean_curvature', '')];
    if (!at || !here) return [...named, 'never', '', ''];
    const [cpu, wall] = [at.cpuSeconds / here.cpuSeconds, at.seconds / own.process.seconds];
    return [...named, digits(at.cpuSeconds), cpu.toPrecision(2), wall.toPrecision(2)];
  });
}

/** @param {Both} both @returns {import('./tables.js').Table[]} */
export function tables(both) {
  const times = (/** @type {Times | null} */ at) => (at ? [digits(at.seconds), digits(at.cpuSeconds)] : ['never', '']);
  const own = {
    title: `umbilic on the genus-2 bending minimizer, ${exactBending}, cage to level ${lastLevel}: in the run (CPU: process), and all of \`umbilic optimize\``,
    head: [
      ...['domain', 'to 0.1 %: s', 'CPU s', 'to 0.05 %: s', 'CPU s'],
      ...['whole process: s', 'CPU s', 'vertices', 'energy', 'error'],
    ],
    rows: both.umbilic.map((row) => [
      row.domain === 'sector' ? 'with symmetry' : 'whole',
      ...[row.tenthPercent, row.twentiethPercent, row.process].flatMap(times),
      ...[row.vertices, row.energy.toFixed(4), `${(100 * (row.energy / exactBending - 1)).toFixed(3)} %`],
    ]),
  };
  if (!both.evolver) return [own];
  const { head, cells } = evolverTable(both.evolver);
  return [
    own,
    { title: 'Surface Evolver: 4 W + 8 pi = 112.7668; best of three, one core', head, rows: cells },
    {
      title: "Evolver's time for each of umbilic's, a sector beside umbilic with symmetry",
      head: ['domain', 'schedule', 'quantity', 'to 0.1 %: CPU s', 'CPU to 0.1 %', "wall to 0.1 % / umbilic's process"],
      rows: ratios(both),
    },
  ];
}

/** @param {Both} both @returns {import('./tables.js').Table[]} */
export function summary(both) {
  const rows = ratios(both).map(([domain, schedule, , cpu, ratio]) => [domain, `Evolver: ${schedule}`, cpu, ratio]);
  const own = both.umbilic.map((row) => [
    ...[row.domain, row.domain === 'sector' ? 'umbilic, with symmetry' : 'umbilic'],
    ...[row.tenthPercent ? digits(row.tenthPercent.cpuSeconds) : 'never', '1'],
  ]);
  const all = [...own, ...rows];
  return [
    {
      title: `CPU seconds to within 0.1 % of the genus-2 bending minimum, ${exactBending}, process start included (Evolver's schedules are the best of some 2000, chosen with the answer known):`,
      head: ['domain', 'program and schedule', 'CPU s', "for each of umbilic's"],
      rows: ['sector', 'whole'].flatMap((domain) => all.filter((row) => row[0] === domain)),
    },
  ];
}
