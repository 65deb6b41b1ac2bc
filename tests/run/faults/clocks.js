// SPDX-License-Identifier: MIT
/**
 * @file A clock that jumps by a year to and fro with each look (tests/faults/shim.cpp): nothing may depend on the time of
 * day, which is set while programs run.
 */
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { root } from '../process.js';
import { count } from './row.js';

/** @typedef {import('./row.js').Row} Row */

const program = path.join(root, 'build/native/umbilic');
const shim = path.join(root, 'build/native/tests/umbilic_fault_shim.so');

/**
 * A run in which a clock jumps.
 * @param {string} cage
 * @param {string} clock
 * @returns {{ seconds: number[], rest: string }} what its levels took, and its report without that and
 *   without the estimate of it, which is made from a measurement
 */
function reportWith(cage, clock) {
  const line = 'optimize - --functional bending --levels 0..2 -q --threads 1 --report -';
  const env = { ...process.env, LD_PRELOAD: shim, UMBILIC_CLOCK: clock };
  const { status, stdout, stderr } = spawnSync(program, line.split(' '), { input: cage, encoding: 'utf8', env });
  if (status !== 0) throw new Error(`with ${clock}: ${status}, ${stderr}`);
  const report = JSON.parse(stdout);
  const seconds = report.levels.map((/** @type {{ seconds: number }} */ level) => level.seconds);
  for (const level of report.levels) delete level.seconds;
  delete report.estimate;
  return { seconds, rest: JSON.stringify(report) };
}

/** @returns {Row[]} */
export function jumpClocks() {
  const cage = spawnSync(program, ['cage', 'two-3'], { encoding: 'utf8' }).stdout;
  const { rest } = reportWith(cage, 'none');
  const isYear = (/** @type {number} */ seconds) => Math.abs(seconds) > 86400;
  /** @type {Row} */
  const row = { fault: 'time of day jumps by a year with each look', positions: 0, outcomes: {}, wrong: [] };
  const jumped = reportWith(cage, 'realtime');
  for (const seconds of jumped.seconds) {
    const wrong = isYear(seconds) || seconds < 0 ? `a level of ${seconds} s` : '';
    count(row, wrong || jumped.rest !== rest ? 'changed' : 'the same report, and times that are true', wrong);
  }
  if (jumped.rest !== rest) row.wrong.push('another report');
  /** Shows that the shim does what it says. @type {Row} */
  const control = {
    fault: 'the monotonic clock jumps, to see that the shim works',
    positions: 0,
    outcomes: {},
    wrong: [],
  };
  const shown = reportWith(cage, 'monotonic');
  const seen = shown.seconds.some(isYear);
  count(control, seen ? 'false times are seen' : 'nothing is seen', seen ? '' : 'the shim does nothing');
  if (shown.rest !== rest) control.wrong.push('the surface depends on the clock');
  return [row, control];
}
