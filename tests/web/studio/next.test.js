// SPDX-License-Identifier: MIT
/**
 * @file What the button beside a result does: the same once more with one level more, or further from the surface.
 */
import { describe, expect, test } from '@jest/globals';
import { nextButton } from '../../../web/pages/studio/state/next.js';
import { MAX_LEVEL } from '../../../web/pages/studio/state/settings.js';
import { bound, limit, over, three } from './outcomes.js';
import { after, answered, ended, levelReport, mesh, noLimit, progress, stepped, surfaceState } from './state.js';

describe('going one level finer', () => {
  test('minimizes the same from where the run began, with one level more, so that its levels tell a limit', () => {
    const state = after(over({ levels: three.slice(0, 2), limit: noLimit() }), { type: 'finerPressed' });
    expect(state.session.opening).toMatchObject({ purpose: 'start', then: 'run', start: null });
    expect(state.session.opening?.settings.levels).toEqual([0, 2]);
    expect(state.session.opening?.before?.name).toBe('go one level finer');
  });

  test('of a run that went on from a surface begins with that surface again', () => {
    const again = after(over({}), { type: 'settingsChanged', change: { origin: 'surface' } }, { type: 'startPressed' });
    const opened = after(
      again,
      answered({
        type: 'opened',
        run: 2,
        level: 2,
        cage: /** @type {any} */ (again.document.cage).counts,
        group: { name: 'D3h', order: 12 },
        groups: [],
      }),
      answered({ type: 'surfaced', run: 2, evaluations: 0, patches: 24, limit: mesh(), density: 1, control: mesh() }),
      stepped(2, 3, 2),
      answered({ type: 'levelEnded', run: 2, report: levelReport(2), limit: noLimit() }),
      answered({ type: 'saved', run: 2, evaluations: 3, state: surfaceState(2, 11) }),
      answered({ type: 'ended', run: 2, stop: 'converged', progress: progress(2, 3) }),
    );
    expect(nextButton(opened)?.label).toBe('Go one level finer');
    const finer = after(opened, { type: 'finerPressed' });
    expect(finer.session.opening?.start).toEqual(surfaceState(2, 9));
    expect(finer.session.opening?.settings.levels).toEqual([0, 3]);
    // A third level follows in the same way, so that three tell the limit.
  });

  test('is not offered, nor done, beyond the finest level or where an accuracy chose the levels', () => {
    const finest = over({ levels: [levelReport(MAX_LEVEL)], limit: noLimit() });
    const chosen = over({ limit: bound, settings: { accuracy: 0.01 } });
    for (const state of [finest, chosen, ended()]) expect(after(state, { type: 'finerPressed' })).toBe(state);
    expect(nextButton(chosen)).toBeNull();
  });
});

describe('going on', () => {
  test('minimizes the same further from the surface, with the settings of the run', () => {
    const stopped = over({ stop: 'cancelled', limit: limit({ status: 'not_minimized' }) });
    const state = after(stopped, { type: 'goOnPressed' });
    expect(state.session.opening).toMatchObject({ purpose: 'start', then: 'run', start: surfaceState(2, 9) });
    expect(state.document.settings.origin).toBe('surface');
  });

  test('is not offered where something else is held by now, or where no iteration is allowed', () => {
    const stopped = over({ stop: 'cancelled', limit: limit({ status: 'not_minimized' }) });
    const held = after(stopped, { type: 'facesPainted', faces: [0], held: true });
    const idle = over({ stop: 'max_iterations', settings: { max_iterations: 0 } });
    for (const state of [held, idle]) {
      expect(nextButton(state)).toBeNull();
      expect(after(state, { type: 'goOnPressed' })).toBe(state);
    }
  });
});
