// SPDX-License-Identifier: MIT
/**
 * @file `npm run fuzz -- --minutes N [target …]`: builds what is fuzzed (tests/fuzz/targets.h) with clang, libFuzzer and
 * sanitizers, runs each target for N minutes from its corpus, and prints what that covered and found. What libFuzzer
 * invents on the way is kept in build/fuzz/corpus, inputs that break a promise in build/fuzz/findings: once its cause is
 * mended, such a file belongs into tests/fuzz/corpus, which `npm test` replays.
 */
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { build, parts } from './build.js';
import { installPackages, installTools } from './install.js';
import { capture, root } from './process.js';

/** @typedef {{executions: number, perSecond: number, edges: number, finding: string}} Outcome `finding` is empty if there is none */

export const targets = ['cages', 'problems', 'contract'];

/** The longest input, in bytes. @type {Record<string, number>} */
const longest = { cages: 4096, problems: 8192, contract: 128 };

/**
 * An input that takes more memory, in MB, is a finding, and so is one that does not end, in seconds by the clock. How long
 * it may compute, tests/fuzz/targets.h says.
 */
const LIMITS = { seconds: 300, megabytes: 2048 };

/**
 * What libFuzzer's output says.
 * @param {string} text
 * @returns {Outcome}
 */
export function outcomeOf(text) {
  const edges = [...text.matchAll(/^#\d+\s.*\bcov: (\d+)/gm)].at(-1);
  const stat = (/** @type {string} */ name) =>
    Number(new RegExp(`^stat::${name}:\\s+(\\d+)`, 'm').exec(text)?.[1] ?? NaN);
  const artifact = /Test unit written to (\S+)/.exec(text)?.[1];
  const summary =
    /^broken promise: .*/m.exec(text)?.[0] ?? /^(?:SUMMARY: .*|.*: runtime error: .*)/m.exec(text)?.[0] ?? '';
  return {
    executions: stat('number_of_executed_units'),
    perSecond: stat('average_exec_per_sec'),
    edges: edges ? Number(edges[1]) : NaN,
    finding: artifact ? `${path.basename(artifact)}: ${summary}` : '',
  };
}

/**
 * @param {string[]} args of the command
 * @returns {{minutes: number, chosen: string[]} | null} null if they make no sense
 */
export function askedFor(args) {
  const rest = [...args];
  const at = rest.indexOf('--minutes');
  const [, number] = at < 0 ? ['', '1'] : rest.splice(at, 2);
  const minutes = Number(number);
  if (!(minutes > 0 && Number.isFinite(minutes)) || rest.some((name) => !targets.includes(name))) return null;
  return { minutes, chosen: rest.length ? rest : targets };
}

/** @param {string} target @param {number} minutes @returns {Promise<Outcome>} */
async function fuzz(target, minutes) {
  const invented = `build/fuzz/corpus/${target}`;
  const findings = 'build/fuzz/findings';
  for (const folder of [invented, findings]) mkdirSync(path.join(root, folder), { recursive: true });
  const dictionary = `tests/fuzz/${target}.dict`;
  const { text } = await capture(
    `build/fuzz/umbilic_fuzz_${target}`,
    [
      `-max_total_time=${Math.ceil(60 * minutes)}`,
      `-max_len=${longest[target]}`,
      `-timeout=${LIMITS.seconds}`,
      `-report_slow_units=${LIMITS.seconds}`,
      `-rss_limit_mb=${LIMITS.megabytes}`,
      `-artifact_prefix=${findings}/${target}-`,
      ...(existsSync(path.join(root, dictionary)) ? [`-dict=${dictionary}`] : []),
      '-entropic=0', // which weighs rare features, and with executions of milliseconds takes half of the time
      '-print_final_stats=1',
      invented,
      `tests/fuzz/corpus/${target}`,
    ],
    { minutes: minutes + 2 },
  );
  const outcome = outcomeOf(text);
  if (outcome.finding || Number.isNaN(outcome.executions)) console.log(text.split('\n').slice(-60).join('\n'));
  return outcome;
}

/** @param {number} number */
const cell = (number) => String(number).padStart(12);

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const asked = askedFor(process.argv.slice(2));
  if (!asked) {
    console.error(`Usage: npm run fuzz -- [--minutes N] [${targets.join(' | ')}] …`);
    process.exit(2);
  }
  const { minutes, chosen } = asked;
  if (!(await installTools(...parts.fuzz)) || !(await installPackages())) process.exit(1);
  if (!(await build('fuzz', ...chosen.map((target) => `umbilic_fuzz_${target}`)))) process.exit(1);
  console.log(
    `${''.padEnd(10)}${['executions', 'per second', 'edges'].map((word) => word.padStart(12)).join('')}   findings`,
  );
  for (const target of chosen) {
    const { executions, perSecond, edges, finding } = await fuzz(target, minutes);
    console.log(`${target.padEnd(10)}${cell(executions)}${cell(perSecond)}${cell(edges)}   ${finding || 'none'}`);
    if (finding || Number.isNaN(executions)) process.exitCode = 1;
  }
  const count = readdirSync(path.join(root, 'build/fuzz/findings')).length;
  if (count) console.log(`build/fuzz/findings has ${count} file${count === 1 ? '' : 's'}`);
}
