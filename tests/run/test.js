// SPDX-License-Identifier: MIT
/**
 * @file `npm test`: installs what is missing, builds everything, runs all checks and all tests, and prints one line
 * with their counts at the end. With names of suites as arguments, runs only those (`npm test -- gates native`).
 */
import { build } from './build.js';
import { runCppTests } from './cpp_tests.js';
import { cpuSeconds } from './cpu_time.js';
import { installPackages, installTools } from './install.js';
import { runJestTests } from './jest_tests.js';
import { gates } from './lint.js';
import { line, one, sum } from './tally.js';

/** @typedef {import('./tally.js').Tally} Tally */
/** @typedef {import('./build.js').Part} Part */

/**
 * The suites in their order, and the parts that must be built for each.
 * @type {Record<string, { parts: Part[], run: () => Promise<Tally> }>}
 */
const suites = {
  gates: { parts: [], run: runGates },
  architecture: { parts: [], run: () => runJestTests('architecture', ['tests/architecture', 'tests/run']) },
  native: { parts: ['native'], run: () => runCppTests('native') },
  sanitize: { parts: ['sanitize'], run: () => runCppTests('sanitize') },
  javascript: {
    parts: ['native', 'wasm', 'types'],
    run: () => runJestTests('javascript', ['tests/cli', 'tests/hostile', 'tests/wasm', 'tests/web']),
  },
  browser: { parts: ['wasm', 'types', 'web'], run: () => runJestTests('browser', ['tests/browser'], ['--runInBand']) },
};

async function runGates() {
  /** @type {Tally[]} */
  const tallies = [];
  for (const { name, check } of gates) {
    const ok = await check();
    console.log(`${name}: ${ok ? 'ok' : 'failed'}`);
    tallies.push(one(ok));
  }
  return sum(tallies);
}

/** @type {{ name: string, tally: Tally, seconds: number, cpu?: number }[]} */
const results = [];

/** @param {string} name @param {() => Promise<Tally>} work */
async function record(name, work) {
  console.log(`\n== ${name}`);
  const start = performance.now();
  const cpuBefore = cpuSeconds();
  const tally = await work().catch((error) => {
    console.error(error);
    return one(false);
  });
  const cpuAfter = cpuSeconds();
  const cpu = cpuBefore === undefined || cpuAfter === undefined ? undefined : cpuAfter - cpuBefore;
  results.push({ name, tally, seconds: (performance.now() - start) / 1000, cpu });
}

/** @param {string[]} names */
async function testSuites(names) {
  if (!(await installTools('native', 'wasm', 'lint', 'browser')) || !(await installPackages())) {
    results.push({ name: 'install', tally: one(false), seconds: 0 });
    return;
  }
  /** @type {Set<Part>} */
  const built = new Set();
  for (const name of names) {
    for (const part of suites[name].parts) {
      if (built.has(part)) continue;
      built.add(part);
      await record(`build ${part}`, async () => one(await build(part)));
    }
    await record(name, suites[name].run);
  }
}

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in suites));
if (unknown.length) {
  console.error(`No suite ${unknown.join(', ')}; there are ${Object.keys(suites).join(', ')}`);
  process.exit(2);
}
await testSuites(wanted.length ? wanted : Object.keys(suites));

/** @param {number | undefined} seconds @returns {string} blank where the platform does not tell */
const cell = (seconds) => (seconds === undefined ? '' : `${seconds.toFixed(1)} s`).padStart(10);

console.log(`\n${''.padEnd(16)}${'clock'.padStart(10)}${'CPU'.padStart(10)}`);
for (const { name, tally, seconds, cpu } of results) {
  console.log(`${name.padEnd(16)}${cell(seconds)}${cell(cpu)}   ${line(tally)}`);
}
console.log(`${'all'.padEnd(16)}${cell(performance.now() / 1000)}${cell(cpuSeconds())}`);
const total = sum(results.map((result) => result.tally));
process.exitCode = total.failed || !total.passed ? 1 : 0;
console.log(`\n${line(total)}`);
