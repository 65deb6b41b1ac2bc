// SPDX-License-Identifier: MIT
/**
 * @file What actions and the worker's messages make of the page's state, from its first moment to the end of a run.
 */
import { describe, expect, test } from '@jest/globals';
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { energyNotes, statusSentence } from '../../../web/pages/studio/state/select.js';
import {
  after,
  answered,
  drop,
  ended,
  energies,
  leaves,
  levelReport,
  noLimit,
  openedMessages,
  progress,
  resting,
  running,
  stepped,
  surfaceState,
  working,
} from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

describe('the page', () => {
  test('opens on the genus-2 frame', () => {
    const state = initialState();
    expect(state.session.opening).toMatchObject({ run: 1, purpose: 'cage', source: { name: 'two-3', family: 'flag' } });
    expect(state.session.phase.name).toBe('loading');
    expect(working(state)).toEqual(['Cancel']);
  });

  test('shows the cage, its surface and its energies once the worker has opened it', () => {
    const state = resting();
    expect(leaves(state)).toMatchObject({ status: 'resting', run: 1, opening: null, version: '1.2.3', fits: 1 });
    expect(state.document.cage?.counts.genus).toBe(2);
    expect(state.document.result.latest?.energies.bending).toBe(150);
    expect(state.document.result.group).toEqual({ name: 'D3h', order: 12 });
    expect(working(state)).toEqual(['Start', 'Step']);
  });

  test('knows what a run will take from when it has opened, and of another one only what that takes', () => {
    const estimate = { levels: [], seconds: 8, bytes: 1e6 };
    const [opened] = openedMessages(1);
    if (opened.type !== 'answered' || opened.message.type !== 'opened') throw new Error('no opening');
    const told = reduce(after(initialState()), answered({ ...opened.message, estimate }));
    expect(told.session.estimate).toEqual(estimate);
    const again = after(told, { type: 'settingsChanged', change: { tolerance: 1e-4 } }, ...openedMessages(2));
    expect(again.session.run).toBe(2);
    expect(again.session.estimate).toBe(null);
  });

  test('never changes a state in place', () => {
    /** @param {any} value @returns {any} */
    const freeze = (value) => {
      if (value && typeof value === 'object' && !ArrayBuffer.isView(value)) {
        Object.values(value).forEach(freeze);
        Object.freeze(value);
      }
      return value;
    };
    const frozen = freeze(running());
    const next = after(frozen, stepped(1, 3), { type: 'pausePressed' }, drop('a.obj'), {
      type: 'viewChanged',
      change: { cage: true },
    });
    expect(next).not.toBe(frozen);
    expect(frozen.document.result.samples).toHaveLength(5);
  });
});

