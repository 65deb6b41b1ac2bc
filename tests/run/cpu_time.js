// SPDX-License-Identifier: MIT
/**
 * @file The CPU time of this process and the programs that it has run, on platforms that report it (Linux). Running
 * programs are counted only after they have ended; programs that outlive their parent are not counted.
 */
import { existsSync, readFileSync } from 'node:fs';

const ticksPerSecond = 100; // the unit of /proc, the same on every processor

/** @returns {number | undefined} seconds */
export function cpuSeconds() {
  const file = '/proc/self/stat';
  return existsSync(file) ? secondsIn(readFileSync(file, 'utf8')) : undefined;
}

/**
 * @param {string} stat a process's line in /proc; its name, in parentheses, may contain any characters
 * @returns {number} the user and system time of the process and its ended children
 */
export function secondsIn(stat) {
  const afterName = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  const [utime, stime, cutime, cstime] = afterName.slice(11, 15).map(Number);
  return (utime + stime + cutime + cstime) / ticksPerSecond;
}
