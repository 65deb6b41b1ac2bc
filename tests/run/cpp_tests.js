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

/** Programs whose tests are dealt out to several runs, because one would still go on when all others have ended. */
const shardsOf = new Map([['umbilic_test_driver', 4]]);

/** Some of the tests of a program: those of one of its shards. @typedef {{ name: string, shard: number, shards: number }} Job */

/** @param {string[]} names of programs @returns {Job[]} those that take longest first */
export function jobsOf(names) {
  const jobs = names.flatMap((name) => {
    const shards = shardsOf.get(name) ?? 1;
    return Array.from({ length: shards }, (_, shard) => ({ name, shard, shards }));
  });
  return jobs.sort((a, b) => b.shards - a.shards);
}

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
  const waiting = jobsOf(executables());
  /** @type {Tally[]} */
  const tallies = [];
  const worker = async () => {
    for (let job = waiting.shift(); job; job = waiting.shift()) tallies.push(await runExecutable(part, job));
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return expectSome(sum(tallies));
}

/**
 * @param {TestedPart} part
 * @param {Job} job
 * @returns {Promise<Tally>}
 */
async function runExecutable(part, { name, shard, shards }) {
  const folder = path.join(root, 'build', part === 'sanitize' ? 'native' : part);
  const below = part === 'sanitize' ? 'sanitized' : '';
  const program = path.join(folder, 'tests', below, name);
  const label = shards > 1 ? `${name} ${shard + 1}/${shards}` : name;
  const report = path.join(folder, 'reports', below, `${label.replace(/\W/g, '_')}.json`);
  if (!existsSync(program)) {
    console.log(`${label}: not built`);
    return { passed: 0, failed: 1, skipped: 0 };
  }
  mkdirSync(path.dirname(report), { recursive: true });
  rmSync(report, { force: true });
  const args = ['--gtest_brief=1', '--gtest_color=no', `--gtest_output=json:${report}`];
  if (part !== 'native') args.push('--gtest_filter=-*Slow*');
  const { code, text } = await capture(program, args, {
    minutes: minutesForOneExecutable,
    environment: {
      UBSAN_OPTIONS: 'print_stacktrace=1',
      GTEST_TOTAL_SHARDS: String(shards),
      GTEST_SHARD_INDEX: String(shard),
    },
  });
  const tally = existsSync(report)
    ? countGoogleTests(readFileSync(report, 'utf8'))
    : { passed: 0, failed: 0, skipped: 0 };
  if (code !== 0 && tally.failed === 0) tally.failed = 1; // It crashed, or a sanitizer ended it.
  console.log(`${tally.failed ? text : ''}${label} (${part}): ${line(tally)}`);
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
