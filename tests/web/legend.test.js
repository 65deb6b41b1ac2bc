// SPDX-License-Identifier: MIT
/**
 * @file What a legend shows: how values are spread over the area of a torus, ranges that are given, and numbers that do not
 * overlap.
 */
import { describe, expect, test } from '@jest/globals';
import { histogram, valuesOf, vertexAreas } from '../../web/colour/histogram.js';
import { deviation, energyDecades, placeOf, quantityOf, sampleValues, valueAt } from '../../web/colour/quantities.js';
import { decadeRange, givenDecades, givenRange, middleOf, problemOfRange, shareBelow } from '../../web/colour/range.js';
import { labelsWithRoom } from '../../web/colour/ticks.js';
import { torusMesh } from '../../web/pages/torus/mesh.js';

/** @param {import('../../web/colour/quantities.js').Shading} shading */
function quantity(shading) {
  const found = quantityOf(shading);
  if (!found) throw new Error(`there is no quantity ${shading}`);
  return found;
}

describe('the values on a torus with radii 1 and 0.4, up to a factor', () => {
  const ratio = 0.4;
  const mesh = torusMesh(ratio);
  const areas = vertexAreas(mesh.positions, mesh.triangles);
  const gauss = valuesOf(quantity('gaussian'), mesh.curvatures, null);
  /** @param {number} low @param {number} high @param {number} steps */
  const spread = (low, high, steps) => {
    const found = histogram(gauss, areas, { low, high }, steps);
    if (!found) throw new Error('nothing has a value');
    return found;
  };

  test('belong to its whole area, that of the unit sphere', () => {
    expect(areas.reduce((sum, area) => sum + area, 0) / (4 * Math.PI)).toBeCloseTo(1, 2);
  });

  test('have a negative Gaussian curvature on 1/2 − r/πR of it', () => {
    const { below, above, shares } = spread(0, 1e9, 4);
    expect(below).toBeCloseTo(0.5 - ratio / Math.PI, 2);
    expect(above).toBe(0);
    expect(below + shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 12);
  });

  test('are counted by area, not by vertices, in equal steps of the range', () => {
    // K = cos t / (r (R + r cos t)), and the area below an angle t from the inside grows by R + r cos t.
    const [inner, outer] = [gauss.reduce((a, b) => Math.min(a, b)), gauss.reduce((a, b) => Math.max(a, b))];
    const { shares } = spread(inner, outer, 2);
    const scale = outer * ratio * (1 + ratio); // 1 / (size of the torus)²
    const middle = ((inner + outer) / 2 / scale) * ratio;
    const cosine = middle / (1 - middle * ratio);
    const t = Math.acos(cosine);
    expect(shares[1]).toBeCloseTo((t + ratio * Math.sin(t)) / Math.PI, 1);
    expect(shares[0] + shares[1]).toBeCloseTo(1, 12);
  });

  test('are those of the deviation where that is the quantity, and do not count where there are none', () => {
    const computed = new Float32Array(areas.length).fill(NaN);
    expect(histogram(valuesOf(deviation, mesh.curvatures, computed), areas, { low: -1, high: 1 }, 3)).toBeNull();
    computed[7] = 0.9;
    expect([...(histogram(computed, areas, { low: -1, high: 1 }, 3)?.shares ?? [])]).toEqual([0, 0, 1]);
    expect(valuesOf(deviation, mesh.curvatures, null).every(Number.isNaN)).toBe(true);
  });
});

