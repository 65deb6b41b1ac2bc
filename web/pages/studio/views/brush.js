// SPDX-License-Identifier: MIT
/**
 * @file The pointer on the surface while it holds, frees or pins. What begins on the surface is kept from the camera's
 * controls; what begins beside it turns the surface as always.
 */

/** @import {Action, Pointer} from '../state/types.js' */

/** A stroke looks at the surface at least at each so many CSS pixels. */
const STEP = 6;

/**
 * @typedef {object} Brush
 * @property {() => Pointer} pointer
 * @property {(x: number, y: number) => {face: number, vertex: number} | null} pick at a fraction of the canvas
 * @property {(x: number, y: number) => boolean} isHandle whether the handle of a pin is there
 * @property {(x: number, y: number) => number} pinAt the pin there, from 0, or -1
 */

/**
 * @param {HTMLElement} canvas
 * @param {Brush} brush
 * @param {(action: Action) => void} dispatch
 * @param {AbortSignal} signal
 */
export function listenToBrush(canvas, { pointer, pick, isHandle, pinAt }, dispatch, signal) {
  /** The stroke in progress. @type {{id: number, held: boolean, x: number, y: number, faces: Set<number>} | null} */
  let stroke = null;

  /** A place in the picture. @param {number} x @param {number} y as in events @returns {[number, number]} */
  function placeOf(x, y) {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return [(x - left) / width, (y - top) / height];
  }

  /** @param {number} x @param {number} y as in events */
  const under = (x, y) => pick(...placeOf(x, y));

  /** @param {Set<number>} faces @param {boolean} held */
  const paint = (faces, held) => faces.size && dispatch({ type: 'facesPainted', faces: [...faces], held });

  /** Paints along the way to a point. @param {number} x @param {number} y */
  function go(x, y) {
    if (!stroke) return;
    const steps = Math.max(1, Math.ceil(Math.hypot(x - stroke.x, y - stroke.y) / STEP));
    const fresh = new Set();
    for (let i = 1; i <= steps; i++) {
      const hit = under(stroke.x + ((x - stroke.x) * i) / steps, stroke.y + ((y - stroke.y) * i) / steps);
      if (hit && !stroke.faces.has(hit.face)) fresh.add(hit.face);
    }
    for (const face of fresh) stroke.faces.add(face);
    Object.assign(stroke, { x, y });
    paint(fresh, stroke.held);
  }

  /** @param {PointerEvent} event */
  function begin(event) {
    const mode = pointer();
    if (mode === 'turn' || mode === 'edit' || event.button !== 0) return;
    if (stroke) return event.stopImmediatePropagation();
    const { clientX: x, clientY: y } = event;
    if (isHandle(...placeOf(x, y))) return;
    if (mode === 'pin') {
      const pin = pinAt(...placeOf(x, y));
      if (pin >= 0) {
        event.stopImmediatePropagation();
        dispatch({ type: 'viewChanged', change: { pin } });
        return;
      }
    }
    const hit = under(x, y);
    if (!hit) return;
    event.stopImmediatePropagation();
    canvas.focus({ preventScroll: true });
    if (mode === 'pin') {
      if (hit.vertex >= 0) dispatch({ type: 'vertexPinned', vertex: hit.vertex + 1 });
      return;
    }
    canvas.setPointerCapture(event.pointerId);
    stroke = { id: event.pointerId, held: (mode === 'hold') !== event.shiftKey, x, y, faces: new Set([hit.face]) };
    paint(stroke.faces, stroke.held);
  }

  /** @param {PointerEvent} event */
  function end(event) {
    if (stroke?.id !== event.pointerId) return;
    stroke = null;
    dispatch({ type: 'paintingEnded' });
  }

  // Before the camera's controls, which listen on the same element.
  canvas.addEventListener('pointerdown', begin, { signal, capture: true });
  canvas.addEventListener(
    'pointermove',
    (event) => {
      if (stroke?.id === event.pointerId) go(event.clientX, event.clientY);
    },
    { signal },
  );
  for (const type of /** @type {const} */ (['pointerup', 'pointercancel'])) {
    canvas.addEventListener(type, end, { signal });
  }
}
