// SPDX-License-Identifier: MIT
/**
 * @file The triangle of a blend: a functional at each corner, and a point inside, moved by hand or by keys, that is their
 * shares. A movement from its first press to its release is one gesture.
 */
import { cornersOf, pointOf, weightsAt, withCorner } from '../state/corners.js';
import { takesWeights } from '../state/following.js';
import { settingsAreFree } from '../state/reduce.js';
import { CENTRE, CORNERS, HEIGHT, movedByKey, placeOf, sharesAt } from '../../../plot/triangle.js';
import { element, setText, whenChanged } from '../../../views/dom.js';
import { svg } from '../../../views/svg.js';
import { functionals, functionalWords } from '../../../words/functionals.js';
import { outsideWords, shareWords } from '../../../words/blends.js';

/** @import {FunctionalName} from '../../../../wasm/types.js' */
/** @import {Point, Shares} from '../../../plot/triangle.js' */
/** @import {Action, Corners, Settings, State} from '../state/types.js' */

const PLACES = ['top', 'left', 'right'];
/** The length of a side of the triangle, and the room around it, in the picture's units. */
const SIDE = 200;
const ROOM = 12;
const WIDTH = SIDE + 2 * ROOM;

/** @param {Point} place in the triangle of sides 1 @returns {Point} in the picture */
const drawnAt = ([x, y]) => [ROOM + SIDE * x, ROOM + SIDE * y];

/** A line from side to side on which one share is the same. @param {number} corner @param {number} share */
function levelLine(corner, share) {
  const ends = [1, 2].map((next) => {
    /** @type {Shares} */
    const shares = [0, 0, 0];
    shares[corner] = share;
    shares[(corner + next) % 3] = 1 - share;
    return drawnAt(placeOf(shares));
  });
  const [[x1, y1], [x2, y2]] = ends;
  return svg('line', { x1, y1, x2, y2 });
}

function createPicture() {
  const point = svg('circle', { class: 'point', r: 7 });
  const lines = [0, 1, 2].flatMap((corner) => [0.25, 0.5, 0.75].map((share) => levelLine(corner, share)));
  const outline = svg('polygon', { points: CORNERS.map((corner) => drawnAt(corner).join()).join(' ') });
  const picture = svg(
    'svg',
    { viewBox: `0 0 ${WIDTH} ${(SIDE * HEIGHT + 2 * ROOM).toFixed(1)}`, 'aria-hidden': 'true' },
    ...lines,
    outline,
    point,
  );
  return { picture, point };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createTriangleView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const { picture, point } = createPicture();
  const plane = element('div', {
    class: 'plane',
    role: 'slider',
    tabindex: '0',
    'aria-label': 'Point of the blend',
    'aria-valuemin': '0',
    'aria-valuemax': '1',
    'aria-describedby': 'triangle-keys',
  });
  plane.append(picture);
  const selects = PLACES.map((place) => element('select', { 'aria-label': `Functional at the ${place} corner` }));
  const shares = PLACES.map(() => element('span', { class: 'share' }));
  const corners = PLACES.map((place, i) => element('div', { class: `corner ${place}` }, selects[i], shares[i]));
  const outside = element('p', { class: 'note' });
  const keys = element(
    'p',
    { class: 'hidden', id: 'triangle-keys' },
    'Arrow keys move the point, with Shift further; 1, 2 and 3 put it at a corner, 0 in the middle.',
  );
  root.prepend(corners[0], plane, corners[1], corners[2], outside, keys);

  /** @type {Settings | null} */
  let settings = null;
  let free = false;
  let moving = false;

  /** @param {Shares} to @param {boolean} goesOn whether the gesture does */
  function move(to, goesOn) {
    if (!settings || !free) return;
    moving = goesOn;
    dispatch({ type: 'weightsChanged', weights: weightsAt(cornersOf(settings), settings.weights, to), moving });
  }
  /** The gesture is over: what it has led to stays. */
  function rest() {
    if (!moving || !settings) return;
    moving = false;
    dispatch({ type: 'weightsChanged', weights: settings.weights, moving });
  }
  /** @param {PointerEvent} event */
  function follow({ clientX, clientY }) {
    const { left, top, width } = picture.getBoundingClientRect();
    const unit = (SIDE * width) / WIDTH;
    const room = (ROOM * width) / WIDTH;
    move(sharesAt([(clientX - left - room) / unit, (clientY - top - room) / unit]), true);
  }

  /** @template {keyof HTMLElementEventMap} K @param {K} name @param {(event: HTMLElementEventMap[K]) => void} work */
  const on = (name, work) => plane.addEventListener(name, work, { signal });
  on('pointerdown', (event) => {
    if (event.button !== 0 || !event.isPrimary) return;
    plane.setPointerCapture(event.pointerId);
    follow(event);
  });
  on('pointermove', (event) => event.isPrimary && plane.hasPointerCapture(event.pointerId) && follow(event));
  for (const name of /** @type {const} */ (['pointerup', 'pointercancel', 'keyup', 'blur'])) on(name, rest);
  on('keydown', (event) => {
    if (!settings || event.ctrlKey || event.metaKey || event.altKey) return;
    const { shares } = pointOf(cornersOf(settings), settings.weights);
    const to = movedByKey(shares ?? CENTRE, event.key, event.shiftKey);
    if (!to) return;
    event.preventDefault();
    move(to, true);
  });
  selects.forEach((select, i) => {
    select.append(...functionals.map(({ id, short }) => element('option', { value: id }, short)));
    const choose = () => {
      if (!settings) return;
      const name = /** @type {FunctionalName} */ (select.value);
      dispatch({ type: 'weightsChanged', ...withCorner(cornersOf(settings), settings.weights, i, name) });
    };
    select.addEventListener('change', choose, { signal });
  });

  const show = whenChanged((/** @type {Corners} */ at, /** @type {Settings['weights']} */ weights) => {
    const { shares: place, parts, outside: others } = pointOf(at, weights);
    const [x, y] = drawnAt(placeOf(place ?? CENTRE));
    point.setAttribute('cx', x.toFixed(1));
    point.setAttribute('cy', y.toFixed(1));
    point.classList.toggle('outside', others.length > 0);
    at.forEach((name, i) => {
      selects[i].value = name;
      selects[i].title = functionalWords(name).name;
      setText(shares[i], shareWords(parts[i]));
    });
    plane.setAttribute('aria-valuenow', parts[0].toFixed(3));
    plane.setAttribute(
      'aria-valuetext',
      at.map((name, i) => `${functionalWords(name).short} ${shareWords(parts[i])}`).join(', '),
    );
    setText(outside, outsideWords(others));
    outside.hidden = !others.length;
  });

  return {
    /** @param {State} state */
    update(state) {
      ({ settings } = state.document);
      free = settingsAreFree(state) || takesWeights(state);
      root.hidden = settings.functional !== 'blend';
      plane.setAttribute('aria-disabled', String(!free));
      for (const select of selects) select.disabled = !free;
      show(cornersOf(settings), settings.weights);
    },
    dispose: () => listening.abort(),
  };
}
