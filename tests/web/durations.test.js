// SPDX-License-Identifier: MIT
/**
 * @file How long a run takes, in words.
 */
import { describe, expect, test } from '@jest/globals';
import { estimateWords, leftWords, patienceWords, roughDuration } from '../../web/words/durations.js';

/** @param {...[number, number]} levels seconds and bytes of each, from level 1 on */
const estimate = (...levels) => ({
  levels: levels.map(([seconds, bytes], i) => {
    return { level: i + 1, patches: 96, unknowns: 282, evaluations: 60, seconds, bytes };
  }),
  seconds: levels.reduce((sum, [seconds]) => sum + seconds, 0),
  bytes: Math.max(...levels.map(([, bytes]) => bytes)),
});

describe('a rough duration', () => {
  test.each([
    [0, 'a second'],
    [1.4, 'a second'],
    [1.6, 'about 2 s'],
    [8.2, 'about 8 s'],
    [9.6, 'about 10 s'],
    [18, 'about 20 s'],
    [57, 'about 55 s'],
    [58, 'about a minute'],
    [100, 'about 2 min'],
    [190, 'about 3 min'],
    [1000, 'about 15 min'],
    [3500, 'about an hour'],
    [8000, 'about 2 h'],
    [200_000, 'about 2 days'],
    [NaN, 'unknown'],
  ])('of %d s is %s', (seconds, words) => expect(roughDuration(seconds)).toBe(words));

  test('never becomes shorter as seconds grow', () => {
    /** @type {Record<string, number>} */
    const units = { s: 1, min: 60, h: 3600, days: 86_400, second: 1, minute: 60, hour: 3600 };
    let before = 0;
    for (let seconds = 0.1; seconds < 1e6; seconds *= 1.01) {
      const [, count, unit] = /** @type {string[]} */ (/^(?:about )?(a|an|\d+) (\w+)$/.exec(roughDuration(seconds)));
      const said = (count.startsWith('a') ? 1 : Number(count)) * units[unit];
      expect(said).toBeGreaterThanOrEqual(before);
      if (seconds > 1) expect(Math.abs(Math.log(said / seconds))).toBeLessThan(Math.log(1.55));
      before = said;
    }
  });
});

test('what a run takes and what is left of it are said alike', () => {
  expect(estimateWords(estimate([2, 1e6], [6, 2e6]))).toBe('Takes about 8 s');
  expect(leftWords(5)).toBe('about 5 s left');
  expect(leftWords(0.3)).toBe('a second left');
  expect(leftWords(NaN)).toBe('');
});

describe('a warning', () => {
  test('is not given for a run of two minutes', () => expect(patienceWords(estimate([20, 1e6], [100, 2e6]))).toBe(''));

  test('names the level that takes longest', () => {
    expect(patienceWords(estimate([20, 1e6], [220, 2e6]))).toBe(
      'This will take about 4 min, of which level 2 takes about 4 min. Fewer levels take less.',
    );
    expect(patienceWords(estimate([300, 1e6]))).toBe('This will take about 5 min.');
  });

  test('tells the memory of the last level where that is much', () => {
    expect(patienceWords(estimate([1, 1e8], [2, 1.2e9]))).toBe(
      'This will take about 3 s, of which level 2 takes about 2 s. Level 2 takes 1.2 GB of memory, which not every browser gives. Fewer levels take less.',
    );
  });

  test('is not given of what has no levels', () => expect(patienceWords(estimate())).toBe(''));
});
