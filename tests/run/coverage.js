// SPDX-License-Identifier: MIT
/**
 * @file `npm run coverage`: builds the core, the contract and the program with counters, runs the C++ tests and those of the
 * command line on them, and prints how many lines ran, by room. Fails where that is less than the tree promises.
 */
import { readFileSync, readdirSync, rmSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { build, parts } from './build.js';
import { executables, runCppTests } from './cpp_tests.js';
import { installPackages, installTools } from './install.js';
import { runJestTests } from './jest_tests.js';
import { capture, root } from './process.js';
import { line, sum } from './tally.js';

/** Lines of code: how many there are, and how many ran. @typedef {{ lines: number, ran: number }} Lines */

/**
 * What stands in the table: parts of the tree by the paths of their files, and the least percentage of lines that run.
 * @type {{ name: string, files: RegExp, least?: number }[]}
 */
export const rows = [
  ...[
    'base',
    'cage',
    'mesh',
    'surface',
    'energy',
    'opinion',
    'solve',
    'optimize',
    'problem',
    'driver',
    'catalog',
    'cli',
  ].map((room) => ({ name: `core/${room}`, files: new RegExp(`^core/${room}/`) })),
  { name: 'the contract, wasm', files: /^wasm\//, least: 95 },
  { name: 'the readers of files', files: /^core\/cage\/(read|ply|off)[^/]*$/, least: 95 },
  { name: 'the core', files: /^core\//, least: 95 },
];

/**
 * @param {{ files: { filename: string, line_total: number, line_covered: number }[] }} summary gcovr's, in JSON
 * @param {RegExp} files
 * @returns {Lines}
 */
export function linesOf(summary, files) {
  const found = summary.files.filter(({ filename }) => files.test(filename));
  return {
    lines: found.reduce((total, file) => total + file.line_total, 0),
    ran: found.reduce((total, file) => total + file.line_covered, 0),
  };
}

/** @param {Lines} lines @returns {number} percent */
export const percentage = ({ lines, ran }) => (lines ? (100 * ran) / lines : 0);

/** Forgets what ran before. */
function removeCounts() {
  const folder = path.join(root, 'build/coverage');
  for (const name of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (name.endsWith('.gcda')) rmSync(path.join(folder, name));
  }
}

/** @returns {Promise<any>} gcovr's summary of what ran since */
async function summary() {
  const file = 'build/coverage/summary.json';
  const files = ['--filter', 'core/', '--filter', 'wasm/'];
  // A counter that a loop keeps in a register may still lose counts, and gcov then calls a branch's count negative.
  const negative = '--gcov-ignore-parse-errors';
  const args = ['--root', '.', ...files, negative, '--json-summary', file, 'build/coverage'];
  const { code, text } = await capture('gcovr', args);
  if (code !== 0) throw new Error(text);
  return JSON.parse(readFileSync(path.join(root, file), 'utf8'));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  if (!(await installTools(...parts.coverage)) || !(await installPackages())) process.exit(1);
  if (!(await build('coverage', 'umbilic', ...executables()))) process.exit(1);
  removeCounts();
  // On one processor threads take turns between instructions, so that plain counters lose next to nothing. Atomic ones take
  // several times as long.
  const pinned = await capture('taskset', ['--pid', '--cpu-list', '0', String(process.pid)]);
  if (pinned.code !== 0) throw new Error(pinned.text);
  process.env.UMBILIC_PROGRAM = path.join(root, 'build/coverage/umbilic');
  const ofProgram = ['tests/cli', 'tests/hostile/native'];
  // What others link, and what lets allocations fail, is another build's. Where a program's writes fail, those of its counts do, too.
  // Counting takes longer.
  const flags = ['--testPathIgnorePatterns', 'tests/cli/(consumer|faults|output)', '--testTimeout=600000'];
  const tally = sum([await runCppTests('coverage'), await runJestTests('coverage', ofProgram, flags)]);
  console.log(line(tally));
  if (tally.failed) process.exitCode = 1;

  const counted = await summary();
  console.log(`\n${''.padEnd(22)}   lines       ran`);
  for (const { name, files, least } of rows) {
    const lines = linesOf(counted, files);
    const percent = percentage(lines);
    const short = least !== undefined && percent < least;
    const words = short ? `   less than ${least} %` : '';
    console.log(`${name.padEnd(22)}${String(lines.lines).padStart(8)}${percent.toFixed(1).padStart(8)} %${words}`);
    if (short || !lines.lines) process.exitCode = 1;
  }
}
