// SPDX-License-Identifier: MIT
/**
 * @file The picture in a legend: how the values are spread over the area, their colours, and their numbers, with a mark at
 * the value that is pointed at.
 */
import { mapGradient } from '../colour/maps.js';
import { isolineStep, middleOf } from '../colour/range.js';
import { valueAt } from '../colour/quantities.js';
import { labelsWithRoom } from '../colour/ticks.js';
import { compact, percent } from '../words/numbers.js';
import { element, setText } from './dom.js';
import { svg } from './svg.js';

/** @import {Histogram} from '../colour/histogram.js' */
/** @import {Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/** Steps of the histogram, which is drawn as high as HEIGHT of them. */
export const STEPS = 62;
const HEIGHT = 7;
/** The least distance of two numbers, in CSS pixels. */
const GAP = 6;

/** The outline of the histogram, in units of its steps. @param {Float64Array} shares */
function outline(shares) {
  const most = shares.reduce((largest, share) => Math.max(largest, share), 0);
  if (!(most > 0)) return '';
  const heights = [...shares].map((share) => HEIGHT * (1 - share / most));
  return `M0 ${HEIGHT}${heights.map((y) => `V${y.toFixed(3)}h1`).join('')}V${HEIGHT}z`;
}

/** What lies outside of the colours, in words. @param {Histogram} histogram */
function outsideWords({ below, above }) {
  const outside = below + above;
  return outside < 5e-4 ? 'all of it within the colours' : `${percent(outside)} of it beyond the colours`;
}

/** @param {HTMLElement} figure is filled with the scale */
export function createScale(figure) {
  const curve = svg('path', {});
  const spread = svg(
    'svg',
    { class: 'spread', viewBox: `0 0 ${STEPS} ${HEIGHT}`, preserveAspectRatio: 'none', role: 'img' },
    curve,
  );
  const mark = element('span', { class: 'mark', hidden: '' });
  const colours = element('div', { class: 'colours' }, mark);
  const ticks = element('div', { class: 'ticks' });
  const caption = element('figcaption');
  figure.replaceChildren(spread, colours, ticks, caption);
  /** @type {Range | null} */
  let shown = null;

  /** @param {number} value */
  const place = (value) => (shown ? (value - shown.low) / (shown.high - shown.low) : 0);

  /** @param {Quantity} quantity @param {Range} range */
  function showTicks(quantity, range) {
    const positions = range.ticks.map(place);
    const labels = range.ticks.map((tick) => element('span', {}, compact(valueAt(quantity, tick))));
    labels.forEach((label, i) => (label.style.left = `${(100 * positions[i]).toFixed(2)}%`));
    ticks.replaceChildren(...labels);
    const widths = labels.map((label) => label.getBoundingClientRect().width);
    const kept = labelsWithRoom(positions, widths, ticks.getBoundingClientRect().width, GAP);
    labels.forEach((label, i) => kept[i] || label.remove());
  }

  return {
    /** @param {Quantity | null} quantity @param {Range | null} range @param {string} unit @param {boolean} isolines */
    show(quantity, range, unit, isolines) {
      figure.hidden = !quantity || !range;
      if (!quantity || !range) return;
      shown = range;
      colours.style.background = mapGradient(quantity.map, 'to right', place(middleOf(quantity.signed, range)));
      const each = `${quantity.axis ? 'factor ' : ''}${compact(valueAt(quantity, isolineStep(range)))}`;
      setText(caption, `${quantity.symbol}, ${unit}${isolines ? `; a line each ${each}` : ''}`);
      showTicks(quantity, range);
    },

    /** @param {Histogram | null} histogram */
    fill(histogram) {
      spread.toggleAttribute('hidden', !histogram);
      if (!histogram) return;
      curve.setAttribute('d', outline(histogram.shares));
      const words = `The area by value, ${outsideWords(histogram)}`;
      spread.setAttribute('aria-label', words);
    },

    /** @param {number | null} value that is marked */
    mark(value) {
      mark.hidden = value === null || !shown || Number.isNaN(value);
      if (value !== null) mark.style.left = `${(100 * Math.min(1, Math.max(0, place(value)))).toFixed(2)}%`;
    },
  };
}
