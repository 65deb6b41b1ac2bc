// SPDX-License-Identifier: MIT
/**
 * @file The legend: the menu of quantities that can colour the surfaces, the colours and their numbers. Also chooses
 * the range of the colours, common to all surfaces.
 */
import { mapGradient } from '../colour/maps.js';
import { patterns, quantities, quantityOf, sampleValues } from '../colour/quantities.js';
import { calmRange, fullRange, robustRange, sameRange } from '../colour/range.js';
import { compact } from '../words/numbers.js';
import { element, find, setText, whenChanged } from './dom.js';

/** @import {Quantity, Shading} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/**
 * The input of the legend.
 * @typedef {object} Shaded
 * @property {Shading} shading
 * @property {Float32Array[]} curvatures κ1, κ2 per vertex of every surface that the legend applies to
 * @property {Float32Array | null} [deviations] per vertex, where the deviation is shown
 * @property {string} occasion as long as it stays the same, the range changes rarely
 */

/**
 * @param {HTMLElement} root
 * @param {(shading: Shading) => void} choose
 * @param {(quantity: Quantity) => string} [unit] the unit of the numbers, in words
 * @param {Quantity[]} [offered]
 */
export function createLegendView(root, choose, unit = (quantity) => `in ${quantity.unit}`, offered = quantities) {
  const listening = new AbortController();
  const select = /** @type {HTMLSelectElement} */ (find(root, '[name=shading]'));
  const figure = find(root, 'figure');
  const bar = find(root, '.bar');
  const ticks = find(root, '.ticks');
  const caption = find(root, 'figcaption');
  select.append(
    ...[...offered, ...patterns].map(({ shading, name }) => element('option', { value: shading }, name)),
    element('option', { value: 'plain' }, 'Plain'),
  );
  select.addEventListener('change', () => choose(/** @type {Shading} */ (select.value)), { signal: listening.signal });

  const show = whenChanged((/** @type {Quantity | null} */ quantity, /** @type {Range | null} */ range) => {
    figure.hidden = !quantity || !range;
    if (!quantity || !range) return;
    bar.style.background = mapGradient(quantity.map, 'to right');
    setText(caption, `${quantity.symbol}, ${unit(quantity)}`);
    ticks.replaceChildren(
      ...range.ticks.map((tick) => {
        const position = (100 * (tick - range.low)) / (range.high - range.low);
        return element('span', { style: `left: ${position.toFixed(2)}%` }, compact(tick));
      }),
    );
  });

  /** @type {Range | null} */
  let range = null;
  let lastOccasion = '';
  const measure = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {string} */ occasion,
      /** @type {Float32Array | null} */ deviations,
      /** @type {Float32Array[]} */ ...curvatures
    ) => {
      if (!quantity || !curvatures.length || (!quantity.value && !deviations)) {
        range = null;
        return;
      }
      const next =
        quantity.value || !deviations
          ? robustRange(joined(curvatures.map((one) => sampleValues(quantity, one))), quantity.signed)
          : fullRange(deviations);
      const wanted = occasion === lastOccasion ? calmRange(range, next) : next;
      // Keeps the same object while the range is the same, since a new one would cause a redraw.
      if (!range || !sameRange(range, wanted)) range = wanted;
      lastOccasion = occasion;
    },
  );

  return {
    /** @param {Shaded} shaded @returns {Range | null} the range of the colours */
    update({ shading, curvatures, deviations = null, occasion }) {
      const quantity = quantityOf(shading);
      measure(quantity, `${shading} ${occasion}`, deviations, ...curvatures);
      select.value = shading;
      show(quantity, range);
      return range;
    },
    dispose: () => listening.abort(),
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
