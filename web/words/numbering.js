// SPDX-License-Identifier: MIT
/**
 * @file Lists of numbers as they are typed: "1, 4–6". What is typed counts from 1, what is meant from 0.
 */

/** So many numbers can be typed as one range. */
const MOST = 1e6;

/** @param {number[]} numbers ascending, from 0 @returns {string} */
export function numbersWords(numbers) {
  /** @type {Array<[number, number]>} */
  const ranges = [];
  for (const number of numbers) {
    const last = ranges.at(-1);
    if (last && last[1] === number - 1) last[1] = number;
    else ranges.push([number, number]);
  }
  return ranges
    .map(([from, to]) => (from === to ? `${from + 1}` : `${from + 1}${to === from + 1 ? ', ' : '–'}${to + 1}`))
    .join(', ');
}

/** @param {string} words @returns {number[] | null} from 0; null if it is no list of numbers */
export function numbersIn(words) {
  const found = [];
  for (const part of words.split(/[\s,;]+/).filter(Boolean)) {
    const [, from, to = from] = /^(\d+)(?:[-–](\d+))?$/.exec(part) ?? [];
    if (from === undefined || Number(from) < 1 || Number(to) - Number(from) > MOST) return null;
    for (let number = Number(from); number <= Number(to); number++) found.push(number - 1);
  }
  return found;
}
