// SPDX-License-Identifier: MIT
/**
 * @file The rows of the list of pins: what each holds, how strongly it pulls, and where it lies and its normal points, in fields
 * that move and turn it.
 */
import { pinWords, pullWords } from '../../../words/holding.js';
import { element, setText } from '../../../views/dom.js';

/** @import {Pin, PinReport} from '../../../../wasm/types.js' */
/** @import {Action} from '../state/types.js' */

/** @import {Normal} from '../state/normals.js' */

/** @typedef {{item: HTMLElement, update: (pin: Pin, report: PinReport | undefined, normal: Normal | null, step: number) => void}} PinRow */

/** Of a component of a normal. */
const TURN = 0.05;

/** What a row depends on; another pin has another row. @param {Pin} pin */
const keyOf = ({ at, normal, ...rest }) =>
  JSON.stringify({ ...rest, normal: Boolean(normal), free: at?.map((x) => !Number.isFinite(x)) });

/**
 * @param {Pin} first the pin
 * @param {number} index among all pins
 * @param {(action: Action) => void} dispatch
 * @param {AbortSignal} signal
 * @returns {PinRow}
 */
function createPinRow(first, index, dispatch, signal) {
  const name = element('span', { class: 'name' });
  const strength = element('span', { class: 'pull' });
  const remove = element('button', { type: 'button', class: 'quiet' }, '✕');
  remove.addEventListener('click', () => dispatch({ type: 'pinRemoved', index }), { signal });
  /** Where the point is, exactly; the fields may show fewer digits. @type {[number, number, number] | null} */
  let place = null;

  const inputs = ['x', 'y', 'z'].map((axis, c) => {
    const input = element('input', { type: 'number', step: 'any', 'aria-label': `${axis} of ${pinWords(first)}` });
    /** @param {boolean} moving */
    const move = (moving) => {
      if (!place || !Number.isFinite(input.valueAsNumber)) return;
      const at = /** @type {[number, number, number]} */ (place.map((x, i) => (i === c ? input.valueAsNumber : x)));
      dispatch({ type: 'pinMoved', index, at, moving });
    };
    input.addEventListener('input', () => move(true), { signal });
    input.addEventListener('change', () => move(false), { signal });
    return input;
  });
  const turn = createTurn(first, index, dispatch, signal);
  const labels = inputs.map((input, c) => element('label', {}, element('span', {}, 'xyz'[c]), input));
  const fields = element('span', { class: 'places', role: 'group' }, ...labels);
  const item = element('li', {}, element('span', { class: 'dot' }), name, strength, remove, fields, turn.item);
  item.addEventListener('focusin', () => dispatch({ type: 'viewChanged', change: { pin: index } }), { signal });

  /** @param {Pin} pin @param {PinReport | undefined} report @param {number} step */
  function showPlace(pin, report, step) {
    const digits = Math.min(Math.max(Math.ceil(-Math.log10(step)) + 2, 0), 20);
    const known = pin.at?.map((x, c) => (Number.isFinite(x) ? x : NaN)) ?? report?.position;
    place = known && pin.position !== false ? [known[0], known[1], known[2]] : null;
    fields.hidden = !place;
    inputs.forEach((input, c) => {
      const value = place?.[c] ?? NaN;
      labels[c].hidden = !Number.isFinite(value);
      const words = String(Number(value.toFixed(digits)));
      if (Number(input.value) !== value && input.value !== words) input.value = words;
    });
  }

  return {
    item,
    update(pin, report, normal, step) {
      const words = pinWords({ ...pin, at: undefined }); // the fields tell where
      setText(name, words);
      remove.setAttribute('aria-label', `Remove the pin: ${words}`);
      strength.hidden = !report;
      if (report) {
        const { value, direction } = pullWords(report);
        setText(strength, value);
        strength.title = direction;
      }
      fields.setAttribute('aria-label', `Where ${words} lies`);
      for (const input of inputs) input.step = String(step);
      showPlace(pin, report, step);
      turn.update(normal);
    },
  };
}

/**
 * Whether a pin holds the normal, and which.
 * @param {Pin} pin
 * @param {number} index
 * @param {(action: Action) => void} dispatch
 * @param {AbortSignal} signal
 */
function createTurn(pin, index, dispatch, signal) {
  const box = element('input', { type: 'checkbox' });
  box.checked = Boolean(pin.normal);
  // A pin that holds nothing else has to.
  box.disabled = pin.position === false;
  box.addEventListener('change', () => dispatch({ type: 'pinTurned', index, normal: box.checked }), { signal });
  const inputs = ['x', 'y', 'z'].map((axis) => {
    const label = `${axis} of the normal of ${pinWords(pin)}`;
    const input = element('input', { type: 'number', step: String(TURN), 'aria-label': label });
    /** @param {boolean} moving */
    const turn = (moving) => {
      const [x, y, z] = inputs.map((one) => one.valueAsNumber);
      if (Number.isFinite(x + y + z)) dispatch({ type: 'pinTurned', index, normal: [x, y, z], moving });
    };
    input.addEventListener('input', () => turn(true), { signal });
    input.addEventListener('change', () => turn(false), { signal });
    return input;
  });
  const fields = element(
    'span',
    { class: 'places', role: 'group', 'aria-label': `The normal of ${pinWords(pin)}` },
    ...inputs.map((input, c) => element('label', {}, element('span', {}, `n${'xyz'[c]}`), input)),
  );
  const label = element(
    'label',
    { class: 'check', title: 'The surface keeps its normal there' },
    box,
    ' Hold the normal',
  );
  return {
    item: element('span', { class: 'turn' }, label, fields),
    /** @param {Normal | null} normal */
    update(normal) {
      fields.hidden = !normal;
      // What is typed is of any length; while it is typed it stays.
      inputs.forEach((input, c) => {
        if (!normal || inputs.includes(/** @type {any} */ (document.activeElement))) return;
        input.value = String(Number(normal[c].toFixed(3)));
      });
    },
  };
}

/**
 * @param {HTMLElement} list
 * @param {(action: Action) => void} dispatch
 * @param {AbortSignal} signal
 */
export function createPinRows(list, dispatch, signal) {
  /** @type {PinRow[]} */
  let rows = [];
  let keys = '';
  /**
   * @param {Pin[]} pins
   * @param {PinReport[]} reports
   * @param {Array<Normal | null>} normals that they hold
   * @param {number} size of the surface
   */
  return (pins, reports, normals, size) => {
    const now = pins.map(keyOf).join();
    if (now !== keys) {
      keys = now;
      rows = pins.map((pin, index) => createPinRow(pin, index, dispatch, signal));
      list.replaceChildren(...rows.map(({ item }) => item));
    }
    list.hidden = !pins.length;
    // A two-hundredth of the size, rounded to one digit.
    const step = Number((size / 200).toPrecision(1)) || 0.01;
    rows.forEach((row, index) => {
      const report = reports.find((one) => one.pin === index + 1 && !one.copy);
      row.update(pins[index], report, normals[index], step);
    });
  };
}
