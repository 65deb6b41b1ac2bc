// SPDX-License-Identifier: MIT
/**
 * @file Runs the Jest tests in some folders and counts them.
 */
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { root, run } from './process.js';
import { expectSome } from './tally.js';

/** @typedef {import('./tally.js').Tally} Tally */

const minutesForOneRun = 60;

/**
 * @param {string} name of the report
 * @param {string[]} folders
 * @param {string[]} [flags] for Jest
 * @returns {Promise<Tally>}
 */
export async function runJestTests(name, folders, flags = []) {
  const report = path.join(root, 'build/reports', `${name}.json`);
  mkdirSync(path.dirname(report), { recursive: true });
  rmSync(report, { force: true });
  const node = ['--experimental-vm-modules', '--disable-warning=ExperimentalWarning', 'node_modules/jest/bin/jest.js'];
  const jest = ['--json', `--outputFile=${report}`];
  const code = await run(process.execPath, [...node, ...jest, ...folders, ...flags], { minutes: minutesForOneRun });
  const tally = existsSync(report)
    ? countJestTests(readFileSync(report, 'utf8'))
    : { passed: 0, failed: 0, skipped: 0 };
  if (code !== 0 && tally.failed === 0) tally.failed = 1;
  return expectSome(tally);
}

/**
 * @param {string} json Jest's report
 * @returns {Tally} a file that cannot be run counts as one failed test
 */
export function countJestTests(json) {
  const report = JSON.parse(json);
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + report.numRuntimeErrorTestSuites,
    skipped: report.numPendingTests + report.numTodoTests,
  };
}
