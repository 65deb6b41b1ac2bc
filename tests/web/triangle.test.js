// SPDX-License-Identifier: MIT
/**
 * @file The plane of the triangle picker: places and shares, and keys.
 */
import { describe, expect, test } from '@jest/globals';
import { CENTRE, CORNERS, HEIGHT, movedByKey, placeOf, sharesAt } from '../../web/plot/triangle.js';
import { outsideWords, shareWords } from '../../web/words/blends.js';

/** @typedef {import('../../web/plot/triangle.js').Shares} Shares */

/** @type {Shares[]} */
const corners = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** @param {readonly number[]} found @param {readonly number[]} wanted */
function expectClose(found, wanted) {
  expect(found).toHaveLength(wanted.length);
  found.forEach((value, i) => expect(value).toBeCloseTo(wanted[i], 12));
}

/** Presses a key some times. @param {Shares} shares @param {string} key @param {number} [times] @param {boolean} [large] */
function pressed(shares, key, times = 1, large = false) {
  return Array.from({ length: times }).reduce(
    (/** @type {Shares} */ at) => /** @type {Shares} */ (movedByKey(at, key, large)),
    shares,
  );
}

describe('a place in the triangle', () => {
  test('has the shares whose place it is; corners and the middle have theirs', () => {
    corners.forEach((shares, i) => expectClose(placeOf(shares), CORNERS[i]));
    expectClose(placeOf(CENTRE), [0.5, (2 / 3) * HEIGHT]);
    for (const shares of /** @type {Shares[]} */ ([CENTRE, [0.2, 0.3, 0.5], [0, 0.25, 0.75], ...corners])) {
      expectClose(sharesAt(placeOf(shares)), shares);
    }
  });

  test('outside is the nearest one inside: on a side, or at a corner', () => {
    expectClose(sharesAt([0.25, HEIGHT + 0.3]), [0, 0.75, 0.25]);
    expectClose(sharesAt([0.5, -1]), [1, 0, 0]);
    expectClose(sharesAt([-1, HEIGHT + 0.1]), [0, 1, 0]);
    expectClose(sharesAt([2, HEIGHT]), [0, 0, 1]);
    // From the middle of the right side straight out.
    const [x, y] = placeOf([0.5, 0, 0.5]);
    expectClose(sharesAt([x + 0.1 * Math.cos(Math.PI / 6), y - 0.1 * Math.sin(Math.PI / 6)]), [0.5, 0, 0.5]);
  });
});

describe('keys', () => {
  test('move by a hundredth, with Shift by a tenth, and stay in the triangle', () => {
    expectClose(pressed([0.2, 0.3, 0.5], 'ArrowRight'), [0.2, 0.29, 0.51]);
    expectClose(pressed([0.2, 0.3, 0.5], 'ArrowLeft', 1, true), [0.2, 0.4, 0.4]);
    expectClose(pressed([0.2, 0.4, 0.4], 'ArrowUp', 2), [0.22, 0.39, 0.39]);
    expectClose(pressed([0.2, 0.3, 0.5], 'ArrowRight', 99), [0.2, 0, 0.8]);
    expectClose(pressed([0.2, 0.3, 0.5], 'ArrowUp', 99), [1, 0, 0]);
    expectClose(pressed([1, 0, 0], 'ArrowDown', 1, true), [0.9, 0.05, 0.05]);
    expectClose(pressed([0.2, 0.8, 0], 'ArrowDown', 9, true), [0, 1, 0]);
    expectClose(pressed([1, 0, 0], 'ArrowRight'), [1, 0, 0]);
  });

  test('put the point at corners and in the middle; others do nothing', () => {
    const from = /** @type {Shares} */ ([0.2, 0.3, 0.5]);
    expect(['1', '2', '3'].map((key) => movedByKey(from, key, false))).toEqual(corners);
    expect(['Home', 'End', '0'].map((key) => movedByKey(from, key, false))).toEqual([corners[0], corners[2], CENTRE]);
    expect(movedByKey(from, 'Tab', false)).toBeNull();
  });
});

test('shares are percents to a tenth, and what is at no corner is named', () => {
  expect([0, 0.333, 0.5, 1].map(shareWords)).toEqual(['0\u202f%', '33.3\u202f%', '50\u202f%', '100\u202f%']);
  expect(outsideWords([])).toBe('');
  expect(outsideWords(['mvs'])).toBe('MVS also weighs, at no corner: moving the point leaves it out.');
  expect(outsideWords(['mvs', 'mvs_cross', 'willmore'])).toMatch(
    /^MVS, MVS cross and Willmore also weigh, .* them out/,
  );
});