describe('a run', () => {
  test('starts, pauses when the worker has paused, and resumes', () => {
    const started = reduce(resting(), { type: 'startPressed' });
    expect(started.session.phase.name).toBe('running');
    expect(working(started)).toEqual(['Pause', 'Cancel', 'Reset']);
    const asked = after(started, stepped(1, 5), { type: 'pausePressed' });
    expect(leaves(asked)).toMatchObject({ status: 'running', asked: 'pause' });
    expect(working(asked)).toEqual(['Cancel', 'Reset']);
    const paused = reduce(asked, answered({ type: 'paused', run: 1, progress: progress(0, 5) }));
    expect(leaves(paused)).toMatchObject({ status: 'paused', asked: null });
    expect(working(paused)).toEqual(['Resume', 'Step', 'Cancel', 'Reset']);
    expect(statusSentence(paused)).toBe('Paused at 146.0; it was still falling.');
    expect(reduce(paused, { type: 'startPressed' }).session.phase.name).toBe('running');
  });

  test('collects samples, levels and energies, and remembers the first energies', () => {
    const report = levelReport(0);
    const state = after(
      running(),
      answered({ type: 'levelEnded', run: 1, report, limit: noLimit() }),
      answered({ type: 'measured', run: 1, evaluations: 5, level: 0, energies: energies(113) }),
    );
    expect(state.document.result.samples[4]).toEqual({ evaluation: 5, energy: 146, gradientNorm: 2, level: 0 });
    expect(state.document.result.levels).toEqual([report]);
    expect(state.document.result.limit?.status).toBe('too_few_levels');
    expect(state.document.result.first?.energies.bending).toBe(150);
    expect(state.document.result.latest).toMatchObject({ evaluations: 5, energies: { bending: 113 } });
  });

  test('hears nothing of the runs before it', () => {
    const state = after(resting(), drop('spot.obj'), ...openedMessages(2));
    expect(reduce(state, stepped(1, 4))).toBe(state);
    expect(reduce(state, answered({ type: 'ended', run: 1, stop: 'converged', progress: progress(0, 4) }))).toBe(state);
  });

  test('ends with its reason in words', () => {
    const state = ended();
    expect(leaves(state)).toMatchObject({ status: 'ended', stop: 'converged', saved: { state: surfaceState(2, 9) } });
    expect(statusSentence(state)).toBe('Minimized: 146.0.');
    expect(working(state)).toEqual(['Start', 'Step', 'Reset']);
  });

  test('whose result is an earlier level says so, once it has ended and the result is measured', () => {
    const told = 'Of level 1, which is better than the last one.';
    const notes = (/** @type {State} */ state) => energyNotes(state).map(({ words }) => words);
    /** @param {number} evaluations @param {number} level */
    const measured = (evaluations, level) =>
      answered({ type: 'measured', run: 1, evaluations, level, energies: energies(113) });
    const levels = [0, 1, 2].map((level) =>
      answered({ type: 'levelEnded', run: 1, report: levelReport(level), limit: noLimit() }),
    );
    const before = after(running(), ...levels, measured(4, 1));
    expect(notes(before)).toEqual(['As of evaluation 4.']);
    const over = after(before, answered({ type: 'ended', run: 1, stop: 'converged', progress: progress(1, 5) }));
    expect(notes(over)).not.toContain(told);
    expect(notes(after(over, measured(5, 1)))).toEqual([told]);
    expect(notes(after(over, measured(5, 2)))).toEqual([]);
  });

  test('that ends with energies that no surface has is warned of, but not while it goes on', () => {
    const folded = { ...energies(1e-20), below_bound: true, resolved: false };
    const measured = answered({ type: 'measured', run: 1, evaluations: 5, level: 0, energies: folded });
    expect(energyNotes(after(running(), measured))).toEqual([]);
    const state = after(
      running(),
      answered({ type: 'ended', run: 1, stop: 'below_bound', progress: progress(0, 5) }),
      measured,
    );
    expect(statusSentence(state)).toMatch(/^No minimum: it has less energy than any such surface can/);
    expect(energyNotes(state).map(({ warning }) => warning)).toEqual([true, true]);
  });

  test('starts again from the cage', () => {
    const state = reduce(ended(), { type: 'startPressed' });
    expect(state.session.opening).toMatchObject({
      run: 2,
      purpose: 'start',
      then: 'run',
      source: { kind: 'generated' },
      start: null,
    });
    const opened = after(state, ...openedMessages(2));
    expect(leaves(opened)).toMatchObject({ status: 'running', samples: [], levels: [], fits: 1 });
  });

  test('or goes on from the surface, its levels counted from the cage', () => {
    const state = after(
      ended(),
      { type: 'settingsChanged', change: { origin: 'surface', levels: [0, 3] } },
      { type: 'startPressed' },
    );
    expect(state.session.opening).toMatchObject({
      then: 'run',
      source: { kind: 'generated' },
      start: surfaceState(2, 9),
    });
    const opened = after(state, ...openedMessages(2), stepped(2, 3, 2));
    expect(opened.document.cage?.source.kind).toBe('generated');
    expect(opened.document.result.samples[0].level).toBe(2);
  });

  test('is taken back to the cage by Reset, also while it goes on', () => {
    for (const state of [running(), ended()]) {
      const reset = after(state, { type: 'resetPressed' }, ...openedMessages(2));
      expect(leaves(reset)).toMatchObject({ status: 'resting', samples: [], levels: [], stop: null, fits: 1 });
    }
  });

  test('that is asked to start while its cage is still being shown starts then', () => {
    const state = after(resting(), { type: 'settingsChanged', change: { cap: 'flat' } }, { type: 'startPressed' });
    expect(state.session.opening?.then).toBe('run');
    expect(after(state, ...openedMessages(2)).session.phase.name).toBe('running');
  });

  test('is cancelled once', () => {
    const asked = reduce(running(), { type: 'cancelPressed' });
    expect(leaves(asked).asked).toBe('cancel');
    expect(working(asked)).toEqual(['Reset']);
    const state = reduce(asked, answered({ type: 'ended', run: 1, stop: 'cancelled', progress: progress(0, 5) }));
    expect(statusSentence(state)).toBe('Stopped at 146.0; it was still falling.');
  });
});
