// SPDX-License-Identifier: MIT
/**
 * @file What is held is copied over the symmetry of the cage, on the real core: the run keeps the symmetry, and the page knows
 * the copies.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { heldWithCopies, shownHeld } from '../../../web/pages/studio/state/hold.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { cageOnScreen } from '../../../web/pages/studio/state/taken.js';
import { createStudio } from './real.js';

beforeAll(() => load());

test('a held face and its images are held and shown, the symmetry stays, and undo takes the copies away', () => {
  const studio = createStudio('?shape=two-3');
  const group = () => studio.state.document.result.group?.name;
  const shown = () => {
    const { document } = studio.state;
    const held = shownHeld(document.settings.constraints, cageOnScreen(document), heldWithCopies(document));
    return held.reduce((sum, one) => sum + one, 0);
  };
  studio.do({ type: 'facesPainted', faces: [0], held: true }, { type: 'paintingEnded' });
  expect(group()).not.toBe('D3h');
  expect(shown()).toBe(1);
  studio.do({ type: 'copiesSwitched', on: true });
  expect(group()).toBe('D3h');
  const copies = studio.state.document.result.held ?? [];
  expect(copies).toContain(1);
  expect(copies.length).toBeGreaterThan(2);
  expect(shown()).toBe(copies.length);
  expect(undoName(studio.state)).toBe('copy over the symmetry');
  // Until the core has answered only what is asked is known.
  studio.dispatch({ type: 'holdEdited', how: 'clear' });
  expect(shown()).toBe(0);
  studio.do({ type: 'undoPressed' });
  expect(shown()).toBe(copies.length);
  studio.do({ type: 'undoPressed' });
  expect(shown()).toBe(1);
  expect(studio.state.document.settings.constraints).toEqual({ hold: { faces: [1] } });
});