describe('a range that is given', () => {
  test.each([
    [-0.5, 4, [-0.5, 0, 2, 4]],
    [0.91, 1.13, [0.91, 1, 1.1, 1.13]],
    [-3, 3, [-3, -2, 0, 2, 3]],
  ])('from %d to %d keeps its ends, with round numbers between them', (low, high, ticks) => {
    expect(givenRange(low, high)).toEqual({ low, high, ticks });
  });

  test('has the middle of its colours at 0 if that is inside and the quantity has a sign', () => {
    expect(middleOf(true, { low: -1, high: 3 })).toBe(0);
    expect(middleOf(false, { low: -1, high: 3 })).toBe(1);
    expect(middleOf(true, { low: 1, high: 3 })).toBe(2);
  });

  test('is refused where it is no range', () => {
    expect(problemOfRange(1, 2)).toBeNull();
    expect(problemOfRange(NaN, 2)).toMatch('numbers');
    expect(problemOfRange(2, 2)).toMatch('less');
    expect(problemOfRange(1, 1 + 1e-15)).toMatch('less');
  });
});

describe('colours by decades', () => {
  const logarithms = (/** @type {number[]} */ ...values) => Float64Array.from(values, Math.log10);

  test('span whole ones around most of the values, at least one and not too many', () => {
    expect(decadeRange(logarithms(0.02, 0.5, 3, 40, 70))).toEqual({ low: -2, high: 2, ticks: [-2, -1, 0, 1, 2] });
    expect(decadeRange(logarithms(10, 10, 10))).toEqual({ low: 0, high: 1, ticks: [0, 1] });
    expect(decadeRange(logarithms(1e-30, 1e-20, 1e3))).toMatchObject({ low: -5, high: 3 });
    expect(decadeRange(new Float64Array(0)).ticks).toEqual([-1, 0, 1]);
    const most = Float64Array.from({ length: 1000 }, (_, i) => (i < 5 ? 9 : -0.5));
    expect(decadeRange(most)).toMatchObject({ low: -1, high: 0 });
  });

  test('have each decade as wide as any other, and none for 0', () => {
    const densities = Float32Array.of(0.1, 1, 10, 100, 0);
    const places = valuesOf(energyDecades, new Float32Array(10), densities);
    const shares = [...places].map((place) => shareBelow(false, { low: -1, high: 2 }, place));
    [0, 1 / 3, 2 / 3, 1].forEach((share, i) => expect(shares[i]).toBeCloseTo(share, 6));
    expect(shares[4]).toBe(-Infinity);
    expect([...sampleValues(energyDecades, new Float32Array(10), densities)].map(Math.round)).toEqual([-1, 0, 1, 2]);
    expect(histogram(places, Float64Array.of(1, 1, 1, 1, 1), { low: -1, high: 2 }, 3)).toMatchObject({ below: 0.2 });
    expect(valueAt(energyDecades, placeOf(energyDecades, 0.037))).toBeCloseTo(0.037, 12);
  });

  test('that are given keep their ends', () => {
    expect(givenDecades(-1.5, 2.2).ticks).toEqual([-1.5, -1, 0, 1, 2, 2.2]);
    expect(givenDecades(0.1, 0.4).ticks).toEqual([0.1, 0.4]);
    expect(givenDecades(-6, 6).ticks).toEqual([-6, -3, 0, 3, 6]);
  });
});

test('the colours of a signed quantity meet at 0, however far its ends are', () => {
  const range = { low: -1, high: 3 };
  expect([-1, -0.5, 0, 1.5, 3].map((value) => shareBelow(true, range, value))).toEqual([0, 0.25, 0.5, 0.75, 1]);
  expect(shareBelow(false, range, 0)).toBe(0.25);
});

describe('the numbers of a legend', () => {
  test('that have no room are left out, the ends last', () => {
    const at = [0, 0.25, 0.5, 0.75, 1];
    expect(labelsWithRoom(at, [20, 20, 20, 20, 20], 248, 6)).toEqual([true, true, true, true, true]);
    expect(labelsWithRoom(at, [60, 60, 60, 60, 60], 248, 6)).toEqual([true, false, true, false, true]);
    expect(labelsWithRoom(at, [130, 130, 130, 130, 130], 248, 6)).toEqual([true, false, false, false, false]);
    expect(labelsWithRoom([0, 0.02, 1], [20, 10, 20], 248, 6)).toEqual([true, false, true]);
    expect(labelsWithRoom([], [], 248, 6)).toEqual([]);
  });
});
