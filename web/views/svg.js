// SPDX-License-Identifier: MIT
/**
 * @file What all plots share: creating SVG elements, and the marks of an axis.
 */
import { tickText } from '../words/numbers.js';

/** @import {Box} from '../plot/curves.js' */
/** @import {Scale} from '../plot/scales.js' */

const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param {string} tag
 * @param {Record<string, string | number>} attributes
 * @param {...(Node | string)} children
 */
export function svg(tag, attributes, ...children) {
  const created = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) created.setAttribute(name, String(value));
  created.append(...children);
  return created;
}

/**
 * For every tick, a line across the box and a number on its left.
 * @param {Scale} up
 * @param {Box} box
 */
export function valueTicks(up, box) {
  return up.ticks.flatMap((tick) => {
    const y = (box.y + (1 - up.position(tick)) * box.height).toFixed(1);
    return [
      svg('line', { class: 'grid', x1: box.x, x2: box.x + box.width, y1: y, y2: y }),
      svg('text', { x: box.x - 6, y, class: 'tick end' }, tickText(tick)),
    ];
  });
}
