// SPDX-License-Identifier: MIT
/**
 * @file The values at a point of a surface that a ray meets, against those of a torus.
 */
import { describe, expect, test } from '@jest/globals';
import { torusMesh } from '../../web/pages/torus/mesh.js';
import { PART, boxesOf } from '../../web/scene/boxes.js';
import { pick } from '../../web/scene/pick.js';
import { readingAt } from '../../web/scene/reading.js';
import { readingWords } from '../../web/words/reading.js';

const ratio = 0.4;
const large = 1 / Math.sqrt(Math.PI * ratio);
const small = ratio * large;
const mesh = { ...torusMesh(ratio), faces: new Uint32Array(24_576), centre: Float64Array.of(1e6, -2, 0.5) };

/** The values at angle θ around the tube, where a ray from inside the tube leaves it. @param {number} theta */
function at(theta) {
  const along = 1.234;
  const out = [Math.cos(along) * Math.cos(theta), Math.sin(along) * Math.cos(theta), Math.sin(theta)];
  const [x, y] = [large * Math.cos(along), large * Math.sin(along)];
  const hit = pick(mesh, [x, y, 0], /** @type {[number, number, number]} */ (out));
  if (!hit) throw new Error('the ray meets nothing');
  const distances = mesh.positions.filter((_, i) => i % 3 === 2); // the height above the plane
  return {
    hit,
    reading: readingAt(mesh, distances, hit),
    expected: [x + small * out[0], y + small * out[1], small * out[2]],
  };
}

describe('the reading at a point of a torus', () => {
  test.each([0.1, 1, 2, 3, 4.4])('at angle %d is that of its formulas', (theta) => {
    const { reading, expected, hit } = at(theta);
    expect(hit.weights.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 12);
    const distance = large + small * Math.cos(theta);
    expect(reading.kappa1).toBeCloseTo(1 / small, 4);
    // The mesh has 64 points around the tube; the error of linear interpolation is about (2π/64)²/8 of the second derivative.
    expect(Math.abs(reading.kappa2 - Math.cos(theta) / distance)).toBeLessThan(0.006);
    expect(Math.abs((reading.computed ?? 0) - small * Math.sin(theta))).toBeLessThan(0.002);
    reading.point.forEach((value, axis) => {
      expect(Math.abs(value - mesh.centre[axis] - expected[axis])).toBeLessThan(0.002);
    });
  });

  test('is said with the mean and the Gaussian curvature', () => {
    const { curvatures, place } = readingWords({ kappa1: 2, kappa2: -0.5, computed: null, point: [1, -2, 0] }, null);
    expect(curvatures.replaceAll('\u00a0', ' ')).toBe(
      'κ₁ 2.000, κ₂ −0.5000, H 0.7500 per length, K −1.000 per length²',
    );
    expect(place).toBe('at (1.000, −2.000, 0)');
    /** @type {Parameters<typeof readingWords>[0]} */
    const computed = { kappa1: 2, kappa2: 0, computed: 0.25, point: [1, -2, 0] };
    expect(readingWords(computed, 'deviation').place).toMatch('moved by 0.2500');
    expect(readingWords(computed, 'energy').place).toBe(
      'energy density\u00a00.2500 per length², at (1.000, −2.000, 0)',
    );
  });
});

test('boxes let most triangles be left out, and hide none', () => {
  const boxes = boxesOf(mesh);
  expect(boxes.length).toBe((6 * mesh.triangles.length) / (3 * PART));
  // One box around everything finds the same.
  const all = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  for (let i = 0; i < boxes.length; i += 6) {
    for (let axis = 0; axis < 3; axis++) {
      all.low[axis] = Math.min(all.low[axis], boxes[i + axis]);
      all.high[axis] = Math.max(all.high[axis], boxes[i + 3 + axis]);
    }
  }
  const open = new Float64Array(boxes.length);
  for (let i = 0; i < boxes.length; i += 6) open.set([...all.low, ...all.high], i);
  const eye = /** @type {[number, number, number]} */ ([2, 1.5, 1]);
  let met = 0;
  for (let k = 0; k < 60; k++) {
    const direction = /** @type {[number, number, number]} */ ([-2 + Math.sin(k), -1.5 + Math.cos(2 * k), -1 + k / 60]);
    const hit = pick(mesh, eye, direction, { boxes });
    expect(hit).toEqual(pick(mesh, eye, direction, { boxes: open }));
    if (hit) met++;
  }
  expect(met).toBeGreaterThan(20);
  expect(met).toBeLessThan(60);
  // Along an axis, a ray lies within planes of boxes.
  expect(pick(mesh, [large, 0, 5], [0, 0, -1], { boxes })?.point[2]).toBeCloseTo(small, 2);
});

describe('where a plane has cut the surface away, a ray', () => {
  /** The torus meets the ray along its x axis in these places. */
  const places = [large + small, large - small, small - large, -small - large];
  /** @param {number} x where the plane is @param {1 | -1} side of it that stays */
  const beyond = (x, side) => ({ normal: { x: side, y: 0, z: 0 }, constant: -side * x });
  /** The place that is met, infinity for none. @param {ReturnType<typeof beyond>} space @param {1 | -1} from which end */
  const met = (space, from) => pick(mesh, [5 * from, 0, 0], [-2 * from, 0, 0], { space })?.point[0] ?? Infinity;

  test('meets the first of what stays, from both sides of the plane', () => {
    for (const [i, place] of places.entries()) {
      const before = place + 0.5 * small;
      expect(met(beyond(before, -1), 1)).toBeCloseTo(place, 3);
      expect(met(beyond(before, -1), -1)).toBeCloseTo(places[3], 3);
      expect(met(beyond(before, 1), 1)).toBeCloseTo(i > 0 ? places[0] : Infinity, 3);
      expect(met(beyond(before, 1), -1)).toBeCloseTo(places[i - 1] ?? Infinity, 3);
    }
  });

  test('along the plane meets all or nothing', () => {
    const along = (/** @type {1 | -1} */ side) =>
      pick(mesh, [5, 0, 0], [-1, 0, 0], { space: { normal: { x: 0, y: side, z: 0 }, constant: -side * 0.01 } });
    expect(along(-1)?.point[0]).toBeCloseTo(places[0], 3);
    expect(along(1)).toBeNull();
  });
});
