// SPDX-License-Identifier: MIT
/**
 * @file The legend: which curvature the surface is shaded by, its colours and its numbers. It also decides the range of
 * the colours.
 */
import { mapGradient } from '../colour/maps.js';
import { quantities, quantityOf, sampleValues } from '../colour/quantities.js';
import { calmRange, robustRange, sameRange } from '../colour/range.js';
import { compact } from '../words/numbers.js';
import { element, find, setText, whenChanged } from './dom.js';

/** @import {Quantity, Shading} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */
/** @import {Action, State, Surface} from '../state/types.js' */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createLegendView(root, dispatch) {
  const listening = new AbortController();
  const select = /** @type {HTMLSelectElement} */ (find(root, '[name=shading]'));
  const figure = find(root, 'figure');
  const bar = find(root, '.bar');
  const ticks = find(root, '.ticks');
  const caption = find(root, 'figcaption');
  select.append(
    ...quantities.map(({ shading, name }) => element('option', { value: shading }, name)),
    element('option', { value: 'plain' }, 'Plain'),
  );
  select.addEventListener(
    'change',
    () => dispatch({ type: 'viewChanged', change: { shading: /** @type {Shading} */ (select.value) } }),
    { signal: listening.signal },
  );

  const show = whenChanged((/** @type {Quantity | null} */ quantity, /** @type {Range | null} */ range) => {
    figure.hidden = !quantity || !range;
    if (!quantity || !range) return;
    bar.style.background = mapGradient(quantity.map, 'to right');
    setText(caption, `${quantity.symbol}, in ${quantity.unit}`);
    ticks.replaceChildren(
      ...range.ticks.map((tick) => {
        const position = (100 * (tick - range.low)) / (range.high - range.low);
        return element('span', { style: `left: ${position.toFixed(2)}%` }, compact(tick));
      }),
    );
  });

  /** @type {Range | null} */
  let range = null;
  const measure = whenChanged(
    (/** @type {Quantity | null} */ quantity, /** @type {Surface | null} */ surface, /** @type {string} */ key) => {
      if (!quantity || !surface) {
        range = null;
        return;
      }
      const next = robustRange(sampleValues(quantity, surface.limit.curvatures), quantity.signed);
      const wanted = key === lastKey ? calmRange(range, next) : next;
      // The same range stays the same object: to shade anew is to draw anew.
      if (!range || !sameRange(range, wanted)) range = wanted;
      lastKey = key;
    },
  );
  let lastKey = '';

  return {
    /** @param {State} state */
    update(state) {
      const quantity = quantityOf(state.view.shading);
      // While the surface moves the range is calm; another quantity, another cage or a surface at rest gets its own.
      measure(quantity, state.surface, `${state.view.shading} ${state.run} ${state.status === 'running'}`);
      select.value = state.view.shading;
      show(quantity, range);
      return range;
    },
    dispose: () => listening.abort(),
  };
}
