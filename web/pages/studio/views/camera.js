// SPDX-License-Identifier: MIT
/**
 * @file The menu of the camera: its projection, and looking along an axis and back again.
 */
import { axisViewOf, axisViews } from '../../../address/camera.js';
import { find } from '../../../views/dom.js';

/** @import {AxisView, Projection} from '../../../address/camera.js' */
/** @import {Action, State} from '../state/types.js' */

/** The keys of the picture for the axes. @type {Record<string, AxisView>} */
const AXIS_KEYS = { 1: 'front', 2: 'right', 3: 'top' };

/**
 * @param {(action: Action) => void} dispatch
 * @param {() => Projection} projection
 * @returns {Record<string, () => void>} keys of the picture, and what they do
 */
export function cameraKeys(dispatch, projection) {
  const axes = Object.entries(AXIS_KEYS).map(([key, axis]) => [key, () => dispatch({ type: 'axisPressed', axis })]);
  const other = () => (projection() === 'perspective' ? 'orthographic' : 'perspective');
  return {
    ...Object.fromEntries(axes),
    o: () => dispatch({ type: 'viewChanged', change: { projection: other() } }),
  };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createCameraView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const choices = [...root.querySelectorAll('[name=projection]')].map(
    (input) => /** @type {HTMLInputElement} */ (input),
  );
  for (const input of choices) {
    const projection = /** @type {Projection} */ (input.value);
    input.addEventListener('change', () => dispatch({ type: 'viewChanged', change: { projection } }), { signal });
  }
  const buttons = /** @type {AxisView[]} */ (Object.keys(axisViews)).map((axis) => {
    const button = find(root, `[name=${axis}]`);
    button.addEventListener('click', () => dispatch({ type: 'axisPressed', axis }), { signal });
    return { axis, button };
  });
  return {
    /** @param {State} state */
    update({ view }) {
      for (const input of choices) input.checked = input.value === view.projection;
      const along = axisViewOf(view.camera);
      for (const { axis, button } of buttons) button.setAttribute('aria-pressed', String(axis === along));
    },
    dispose: () => listening.abort(),
  };
}
