// SPDX-License-Identifier: MIT
/**
 * @file The cage that is edited, in the picture: a click selects a face or a vertex, a drag with Shift the vertices in a box,
 * and the handle moves what is selected. Every other drag turns the cage.
 */
import { middleOf } from '../../../cage/polygons.js';
import { movedPoints } from '../../../cage/select.js';
import { element, whenChanged } from '../../../views/dom.js';
import { editingOn } from '../state/editing.js';

/** @import {Point, PolygonCage} from '../../../cage/polygons.js' */
/** @import {createScene} from '../../../scene/scene.js' */
/** @import {Action, Editing, State} from '../state/types.js' */

/** A press that moves less is a click, in CSS pixels. */
const STILL = 4;

/** @param {Point} point @param {readonly number[]} by @returns {Point} */
const shifted = (point, by) => [point[0] + by[0], point[1] + by[1], point[2] + by[2]];

/** Where what is selected was before a hand dragged it: its middle. @param {Editing} editing @returns {Point | null} null if nothing is selected */
function restOf({ cage, selection }) {
  const moved = movedPoints(cage, selection);
  return moved.length ? middleOf(cage.points, moved) : null;
}

/** Where the handle is that moves what is selected; null if nothing is. @param {Editing} editing @returns {Point | null} */
export function handleOf(editing) {
  const rest = restOf(editing);
  return rest && shifted(rest, editing.drag ?? [0, 0, 0]);
}

/** The cage as the hand that still drags has moved it. @param {Editing} editing */
function dragged({ cage: { points, faces }, cage, selection, drag }) {
  if (!drag) return { points, faces, selection };
  const moved = new Set(movedPoints(cage, selection));
  return { points: points.map((point, v) => (moved.has(v) ? shifted(point, drag) : point)), faces, selection };
}

/** The points of a cage as a mesh has them, by which the picture is placed. @param {PolygonCage} cage */
function placing({ points }) {
  const centre = Float64Array.from(points[0]);
  return { centre, positions: Float32Array.from(points.flatMap((point) => point.map((x, axis) => x - centre[axis]))) };
}

/**
 * @param {HTMLElement} canvas
 * @param {ReturnType<typeof createScene> | null} scene
 * @param {(action: Action) => void} dispatch
 * @param {AbortSignal} signal
 */
export function createEditedPicture(canvas, scene, dispatch, signal) {
  /** @type {Editing | null} */
  let editing = null;
  /** The press that has not ended. @type {{id: number, x: number, y: number, box: HTMLElement | null} | null} */
  let press = null;

  /** @param {{clientX: number, clientY: number}} event @returns {[number, number]} from 0 to 1 */
  function placeOf({ clientX, clientY }) {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }

  /** @param {PointerEvent} event */
  function begin(event) {
    if (press) {
      // A second finger, which turns and zooms.
      press.box?.remove();
      press = null;
      return;
    }
    if (!editing || event.button !== 0 || scene?.handleIsAt(...placeOf(event))) return;
    press = { id: event.pointerId, x: event.clientX, y: event.clientY, box: null };
    if (!event.shiftKey) return;
    event.stopImmediatePropagation(); // or else the camera moves
    canvas.setPointerCapture(event.pointerId);
    press.box = element('div', { class: 'box' });
    press.box.hidden = true;
    canvas.after(press.box);
  }

  /** @param {PointerEvent} event */
  function go(event) {
    if (press?.id !== event.pointerId || !press.box) return;
    const { left, top } = canvas.getBoundingClientRect();
    const [x, y] = [Math.min(press.x, event.clientX), Math.min(press.y, event.clientY)];
    const [width, height] = [Math.abs(event.clientX - press.x), Math.abs(event.clientY - press.y)];
    press.box.hidden = Math.hypot(width, height) < STILL;
    Object.assign(press.box.style, {
      left: `${x - left}px`,
      top: `${y - top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
  }

  /** @param {PointerEvent} event */
  function end(event) {
    if (press?.id !== event.pointerId) return;
    const { x, y, box } = press;
    press = null;
    box?.remove();
    if (event.type === 'pointercancel' || !editing) return;
    if (Math.hypot(event.clientX - x, event.clientY - y) >= STILL) {
      const inside = box && scene?.editedInBox(placeOf({ clientX: x, clientY: y }), placeOf(event));
      if (inside) dispatch({ type: 'cagePicked', what: 'points', numbers: inside, add: true });
      return;
    }
    canvas.focus({ preventScroll: true });
    const found = scene?.editedAt(...placeOf(event));
    if (found) dispatch({ type: 'cagePicked', what: found.what, numbers: [found.number], add: event.shiftKey });
    else if (!event.shiftKey) dispatch({ type: 'cageSelectionChanged', how: 'none' });
  }

  canvas.addEventListener('pointerdown', begin, { signal, capture: true });
  canvas.addEventListener('pointermove', go, { signal });
  for (const type of /** @type {const} */ (['pointerup', 'pointercancel'])) {
    canvas.addEventListener(type, end, { signal });
  }

  /** What the picture is placed by, since a cage is larger than its surface. @type {ReturnType<typeof placing> | null} */
  let frame = null;
  const setFrame = whenChanged((/** @type {PolygonCage | null} */ cage) => (frame = cage && placing(cage)));
  const show = whenChanged((/** @type {Editing | null} */ shown) => scene?.setEdited(shown && dragged(shown)));

  return {
    /** @param {State} state */
    update(state) {
      editing = editingOn(state);
      setFrame(editing?.cage ?? null);
      show(editing);
    },

    get frame() {
      return frame;
    },

    /**
     * The handle was moved.
     * @param {Point} at
     * @param {boolean} moving while the hand still moves
     * @returns {boolean} whether it was that of the cage
     */
    dragged(at, moving) {
      const middle = editing && restOf(editing);
      if (!middle) return false;
      /** @type {Point} */
      const by = [at[0] - middle[0], at[1] - middle[1], at[2] - middle[2]];
      if (moving) dispatch({ type: 'cageDragged', by });
      else if (editing?.drag) dispatch({ type: 'cageEdited', edit: { kind: 'move', by } });
      return true;
    },
  };
}
