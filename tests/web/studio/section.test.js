// SPDX-License-Identifier: MIT
/**
 * @file The plane of a section, and what is said of it.
 */
import { describe, expect, test } from '@jest/globals';
import { placementOf } from '../../../web/scene/placement.js';
import { createStand } from '../../../web/scene/stand.js';
import { turnedSection } from '../../../web/pages/studio/state/section.js';
import { sectionWords } from '../../../web/words/section.js';
import { after, resting } from './state.js';

describe('a section', () => {
  test('lies across an axis of the file, and keeps the rest of its settings', () => {
    const state = after(resting(), {
      type: 'viewChanged',
      change: { section: { ...resting().view.section, position: 0.3, shown: true } },
    });
    expect(turnedSection(state, 'y')).toMatchObject({ axis: 'y', direction: [0, 1, 0], position: 0.3, shown: true });
    expect(turnedSection(state, 'z').direction).toEqual([0, 0, 1]);
  });

  test.each(/** @type {const} */ (['z', 'y']))(
    'lies across the direction of the camera where %s points upwards',
    (up) => {
      const state = resting();
      const camera = { ...state.view.camera, azimuth: 30, elevation: 50 };
      const source = { kind: 'text', name: 'a.obj', text: '' };
      const cage = up === 'z' ? state.document.cage : { ...state.document.cage, source };
      const seen = /** @type {any} */ ({
        ...state,
        document: { ...state.document, cage },
        view: { ...state.view, camera },
      });
      // The scene's own way: the camera's place in the world, in the coordinates of the model.
      const stand = createStand();
      stand.setUp(up);
      stand.object.updateMatrixWorld(true);
      const { position, target } = placementOf(camera, 1);
      const expected = stand.model.worldToLocal(position.sub(target).normalize());
      const { direction } = turnedSection(seen, 'view');
      direction.forEach((x, axis) => expect(x).toBeCloseTo(expected.getComponent(axis), 6));
    },
  );

  test('is told with its curves and their curvature', () => {
    expect(sectionWords(null)).toBe('');
    expect(sectionWords({ curves: 0, least: Infinity, largest: -Infinity })).toMatch('does not meet');
    expect(sectionWords({ curves: 2, least: -0.5, largest: 3.25 })).toBe(
      '2 curves, curvature −0.500 to 3.25 per length',
    );
  });
});
