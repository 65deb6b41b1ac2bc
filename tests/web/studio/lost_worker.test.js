// SPDX-License-Identifier: MIT
/**
 * @file What is left of the page's state when the worker is lost, and how it comes back.
 */
import { describe, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { after, drop, leaves, openedMessages, resting, running, surfaceState, working } from './state.js';
import { createStudio } from './real.js';

describe('a worker that is lost', () => {
  test('leaves the last surface, which is opened again and gone on from', () => {
    const before = running();
    const lost = reduce(before, { type: 'workerLost', loss: 'silent', detail: '' });
    expect(leaves(lost)).toMatchObject({ status: 'ended', stop: 'interrupted', settings: { origin: 'surface' } });
    expect(lost.view.surface).toBe(before.view.surface);
    expect(lost.document.result.samples).toBe(before.document.result.samples);
    expect(lost.session.opening).toMatchObject({ purpose: 'recovery', start: surfaceState(0, 5) });
    expect(lost.view.alert?.message).toMatch(/5 evaluations is kept/);
    const back = after(lost, ...openedMessages(2));
    expect(leaves(back)).toMatchObject({
      status: 'ended',
      run: 2,
      samples: before.document.result.samples,
      opening: null,
    });
    expect(working(back)).toEqual(['Start', 'Step', 'Reset']);
    expect(reduce(back, { type: 'startPressed' }).session.opening).toMatchObject({
      start: surfaceState(0, 5),
      then: 'run',
    });
  });

  test('while it opened a file leaves the cage that was there', () => {
    const lost = after(resting(), drop('huge.obj'), { type: 'workerLost', loss: 'abandoned', detail: '' });
    expect(lost.session.opening).toMatchObject({ purpose: 'recovery', source: { name: 'two-3' } });
    expect(leaves(after(lost, ...openedMessages(3)))).toMatchObject({ status: 'resting', cage: { name: 'two-3' } });
  });

  test('a second time while the surface was brought back is not tried a third time', () => {
    const loss = /** @type {const} */ ({ type: 'workerLost', loss: 'broken', detail: 'out of memory' });
    const lost = after(running(), loss, loss);
    expect(lost.session.opening).toBeNull();
    expect(lost.session.phase.name).toBe('ended');
    expect(lost.document.result.saved?.state).toEqual(surfaceState(0, 5));
    expect(lost.view.alert?.message).toMatch(/out of memory/);
  });

  test('because of settings gives back those that worked', () => {
    const lost = after(
      resting(),
      { type: 'settingsChanged', change: { levels: [5, 6] } },
      { type: 'workerLost', loss: 'silent', detail: '' },
    );
    expect(lost.document.settings.levels).toEqual([0, 2]);
  });

  test('for good leaves a page that says so', () => {
    const lost = reduce(initialState(), { type: 'workerLost', loss: 'unloadable', detail: '' });
    expect(leaves(lost)).toMatchObject({ status: 'unavailable', opening: null });
    expect(working(lost)).toEqual([]);
    expect(lost.view.alert?.message).toMatch(/WebAssembly/);
    expect(reduce(lost, drop('spot.obj'))).toBe(lost);
    const again = reduce(lost, { type: 'retryPressed' });
    expect(leaves(again)).toMatchObject({ status: 'loading', alert: null, opening: { source: { name: 'two-3' } } });
    expect(leaves(after(again, ...openedMessages(2)))).toMatchObject({ status: 'resting', cage: { name: 'two-3' } });
  });

  test('for good in the middle of a run keeps its surface for another try', () => {
    const loss = /** @type {const} */ ({ type: 'workerLost', detail: '' });
    const lost = after(running(), { ...loss, loss: 'broken' }, { ...loss, loss: 'unloadable' });
    expect(leaves(lost)).toMatchObject({ status: 'unavailable', saved: { evaluations: 5 } });
    const again = reduce(lost, { type: 'retryPressed' });
    expect(again.session.opening).toMatchObject({ purpose: 'recovery', start: surfaceState(0, 5) });
    expect(leaves(after(again, ...openedMessages(3)))).toMatchObject({ status: 'ended', stop: 'interrupted' });
  });

  test('is replaced by one on the real core that goes on from the last copy, after a trap and after another', async () => {
    await load();
    const studio = createStudio();
    studio.do({ type: 'settingsChanged', change: { levels: [0, 3] } });
    for (let i = 0; i < 2; i++) {
      studio.dispatch({ type: 'startPressed' });
      do studio.work(1);
      while (!studio.state.document.result.samples.length || !studio.state.document.result.saved?.evaluations);
      const { saved } = studio.state.document.result;
      expect(studio.state.session.phase.name).toBe('running');
      studio.lose('broken');
      studio.work();
      expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'interrupted', saved });
    }
    studio.do({ type: 'startPressed' });
    expect(studio.state.document.result.stop).toBe('converged');
    studio.do({ type: 'undoPressed' });
    expect(studio.state.document.result.stop).toBe('interrupted');
  });
});
