// SPDX-License-Identifier: MIT
/**
 * @file What changes of the settings make of the page's state, and that settings become problems and come back.
 */
import { describe, expect, test } from '@jest/globals';
import { reduce } from '../../../web/pages/studio/state/reduce.js';
import { objectiveValue } from '../../../web/pages/studio/state/select.js';
import {
  changeSettings,
  defaultSettings,
  problemOf,
  problemWith,
  settingsFrom,
} from '../../../web/pages/studio/state/settings.js';
import { after, answered, ended, energies, openedMessages, resting, running, surfaceState, working } from './state.js';

describe('settings', () => {
  test('show the cage anew, under a new run', () => {
    const state = reduce(resting(), { type: 'settingsChanged', change: { cap: 'flat' } });
    expect(state.session.opening).toMatchObject({
      run: 2,
      purpose: 'preview',
      then: 'hold',
      settings: { cap: 'flat' },
    });
    const shown = after(state, ...openedMessages(2));
    expect(shown.document.result.settings.cap).toBe('flat');
    expect(shown.view.fits).toBe(1); // the view does not jump
  });

  test('stand still under a run, and change nothing of a run that has ended', () => {
    const busy = running();
    expect(reduce(busy, { type: 'settingsChanged', change: { cap: 'none' } })).toBe(busy);
    const over = reduce(ended(), { type: 'settingsChanged', change: { functional: 'bending' } });
    expect(over.session.opening).toBeNull();
    expect(over.document.settings.functional).toBe('bending');
    expect(over.document.result.settings.functional).toBe('mvs_cross');
  });

  test('that the core refuses go back to those that worked', () => {
    const state = after(
      resting(),
      { type: 'settingsChanged', change: { levels: [6, 6] } },
      answered({ type: 'failed', run: 2, kind: 'input', message: 'level 6 has too many faces' }),
    );
    expect(state.document.settings).toEqual(defaultSettings);
    expect(state.view.alert?.message).toBe('level 6 has too many faces');
  });

  test('keep the first level at or below the last', () => {
    expect(changeSettings(defaultSettings, { levels: [3, 2] }).levels).toEqual([3, 3]);
    expect(changeSettings({ ...defaultSettings, levels: [1, 2] }, { levels: [1, 0] }).levels).toEqual([0, 0]);
  });

  test('that cannot be minimized say why, are not opened, and hold Start back', () => {
    const blend = after(
      resting(),
      { type: 'settingsChanged', change: { functional: 'blend' } },
      ...openedMessages(2),
      { type: 'weightsChanged', weights: { bending: 0 } },
      ...openedMessages(3),
      { type: 'weightsChanged', weights: { mvs_cross: 0 } },
    );
    expect(problemWith(blend.document.settings)).toMatch(/weight/);
    expect(blend.session.opening).toBeNull();
    expect(working(blend)).toEqual([]);
    expect(reduce(blend, { type: 'startPressed' })).toBe(blend);
    expect(problemWith({ ...defaultSettings, tolerance: NaN })).toMatch(/tolerance/);
    expect(problemWith({ ...defaultSettings, max_iterations: 1.5 })).toMatch(/whole number/);
    expect(problemWith(defaultSettings)).toBeNull();
  });

  test('become a problem, and come back from it', () => {
    const source = /** @type {const} */ ({ kind: 'generated', name: 'torus', family: 'hub', thickness: 2, ratio: 0.3 });
    const start = surfaceState(2, 7);
    for (const settings of [
      defaultSettings,
      changeSettings(defaultSettings, {
        levels: [1, 4],
        symmetry: false,
        cap: 'flat',
        max_iterations: 7,
        tolerance: 0.1,
      }),
      changeSettings(defaultSettings, { accuracy: 0.02 }),
      changeSettings(defaultSettings, {
        functional: 'blend',
        weights: { ...defaultSettings.weights, mvs_cross: 0, second_form_variation: 0.5 },
      }),
    ]) {
      const problem = /** @type {import('../../../wasm/types.js').Problem} */ (problemOf(source, settings, start));
      expect(problem.cage).toEqual({ generator: 'torus', family: 'hub', thickness: 2, ratio: 0.3 });
      expect(problem.start).toBe(start);
      expect(settingsFrom(defaultSettings, problem)).toEqual(settings);
    }
    expect(problemOf(source, defaultSettings, null)).toMatchObject({ terms: { mvs_cross: 1 } });
    expect(problemOf(source, defaultSettings, null)).not.toHaveProperty('start');
  });

  test('say what the objective is worth, also when a part of it diverges', () => {
    expect(objectiveValue({ ...defaultSettings, functional: 'blend' }, energies(100))).toBe(50 + 2000);
    expect(objectiveValue({ ...defaultSettings, functional: 'second_form_variation' }, energies(1))).toBeNaN();
    expect(objectiveValue({ ...defaultSettings, functional: 'bending' }, energies(100))).toBe(100);
  });
});
