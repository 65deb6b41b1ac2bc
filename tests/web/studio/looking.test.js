// SPDX-License-Identifier: MIT
/**
 * @file How the studio's surface is looked at: along axes and back again; and what of that is kept between visits.
 */
import { describe, expect, test } from '@jest/globals';
import { keepsOther, keptFrom, stateFrom } from '../../../web/pages/studio/state/kept.js';
import { initialState } from '../../../web/pages/studio/state/reduce.js';
import { after, resting } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */

/** @param {import('../../../web/address/camera.js').AxisView} axis @returns {Action} */
const along = (axis) => ({ type: 'axisPressed', axis });

/** @param {number} azimuth @param {number} elevation @returns {Action} */
const turned = (azimuth, elevation) => ({
  type: 'viewChanged',
  change: { camera: { azimuth, elevation, distance: 2, target: [1, 0, 0] } },
});

describe('a camera that looks along an axis', () => {
  test('keeps its distance, and looks again as it did before the first axis', () => {
    const free = after(resting(), turned(10, 20));
    const top = after(free, along('front'), along('top'));
    expect(top.view.camera).toEqual({ azimuth: 0, elevation: 90, distance: 2, target: [1, 0, 0] });
    expect(after(top, along('top')).view.camera).toEqual(free.view.camera);
  });

  test('that came to rest there by itself has nothing to return to', () => {
    const state = after(resting(), turned(90, 0));
    expect(after(state, along('right')).view).toEqual(state.view);
  });

  test('and was turned away returns to where it was turned', () => {
    const state = after(resting(), turned(10, 20), along('top'), turned(50, 60), along('front'), along('front'));
    expect(state.view.camera).toMatchObject({ azimuth: 50, elevation: 60 });
  });

  test('and was only moved can still return', () => {
    const state = after(resting(), turned(10, 20), along('right'));
    const { camera } = state.view;
    const moved = after(state, { type: 'viewChanged', change: { camera: { ...camera, distance: 3 } } });
    expect(after(moved, along('right')).view.camera).toMatchObject({ azimuth: 10, elevation: 20, distance: 3 });
  });
});

describe('what is kept of how a surface is looked at', () => {
  /** @type {Partial<import('../../../web/pages/studio/state/types.js').View>} */
  const change = {
    shading: 'difference',
    isolines: true,
    patches: true,
    original: true,
    projection: 'orthographic',
    pinned: { shading: 'difference', low: 0, high: 2 },
  };

  test('is all that was chosen, each of which is written when it changes', () => {
    const state = after(resting(), { type: 'viewChanged', change });
    expect(stateFrom(initialState(), keptFrom(state)).view).toMatchObject(change);
    for (const [name, value] of Object.entries(change)) {
      const one = after(resting(), { type: 'viewChanged', change: { [name]: value } });
      expect(keepsOther(resting(), one)).toBe(true);
    }
  });

  test('of an earlier version lacks what is new, which is then as in the beginning', () => {
    const { view, ...kept } = keptFrom(resting());
    const { shading, cage, camera } = view;
    expect(stateFrom(initialState(), { ...kept, view: { shading, cage, camera } }).view).toMatchObject({
      isolines: false,
      pinned: null,
      projection: 'perspective',
    });
  });
});
