// SPDX-License-Identifier: MIT
/**
 * @file Runs the C++ test programs of a build, one for each folder of tests, and counts their tests.
 */
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { capture, root } from './process.js';
import { expectSome, line, sum } from './tally.js';

/** @typedef {import('./tally.js').Tally} Tally */

const minutesForOneExecutable = 60;

/** @returns {string[]} the expected programs, one per folder of tests, with their names in tests/CMakeLists.txt */
export function executables() {
  const core = path.join(root, 'tests/core');
  const folders = existsSync(core)
    ? readdirSync(core, { withFileTypes: true }).filter((entry) => entry.isDirectory())
    : [];
  const layers = folders.filter(({ name }) => hasTests(path.join(core, name))).map(({ name }) => name);
  if (hasTests(path.join(root, 'tests/wasm'))) layers.push('api');
  if (hasTests(path.join(root, 'tests/fuzz'))) layers.push('fuzz');
  return layers.map((layer) => `umbilic_test_${layer}`);
}

/** @param {string} folder @returns {boolean} */
function hasTests(folder) {
  if (!existsSync(folder)) return false;
  return readdirSync(folder, { recursive: true, encoding: 'utf8' }).some((name) => name.endsWith('_test.cpp'));
}

/** @typedef {'native' | 'sanitize' | 'coverage'} TestedPart */

/**
 * Runs all C++ tests of one build. With sanitizers or counters, leaves out tests with Slow in their name: those that run the
 * code of a quicker test once more, for more or larger inputs.
 * @param {TestedPart} part
 * @returns {Promise<Tally>}
 */
export async function runCppTests(part) {
  const waiting = executables();
  /** @type {Tally[]} */
  const tallies = [];
  const worker = async () => {
    for (let name = waiting.shift(); name; name = waiting.shift()) tallies.push(await runExecutable(part, name));
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return expectSome(sum(tallies));
}

/**
 * @param {TestedPart} part
 * @param {string} name
 * @returns {Promise<Tally>}
 */
async function runExecutable(part, name) {
  const folder = path.join(root, 'build', part === 'sanitize' ? 'native' : part);
  const below = part === 'sanitize' ? 'sanitized' : '';
  const program = path.join(folder, 'tests', below, name);
  const report = path.join(folder, 'reports', below, `${name}.json`);
  if (!existsSync(program)) {
    console.log(`${name}: not built`);
    return { passed: 0, failed: 1, skipped: 0 };
  }
  mkdirSync(path.dirname(report), { recursive: true });
  rmSync(report, { force: true });
  const args = ['--gtest_brief=1', '--gtest_color=no', `--gtest_output=json:${report}`];
  if (part !== 'native') args.push('--gtest_filter=-*Slow*');
  const { code, text } = await capture(program, args, {
    minutes: minutesForOneExecutable,
    environment: { UBSAN_OPTIONS: 'print_stacktrace=1' },
  });
  const tally = existsSync(report)
    ? countGoogleTests(readFileSync(report, 'utf8'))
    : { passed: 0, failed: 0, skipped: 0 };
  if (code !== 0 && tally.failed === 0) tally.failed = 1; // It crashed, or a sanitizer ended it.
  console.log(`${tally.failed ? text : ''}${name} (${part}): ${line(tally)}`);
  return tally;
}

/**
 * @param {string} json GoogleTest's report
 * @returns {Tally}
 */
export function countGoogleTests(json) {
  const tally = { passed: 0, failed: 0, skipped: 0 };
  for (const suite of JSON.parse(json).testsuites) {
    for (const test of suite.testsuite) {
      if (test.failures?.length) tally.failed += 1;
      else if (test.status === 'NOTRUN' || test.result === 'SKIPPED') tally.skipped += 1;
      else tally.passed += 1;
    }
  }
  return tally;
}
