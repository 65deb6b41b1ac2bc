// SPDX-License-Identifier: MIT
/**
 * @file How long something will take, in words that promise no more than is known, and what to say before a run that
 * takes long or much memory.
 */
import { compact } from './numbers.js';

/** @import {Estimate} from '../../wasm/types.js' */

const MINUTE = 60;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
/** Seconds that try a user's patience, and bytes that not every browser gives. */
const LONG = 2 * MINUTE;
const LARGE = 1e9;

/**
 * "a second", "about 8 s", "about 20 s", "about 3 min", "about 2 h"; the command line rounds alike.
 * @param {number} seconds
 */
export function roughDuration(seconds) {
  /** @param {number} unit @param {number} step @param {string} name */
  const about = (unit, step, name) => `about ${step * Math.max(1, Math.round(seconds / (unit * step)))} ${name}`;
  if (!Number.isFinite(seconds)) return 'unknown';
  if (seconds < 1.5) return 'a second';
  if (seconds < 9.5) return about(1, 1, 's');
  if (seconds < 57.5) return about(1, 5, 's');
  if (seconds < 1.5 * MINUTE) return 'about a minute';
  if (seconds < 9.5 * MINUTE) return about(MINUTE, 1, 'min');
  if (seconds < 57.5 * MINUTE) return about(MINUTE, 5, 'min');
  if (seconds < 1.5 * HOUR) return 'about an hour';
  return seconds < 1.5 * DAY ? about(HOUR, 1, 'h') : about(DAY, 1, 'days');
}

/** Below Start: "Takes about 8 s". @param {Estimate} estimate */
export const estimateWords = ({ seconds }) => `Takes ${roughDuration(seconds)}`;

/** While a run goes on: "about 5 s left"; empty where that cannot be told. @param {number} seconds */
export const leftWords = (seconds) => (Number.isFinite(seconds) ? `${roughDuration(seconds)} left` : '');

/**
 * A warning before a run that takes more than two minutes or a gigabyte; empty otherwise.
 * @param {Estimate} estimate
 * @returns {string} sentences that also tell the time
 */
export function patienceWords({ levels, seconds, bytes }) {
  const [last] = levels.slice(-1);
  if (!last) return '';
  const longest = levels.reduce((one, other) => (other.seconds > one.seconds ? other : one));
  const fewer = levels.length > 1 ? ' Fewer levels take less.' : '';
  const part = levels.length > 1 ? `, of which level ${longest.level} takes ${roughDuration(longest.seconds)}` : '';
  if (seconds <= LONG && bytes <= LARGE) return '';
  const memory =
    bytes > LARGE
      ? ` Level ${last.level} takes ${compact(bytes / 1e9, 2)} GB of memory, which not every browser gives.`
      : '';
  return `This will take ${roughDuration(seconds)}${part}.${memory}${fewer}`;
}
