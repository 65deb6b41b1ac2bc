// SPDX-License-Identifier: MIT
/**
 * @file The fields for the range of a legend's colours. What is typed there is pinned: it stays while the surface changes.
 */
import { placeOf, valueAt } from '../colour/quantities.js';
import { problemOfRange } from '../colour/range.js';
import { element, setText } from './dom.js';

/** @import {Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/** Two ends on the axis of the quantity, which stay until they are null. @typedef {Pick<Range, 'low' | 'high'>} Ends */

/** @param {string} text as the page prints numbers, or as they are typed */
const numberIn = (text) => (text.trim() ? Number(text.trim().replace('−', '-').replace(',', '.')) : NaN);

/** A number in a field, with as many digits as it is known with. @param {number} value */
const written = (value) => String(Number(value.toPrecision(6)));

/**
 * @param {HTMLElement} root of the legend; the fields are added to it
 * @param {(ends: Ends | null) => void} pin
 */
export function createRangeView(root, pin) {
  const listening = new AbortController();
  const { signal } = listening;
  const low = element('input', { name: 'low', inputmode: 'decimal', autocomplete: 'off', 'aria-label': 'Least value' });
  const high = element('input', {
    name: 'high',
    inputmode: 'decimal',
    autocomplete: 'off',
    'aria-label': 'Largest value',
  });
  const pinned = element('button', {
    type: 'button',
    class: 'quiet',
    title: 'Keep this range while the surface changes',
  });
  const reset = element(
    'button',
    { type: 'button', class: 'quiet', title: 'The range of most of the surface' },
    'Reset',
  );
  const problem = element('p', { class: 'problem', role: 'alert' });
  const summary = element('summary', {}, 'Range');
  const row = element('div', { class: 'row' }, low, 'to', high, pinned, reset);
  const details = element('details', { class: 'range' }, summary, row, problem);
  root.append(details);
  setText(pinned, 'Pin');
  /** @type {Range | null} */
  let shown = null;
  let isPinned = false;
  /** @type {Pick<Quantity, 'axis'>} */
  let shownOf = {};

  function typed() {
    const [from, to] = [numberIn(low.value), numberIn(high.value)];
    const ends = { low: placeOf(shownOf, from), high: placeOf(shownOf, to) };
    const wrong =
      shownOf.axis && Math.min(from, to) <= 0 ? 'Both ends must be above 0.' : problemOfRange(ends.low, ends.high);
    setText(problem, wrong ?? '');
    if (!wrong) pin(ends);
  }

  for (const field of [low, high]) field.addEventListener('change', typed, { signal });
  pinned.addEventListener('click', () => pin(isPinned || !shown ? null : { low: shown.low, high: shown.high }), {
    signal,
  });
  reset.addEventListener('click', () => pin(null), { signal });

  return {
    /** @param {Quantity | null} quantity @param {Range | null} range of the colours @param {boolean} fixed whether it is pinned */
    update(quantity, range, fixed) {
      details.hidden = !range;
      isPinned = fixed;
      pinned.setAttribute('aria-pressed', String(fixed));
      reset.hidden = !fixed;
      setText(summary, fixed ? 'Range, pinned' : 'Range');
      if (!quantity || !range || (range === shown && quantity === shownOf)) return;
      [shown, shownOf] = [range, quantity];
      setText(problem, '');
      low.value = written(valueAt(quantity, range.low));
      high.value = written(valueAt(quantity, range.high));
    },
    dispose: () => listening.abort(),
  };
}
