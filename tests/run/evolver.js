// SPDX-License-Identifier: MIT
/**
 * @file Measures Surface Evolver on the genus-2 bending minimizer (`npm run bench -- evolver`), one schedule at a time
 * on one core.
 */
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { datafile } from '../bench/evolver/datafile.js';
import { schedules as allSchedules, vocabulary } from '../bench/evolver/schedules.js';

/** @typedef {import('../bench/evolver/schedules.js').Schedule} Schedule */
/**
 * @typedef {object} Step a line that Evolver printed
 * @property {number} willmore the integral of H^2
 * @property {number} vertices
 * @property {number} cpuSeconds of Evolver since its start
 * @property {number} seconds wall-clock time since its start
 */
/**
 * @typedef {object} Reached the first step after which the error stays small, see `reached`
 * @property {number} vertices
 * @property {number} relativeError of that level's last step
 * @property {number} seconds
 * @property {number} cpuSeconds
 */
/**
 * @typedef {object} EvolverRow
 * @property {'whole' | 'sector'} domain the whole surface or a twelfth of it
 * @property {string} quantity
 * @property {string} schedule
 * @property {number} vertices of the last level, in the domain
 * @property {number} energy 4 W + 8 pi, the bending energy of a surface of genus 2 with Willmore energy W
 * @property {number} relativeError signed: discrete energies may be too low
 * @property {number} seconds of the whole run
 * @property {number} cpuSeconds
 * @property {number | null} secondsToTenthPercent
 * @property {number | null} cpuSecondsToTenthPercent
 * @property {Reached | null} tenthPercent
 * @property {boolean} ended whether Evolver ended by itself within the time limit
 */

/** The bending energy of Lawson's surface xi_{2,1}: 4 W + 8 pi for W = 21.908514. */
export const exactBending = 112.7668;
const tolerance = 1e-3;
const secondsPerSchedule = 60;
/** Number of rounds of each schedule. The fastest counts, because other work on the machine can only slow it down. */
const rounds = 3;

export const evolverMissing =
  'Surface Evolver is not installed; on Debian, as root: apt-get install --no-install-recommends evolver-nox';

/** @returns {boolean} */
export function evolverInstalled() {
  return spawnSync('evolver', ['-h'], { stdio: 'ignore' }).error === undefined;
}

/** @param {number} willmore */
const bending = (willmore) => 4 * willmore + 8 * Math.PI;
/** @param {Step} step */
const errorOf = (step) => bending(step.willmore) / exactBending - 1;

/**
 * Parses a line of `report`, which may begin with Evolver's prompt.
 * @param {string} line
 * @param {number} seconds time at which the line arrived
 * @returns {Step | undefined}
 */
export function parseStep(line, seconds) {
  const match = /^(?:Enter command: )*step (\S+) (\d+) (\S+)$/.exec(line.trim());
  if (!match) return undefined;
  return { willmore: Number(match[1]), vertices: Number(match[2]), cpuSeconds: Number(match[3]), seconds };
}

/**
 * Finds the first level whose energy stays within the tolerance until its end, such that every later level also ends
 * within it, and returns the first step of that level from which on it stays. An energy that only passes through the
 * exact value does not count; errors right after a refinement do not matter.
 * @param {Step[]} steps
 * @returns {Reached | null}
 */
export function reached(steps) {
  /** @type {Reached | null} */
  let result = null;
  const levels = [...new Set(steps.map((step) => step.vertices))];
  for (const vertices of levels.reverse()) {
    const level = steps.filter((step) => step.vertices === vertices);
    const off = level.findLastIndex((step) => !(Math.abs(errorOf(step)) < tolerance));
    const first = level[off + 1];
    if (!first) break;
    const { seconds, cpuSeconds } = first;
    result = { vertices, relativeError: errorOf(level[level.length - 1]), seconds, cpuSeconds };
  }
  return result;
}

