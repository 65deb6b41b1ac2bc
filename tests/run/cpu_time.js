// SPDX-License-Identifier: MIT
/**
 * @file The processor's time that this process and the programs that it ran have taken, where the platform tells: Linux does. Programs
 * still running count when they have ended, and those that outlive whoever started them do not.
 */
import { existsSync, readFileSync } from 'node:fs';

const ticksPerSecond = 100; // in /proc, on every processor

/** @returns {number | undefined} seconds */
export function cpuSeconds() {
  const file = '/proc/self/stat';
  return existsSync(file) ? secondsIn(readFileSync(file, 'utf8')) : undefined;
}

/**
 * @param {string} stat a process's line in /proc; its name, in parentheses, may hold anything
 * @returns {number} the time of the process and of its ended children, for itself and in the system
 */
export function secondsIn(stat) {
  const afterName = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  const [utime, stime, cutime, cstime] = afterName.slice(11, 15).map(Number);
  return (utime + stime + cutime + cstime) / ticksPerSecond;
}
