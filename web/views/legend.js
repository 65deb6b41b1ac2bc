// SPDX-License-Identifier: MIT
/**
 * @file The legend: the menu of quantities that can colour the surfaces, the colours and their numbers. Also chooses
 * the range of the colours, common to all surfaces, unless it is pinned.
 */
import { histogram, valuesOf, vertexAreas } from '../colour/histogram.js';
import { deviation, patterns, placeOf, quantities, quantityOf, sampleValues } from '../colour/quantities.js';
import {
  calmRange,
  decadeRange,
  fullRange,
  givenDecades,
  givenRange,
  robustRange,
  sameRange,
} from '../colour/range.js';
import { element, find, whenChanged } from './dom.js';
import { createRangeView } from './legend_range.js';
import { STEPS, createScale } from './legend_scale.js';

/** @import {Quantity, Shading} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */
/** @import {Ends} from './legend_range.js' */

/**
 * The input of the legend.
 * @typedef {object} Shaded
 * @property {Shading} shading
 * @property {Float32Array[]} curvatures κ1, κ2 per vertex of every surface that the legend applies to
 * @property {Float32Array | null} [computed] per vertex, where they are no function of curvatures
 * @property {string} occasion as long as it stays the same, the range changes rarely
 * @property {{positions: Float32Array, triangles: Uint32Array} | null} [mesh] of the only surface, for how its values are spread
 * @property {Ends | null} [pinned] the range, if it is pinned
 * @property {boolean} [isolines] whether the surface has isolines
 */

/** The values of a point that is pointed at. @typedef {{kappa1: number, kappa2: number, computed: number | null}} Reading */

/**
 * @param {HTMLElement} root
 * @param {object} options
 * @param {(shading: Shading) => void} options.choose
 * @param {(quantity: Quantity) => string} [options.unit] the unit of the numbers, in words
 * @param {Quantity[]} [options.offered]
 * @param {(ends: Ends | null) => void} [options.pin] without it, the range cannot be pinned
 */
export function createLegendView(
  root,
  { choose, unit = (quantity) => `in ${quantity.unit}`, offered = quantities, pin },
) {
  const listening = new AbortController();
  const select = /** @type {HTMLSelectElement} */ (find(root, '[name=shading]'));
  const scale = createScale(find(root, 'figure'));
  const rangeView = pin && createRangeView(root, pin);
  select.append(
    ...[...offered, ...patterns].map(({ shading, name }) => element('option', { value: shading }, name)),
    element('option', { value: 'plain' }, 'Plain'),
  );
  select.addEventListener('change', () => choose(/** @type {Shading} */ (select.value)), { signal: listening.signal });

  const measured = createMeasure();
  const show = whenChanged(scale.show);
  const spread = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {Range | null} */ range,
      /** @type {Shaded['mesh'] | null} */ mesh,
      /** @type {Float32Array | null} */ curvatures,
      /** @type {Float32Array | null} */ computed,
    ) => {
      if (!quantity || !range || !mesh || !curvatures) return scale.fill(null);
      const areas = vertexAreas(mesh.positions, mesh.triangles);
      scale.fill(histogram(valuesOf(quantity, curvatures, computed), areas, range, STEPS));
    },
  );
  const given = memo((/** @type {Quantity} */ { axis }, /** @type {number} */ low, /** @type {number} */ high) =>
    axis ? givenDecades(low, high) : givenRange(low, high),
  );
  /** @type {Quantity | null} */
  let quantity = null;

  return {
    /** @param {Shaded} shaded @returns {Range | null} the range of the colours */
    update({ shading, curvatures, computed = null, occasion, mesh = null, pinned = null, isolines = false }) {
      quantity = quantityOf(shading);
      const free = measured(quantity, `${shading} ${occasion}`, computed, curvatures);
      const range = quantity && pinned ? given(quantity, pinned.low, pinned.high) : free;
      select.value = shading;
      show(quantity, range, quantity ? unit(quantity) : '', isolines);
      spread(quantity, range, mesh, curvatures[0] ?? null, computed);
      rangeView?.update(quantity, range, pinned !== null);
      return range;
    },

    /** Marks a value in the colours. @param {Reading | null} reading */
    mark(reading) {
      if (!reading || !quantity) return scale.mark(null);
      const { kappa1, kappa2, computed } = reading;
      scale.mark(quantity.value ? quantity.value(kappa1, kappa2) : computed && placeOf(quantity, computed));
    },

    dispose() {
      listening.abort();
      rangeView?.dispose();
    },
  };
}

/**
 * The last result again for the same arguments.
 * @template {unknown[]} A
 * @template T
 * @param {(...args: A) => T} work
 * @returns {(...args: A) => T}
 */
function memo(work) {
  /** @type {T} */
  let result;
  const renew = whenChanged((/** @type {A} */ ...args) => (result = work(...args)));
  return (...args) => {
    renew(...args);
    return result;
  };
}

/** The range of the values. @param {Quantity} quantity @param {Float32Array | null} computed @param {Float32Array[]} curvatures */
function rangeOf(quantity, computed, curvatures) {
  if (quantity === deviation && computed) return fullRange(computed);
  const places = joined(curvatures.map((one) => sampleValues(quantity, one, computed)));
  return quantity.axis ? decadeRange(places) : robustRange(places, quantity.signed);
}

/** The range that fits most of the values, which changes rarely on one occasion. */
function createMeasure() {
  /** @type {Range | null} */
  let range = null;
  let lastOccasion = '';
  const measure = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {string} */ occasion,
      /** @type {Float32Array | null} */ computed,
      /** @type {Float32Array[]} */ ...curvatures
    ) => {
      if (!quantity || !curvatures.length || (!quantity.value && !computed)) {
        range = null;
        return;
      }
      const next = rangeOf(quantity, computed, curvatures);
      const wanted = occasion === lastOccasion ? calmRange(range, next) : next;
      // Keeps the same object while the range is the same, since a new one would cause a redraw.
      if (!range || !sameRange(range, wanted)) range = wanted;
      lastOccasion = occasion;
    },
  );
  return (
    /** @type {Quantity | null} */ quantity,
    /** @type {string} */ occasion,
    /** @type {Float32Array | null} */ computed,
    /** @type {Float32Array[]} */ curvatures,
  ) => {
    measure(quantity, occasion, computed, ...curvatures);
    return range;
  };
}

/** @param {Float64Array[]} parts @returns {Float64Array} */
function joined(parts) {
  const all = new Float64Array(parts.reduce((length, part) => length + part.length, 0));
  parts.reduce((start, part) => {
    all.set(part, start);
    return start + part.length;
  }, 0);
  return all;
}
