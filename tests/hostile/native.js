// SPDX-License-Identifier: MIT
/**
 * @file Runs a row of the tables of hostile inputs through the program, held to the time and memory that a row may take.
 */
import { spawnSync } from 'node:child_process';
import { program } from '../cli/program.js';
import { cpuSeconds } from '../run/cpu_time.js';
import { exitCodes, limits, stepsOfCage } from './row.js';
import { outcomeOf, wordsOf } from './verdict.js';

/** @typedef {import('./row.js').Row} Row */
/** @typedef {import('./row.js').Outcome} Outcome */

/** Other programs may need the processor too. */
const MOST_CLOCK_SECONDS = 60;

/** With as many threads on every machine, because each reserves memory. */
const minimize = ['optimize', '-', '-q', '--report', '-', '--threads', '2'];
const { levels, max_iterations: iterations } = stepsOfCage.options;
const ofCage = ['--functional', 'bending', '--levels', levels.join('..'), '--max-iterations', `${iterations}`];

/** @param {Row} row @returns {string[]} */
function argumentsOf(row) {
  if (row.kind === 'command') return row.args;
  return row.kind === 'cage' ? [...minimize, ...ofCage] : minimize;
}

/** @param {number | null} code @param {string} out @param {string} err @returns {{ outcome: string, said: string }} */
function endOf(code, out, err) {
  const outcome = Object.keys(exitCodes).find((name) => exitCodes[/** @type {Outcome} */ (name)] === code);
  if (code === null) return { outcome: 'was stopped', said: err };
  if (!outcome) return { outcome: `ended with ${code}`, said: err };
  if (code !== exitCodes.minimized && code !== exitCodes.doubtful) {
    return { outcome: out === '' ? outcome : 'is refused after it has printed', said: err };
  }
  const report = JSON.parse(out);
  const byReport = outcomeOf(report);
  return {
    outcome: byReport === outcome ? outcome : `${outcome} by its exit code, ${byReport}`,
    said: wordsOf(report),
  };
}

/** @param {Row} row @param {string} folder to run in @returns {import('./verdict.js').Ended} */
export function runNatively(row, folder) {
  const held = `ulimit -v ${1024 * limits.megabytes}; ulimit -t ${limits.seconds}; exec "$0" "$@"`;
  const input = row.kind === 'command' ? row.input : row.content();
  const before = cpuSeconds() ?? 0;
  const { status, stdout, stderr, error } = spawnSync('sh', ['-c', held, program, ...argumentsOf(row)], {
    input,
    cwd: folder,
    encoding: 'utf8',
    timeout: 1000 * MOST_CLOCK_SECONDS,
    killSignal: 'SIGKILL',
    maxBuffer: 1 << 28,
  });
  // A program that refuses its arguments or its input need not have read all of it.
  if (error && !/EPIPE|ETIMEDOUT/.test(error.message)) throw error;
  return { ...endOf(status, stdout, stderr), seconds: (cpuSeconds() ?? 0) - before };
}