/**
 * @param {Schedule} schedule
 * @returns {Promise<{ steps: Step[], ended: boolean }>}
 */
export async function runSchedule({ domain, quantity, area, commands }) {
  const folder = mkdtempSync(path.join(tmpdir(), 'evolver-'));
  const file = path.join(folder, `${domain}.fe`);
  writeFileSync(file, [datafile(domain, quantity, area), vocabulary(area), ...commands, 'q', ''].join('\n'));
  try {
    const start = performance.now();
    const child = spawn('evolver', [file], {
      stdio: ['ignore', 'pipe', 'ignore'],
      timeout: secondsPerSchedule * 1000,
      killSignal: 'SIGKILL',
    });
    /** @type {Promise<boolean>} */
    const end = new Promise((resolve, reject) => {
      child.on('error', reject);
      child.on('close', (code) => resolve(code === 0));
    });
    /** @type {Step[]} */
    const steps = [];
    createInterface({ input: child.stdout }).on('line', (line) => {
      const step = parseStep(line, (performance.now() - start) / 1000);
      if (step) steps.push(step);
    });
    return { ended: await end, steps };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {Schedule} schedule @param {{ steps: Step[], ended: boolean }} run @returns {EvolverRow} */
function rowOf({ domain, quantity, name }, { steps, ended }) {
  const last = steps[steps.length - 1];
  if (!last) throw new Error(`Surface Evolver printed nothing for ${domain}, ${name}`);
  const tenthPercent = reached(steps);
  return {
    domain,
    quantity,
    schedule: name,
    vertices: last.vertices,
    energy: bending(last.willmore),
    relativeError: errorOf(last),
    seconds: last.seconds,
    cpuSeconds: last.cpuSeconds,
    secondsToTenthPercent: tenthPercent?.seconds ?? null,
    cpuSecondsToTenthPercent: tenthPercent?.cpuSeconds ?? null,
    tenthPercent,
    ended,
  };
}

/**
 * @param {{ log?: (line: string) => void, schedules?: Schedule[] }} [options]
 * @returns {Promise<EvolverRow[]>} the quickest round of each schedule
 */
export async function runEvolver({ log = () => {}, schedules = allSchedules } = {}) {
  if (!evolverInstalled()) throw new Error(evolverMissing);
  /** @type {EvolverRow[]} */
  const rows = [];
  for (const schedule of schedules) {
    /** @type {EvolverRow[]} */
    const runs = [];
    for (let round = 0; round < rounds; ++round) runs.push(rowOf(schedule, await runSchedule(schedule)));
    const time = (/** @type {EvolverRow} */ row) => row.secondsToTenthPercent ?? row.seconds;
    const best = runs.reduce((a, b) => (time(b) < time(a) ? b : a));
    log(`${best.domain}, ${best.schedule}: ${best.energy.toFixed(4)} after ${best.seconds.toFixed(2)} s`);
    rows.push(best);
  }
  return rows;
}

/** @param {EvolverRow[]} rows @returns {{ head: string[], cells: string[][] }} */
export function evolverTable(rows) {
  const percent = (/** @type {number} */ error) => `${(100 * error).toFixed(3)} %`;
  return {
    head: [
      ...['domain', 'schedule', 'quantity', 'to 0.1 %: s', 'CPU s', 'vertices', 'error'],
      ...['at the end: s', 'vertices', 'energy', 'error'],
    ],
    cells: rows.map(({ tenthPercent: at, ...row }) => [
      row.domain,
      row.schedule,
      row.quantity.replace('_sq_mean_curvature', ''),
      ...(at
        ? [at.seconds.toFixed(3), at.cpuSeconds.toFixed(3), String(at.vertices), percent(at.relativeError)]
        : ['never', '', '', '']),
      row.ended ? row.seconds.toFixed(3) : 'time limit',
      String(row.vertices),
      row.energy.toFixed(4),
      percent(row.relativeError),
    ]),
  };
}
