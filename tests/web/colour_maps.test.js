// SPDX-License-Identifier: MIT
/**
 * @file The colour maps are what they claim: uniform for the eye, symmetric where signs are told apart, and shown by
 * every screen.
 */
import { describe, expect, test } from '@jest/globals';
import { MAP_SIZE, mapBytes, mapColours, mapGradient } from '../../web/colour/maps.js';
import { decode, distance, encode, fromLinearRgb, toLinearRgb } from '../../web/colour/oklab.js';

/** @typedef {import('../../web/colour/oklab.js').Triple} Triple */

/** @param {Triple[]} colours */
const steps = (colours) => colours.slice(1).map((colour, i) => distance(colour, colours[i]));

describe('OKLab', () => {
  test('is (1, 0, 0) for white and (0, 0, 0) for black', () => {
    const white = fromLinearRgb([1, 1, 1]);
    // The published matrices have ten digits, and their rows sum to one to eight.
    expect(distance(white, [1, 0, 0])).toBeLessThan(1e-7);
    expect(distance(fromLinearRgb([0, 0, 0]), [0, 0, 0])).toBe(0);
  });

  test('has the published value for the red of sRGB', () => {
    expect(distance(fromLinearRgb([1, 0, 0]), [0.6279554, 0.2248631, 0.1258463])).toBeLessThan(1e-6);
  });

  test('and linear sRGB are inverse to each other', () => {
    for (const rgb of /** @type {Triple[]} */ ([
      [0.2, 0.4, 0.7],
      [0.9, 0.1, 0.05],
      [0.01, 0.02, 0.03],
    ])) {
      expect(distance(toLinearRgb(fromLinearRgb(rgb)), rgb)).toBeLessThan(1e-6);
    }
  });

  test('the transfer function and its inverse agree, and meet at the linear part', () => {
    for (let value = 0; value <= 1; value += 0.01) expect(decode(encode(value))).toBeCloseTo(value, 6);
  });
});

describe.each(/** @type {const} */ (['diverging', 'sequential']))('the %s map', (name) => {
  const colours = mapColours(name);

  test('has its size and stays within what sRGB can show', () => {
    expect(colours).toHaveLength(MAP_SIZE);
    for (const colour of colours) {
      for (const component of toLinearRgb(colour)) {
        expect(component).toBeGreaterThanOrEqual(0);
        expect(component).toBeLessThanOrEqual(1);
      }
    }
  });

  test('is opaque bytes of the same colours', () => {
    const bytes = mapBytes(name);
    expect(bytes).toHaveLength(4 * MAP_SIZE);
    colours.forEach((colour, i) => {
      const shown = /** @type {Triple} */ ([...bytes.subarray(4 * i, 4 * i + 3)].map((byte) => decode(byte / 255)));
      // Half a byte of sRGB is at most this far in OKLab.
      expect(distance(fromLinearRgb(shown), colour)).toBeLessThan(0.004);
      expect(bytes[4 * i + 3]).toBe(255);
    });
  });

  test('is a CSS gradient from its first to its last colour', () => {
    const bytes = mapBytes(name);
    const gradient = mapGradient(name, 'to right');
    const end = 4 * (MAP_SIZE - 1);
    const [middle] = /rgb\(\S+ \S+ \S+\) 50\.00%/.exec(gradient) ?? [''];
    expect(mapGradient(name, 'to right', 0.25)).toContain(middle.replace('50.00%', '25.00%'));
    expect(middle).not.toBe('');
    expect(gradient.startsWith(`linear-gradient(to right, rgb(${bytes[0]} ${bytes[1]} ${bytes[2]})`)).toBe(true);
    expect(gradient.endsWith(`rgb(${bytes[end]} ${bytes[end + 1]} ${bytes[end + 2]}) 100.00%)`)).toBe(true);
  });
});

test('equal steps of the sequential map are equal steps for the eye, and it grows lighter', () => {
  const colours = mapColours('sequential');
  const sizes = steps(colours);
  expect(Math.max(...sizes) / Math.min(...sizes)).toBeLessThan(1.01);
  for (let i = 1; i < MAP_SIZE; i++) expect(colours[i][0]).toBeGreaterThan(colours[i - 1][0]);
});

test('equal steps of each half of the diverging map are equal steps for the eye', () => {
  const colours = mapColours('diverging');
  for (const half of [colours.slice(0, MAP_SIZE / 2), colours.slice(MAP_SIZE / 2)]) {
    const sizes = steps(half);
    expect(Math.max(...sizes) / Math.min(...sizes)).toBeLessThan(1.01);
  }
});

test('the diverging map is neutral at zero and as strong below as above', () => {
  const colours = mapColours('diverging');
  for (const [, a, b] of [colours[MAP_SIZE / 2 - 1], colours[MAP_SIZE / 2]])
    expect(Math.hypot(a, b)).toBeLessThan(1e-9);
  for (let i = 0; i < MAP_SIZE / 2; i++) {
    const [below, above] = [colours[i], colours[MAP_SIZE - 1 - i]];
    expect(below[0]).toBeCloseTo(above[0], 9);
    expect(Math.hypot(below[1], below[2])).toBeCloseTo(Math.hypot(above[1], above[2]), 9);
  }
  const [low, high] = [colours[0], colours[MAP_SIZE - 1]];
  expect(low[2]).toBeLessThan(-0.1); // blue
  expect(high[1]).toBeGreaterThan(0.1); // red
});
