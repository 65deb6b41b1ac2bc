// SPDX-License-Identifier: MIT
/**
 * @file Exponents, times and tables of the benchmark, for numbers whose results are known.
 */
import { describe, expect, test } from '@jest/globals';
import { digits, fitExponent, markdownTable, plainTable, reached, replaceBetween } from './tables.js';

describe('an exponent', () => {
  test('is that of a power law, whatever its factor', () => {
    const patches = [384, 1536, 6144, 24576];
    const seconds = patches.map((n) => 3e-6 * n ** 1.25);
    expect(fitExponent(patches, seconds)).toBeCloseTo(1.25, 12);
  });

  test('does not change with factors that are balanced about the middle', () => {
    expect(fitExponent([1, 10, 100], [2, 10 / 4, 200])).toBeCloseTo(1, 12);
  });
});

describe('an energy has been reached', () => {
  const steps = [20, 10.05, 9.9, 10.02, 10, 10].map((energy, i) => [i, i / 2, energy]);
  /** @param {number} tolerance */
  const at = (tolerance) => reached(/** @type {import('./tables.js').Step[]} */ (steps), 10, tolerance);

  test('where it comes to stay, not where it passes', () => {
    expect(at(0.007)).toEqual([3, 1.5, 10.02]);
    expect(at(0.001)).toEqual([4, 2, 10]);
  });

  test('at once, or never', () => {
    expect(at(2)).toEqual([0, 0, 20]);
    expect(reached([[0, 0, 11]], 10, 0.01)).toBeUndefined();
    expect(reached([[0, 0, NaN]], 10, 0.01)).toBeUndefined();
  });
});

describe('a table', () => {
  const table = { title: 'Seconds', head: ['shape', 's'], rows: [['two-3', 0.25], ['cube', 12]] }; // prettier-ignore

  test('is padded in the terminal', () => {
    expect(plainTable(table)).toBe('Seconds\n\nshape     s\ntwo-3  0.25\ncube     12\n');
  });

  test('has bars in Markdown', () => {
    expect(markdownTable(table)).toBe('Seconds\n\n| shape | s |\n|---|---|\n| two-3 | 0.25 |\n| cube | 12 |\n');
  });

  test('takes the place of the last one in a text', () => {
    expect(replaceBetween('a\n<!--\nold\n-->\nb', '<!--', '-->', 'new')).toBe('a\n<!--\nnew\n-->\nb');
    expect(() => replaceBetween('a', '<!--', '-->', 'new')).toThrow('expected the lines');
  });

  test('shows three digits of a time', () => {
    expect([0.012345, 1.2345, 123.45].map(digits)).toEqual(['0.0123', '1.23', '123']);
  });
});
