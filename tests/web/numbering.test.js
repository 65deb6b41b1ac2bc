// SPDX-License-Identifier: MIT
/** @file Lists of numbers as they are typed. */
import { expect, test } from '@jest/globals';
import { numbersIn, numbersWords } from '../../web/words/numbering.js';

test('numbers from 0 are written from 1, and ranges of three or more with a dash', () => {
  expect(numbersWords([])).toBe('');
  expect(numbersWords([0, 3, 4, 5, 7, 8])).toBe('1, 4–6, 8, 9');
});

test('what is written is read back, with either dash and any separators', () => {
  for (const numbers of [[], [4], [0, 1, 2, 3], [0, 2, 4, 5, 6, 9, 10]]) {
    expect(numbersIn(numbersWords(numbers))).toEqual(numbers);
  }
  expect(numbersIn(' 1;2-3  7,')).toEqual([0, 1, 2, 6]);
});

test('what is no list of numbers is none', () => {
  for (const words of ['x', '0', '-1', '1.5', '1–', '1-2-3', '1-99999999999']) expect(numbersIn(words)).toBeNull();
});
