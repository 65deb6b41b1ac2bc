// SPDX-License-Identifier: MIT
/**
 * @file The CPU time includes this process and the programs that it has run.
 */
import { expect, test } from '@jest/globals';
import { spawnSync } from 'node:child_process';
import { cpuSeconds, secondsIn } from './cpu_time.js';

test('adds up the times of a process and its ended children, whatever its name', () => {
  const times = '100 20 3000 400';
  expect(secondsIn(`17 (a) b (c) S 1 17 17 0 -1 4194560 2000 0 0 0 ${times} 20 0 11 0 300 0 0`)).toBe(35.2);
});

(cpuSeconds() === undefined ? test.skip : test)('grows by what a program takes', () => {
  const before = cpuSeconds() ?? NaN;
  const busy = 'const end = process.cpuUsage().user + 3e5; while (process.cpuUsage().user < end);';
  expect(spawnSync(process.execPath, ['-e', busy]).status).toBe(0);
  expect((cpuSeconds() ?? NaN) - before).toBeGreaterThan(0.25);
});
