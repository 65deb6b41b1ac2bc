// SPDX-License-Identifier: MIT
/**
 * @file A minimizer of the catalog in the studio: opened as the end of a run, minimized again from its cage, and missing.
 */
import { describe, expect, test } from '@jest/globals';
import { formatStudioAddress, parseStudioAddress } from '../../../web/address/studio.js';
import { addressOf } from '../../../web/pages/studio/state/address.js';
import { findEntry, showsEntry } from '../../../web/pages/studio/state/entry.js';
import { initialState } from '../../../web/pages/studio/state/reduce.js';
import { statusSentence } from '../../../web/pages/studio/state/select.js';
import { defaultSettings, problemOf } from '../../../web/pages/studio/state/settings.js';
import { catalog, report } from '../catalog.js';
import { after, answered, leaves, openedMessages, stepped, surfaceState } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** @param {string} search */
const opened = (search) => initialState('system', parseStudioAddress(search));
/** @param {State} state */
const address = (state) => formatStudioAddress(addressOf(state));

/** @param {State} state @param {string} [shape] @returns {import('../../../web/pages/studio/state/types.js').Action} */
function loaded(state, shape = 'two-3') {
  const name = state.session.wanted ?? { shape, functional: 'bending' };
  const found = findEntry(catalog(), name);
  if ('missing' in found) return { type: 'entryMissing', name, message: found.missing };
  return { type: 'entryLoaded', name, ...found, report: report(shape, name.functional) };
}

/** The page with the catalog's bending minimizer on it. @param {string} [search] */
function shown(search = '?shape=two-3&functional=bending') {
  const waiting = opened(search);
  return after(waiting, loaded(waiting), ...openedMessages(1));
}

describe('an entry of the catalog', () => {
  test('is waited for before anything is opened, and then opened from its points at its level', () => {
    const waiting = opened('?shape=two-3&functional=bending');
    expect(waiting.session.opening).toBe(null);
    expect(waiting.session.wanted).toEqual({ shape: 'two-3', functional: 'bending' });
    const state = after(waiting, loaded(waiting));
    expect(state.session.wanted).toBe(null);
    expect(state.session.opening).toMatchObject({
      purpose: 'entry',
      then: 'hold',
      start: { level: 4, points: Float64Array.from(report().surface.points) },
      source: { kind: 'generated', name: 'two-3', family: 'flag', thickness: 1 },
    });
    const { source, settings, start } = /** @type {import('../../../web/pages/studio/state/types.js').Opening} */ (
      state.session.opening
    );
    expect(problemOf(source, settings, start)).toMatchObject({ terms: { bending: 1 }, options: { levels: [0, 4] } });
  });

  test('is the end of the run that the catalog tells of: energies, levels, limit and certificate', () => {
    const state = shown();
    expect(leaves(state)).toMatchObject({ status: 'ended', stop: 'converged', samples: [] });
    expect(state.document.result.levels.map(({ level, energy_reported }) => [level, energy_reported])).toEqual([
      [3, 112.7675],
      [4, 112.7675],
    ]);
    expect(state.document.result.limit).toEqual({ status: 'converging', energy: 112.767, order: 5.7, error: 0.0076 });
    expect(state.document.result.certificate?.negative).toBe(0);
    expect(state.document.result.settings).toMatchObject({
      functional: 'bending',
      levels: [0, 4],
      tolerance: 1e-7,
      max_iterations: 500,
    });
    expect(state.document.cage).toMatchObject({ name: 'two-3', source: { kind: 'generated' } });
    expect(statusSentence(state)).toBe('The catalog’s minimizer: 112.7670, within 0.0068\u202f%.');
    expect(state.view.fits).toBe(1);
  });

  test('has the catalog’s energies before the worker has measured it; null is what diverges', () => {
    const waiting = opened('?shape=two-3&functional=bending');
    const [first] = openedMessages(1);
    const { latest } = after(waiting, loaded(waiting), first).document.result;
    expect(latest?.energies).toMatchObject({ bending: 112.7675, second_form_variation: NaN, quadrature_error: 1e-5 });
  });

  test('of a blend has its weights', () => {
    const waiting = opened('?shape=two-3&functional=bending_mvs_cross');
    const { settings } = after(waiting, loaded(waiting)).document;
    expect(settings.functional).toBe('blend');
    expect(settings.weights).toMatchObject({ bending: 1, mvs_cross: 1, mvs: 0, willmore: 0 });
  });

  test('is gone on from as any surface is, at its level', () => {
    const state = after(shown(), { type: 'settingsChanged', change: { origin: 'surface' } }, { type: 'startPressed' });
    expect(state.session.opening).toMatchObject({
      purpose: 'start',
      source: { kind: 'generated', name: 'two-3' },
      start: surfaceState(0, 1),
    });
  });

  test('is minimized again from its cage with its settings, whatever has been chosen since', () => {
    const changed = after(shown(), {
      type: 'settingsChanged',
      change: { functional: 'mvs', cap: 'flat', origin: 'surface' },
    });
    const again = after(changed, { type: 'againPressed' });
    expect(again.session.opening).toMatchObject({
      purpose: 'start',
      then: 'run',
      start: null,
      source: { kind: 'generated', name: 'two-3' },
      settings: { functional: 'bending', cap: 'smooth', levels: [0, 4], tolerance: 1e-7, origin: 'cage' },
    });
    const [openedAgain] = openedMessages(2);
    const running = after(again, openedAgain, stepped(2, 3));
    expect(leaves(running)).toMatchObject({ status: 'running', levels: [], limit: null, certificate: null });
    expect(showsEntry(running)).toBe(false);
    expect(running.document.minimizer?.entry.energy).toBe(112.767); // to compare with
    expect(after(running, { type: 'againPressed' })).toBe(running);
  });

  test('comes back when the worker is lost', () => {
    const lost = after(shown(), { type: 'workerLost', loss: 'broken', detail: '' });
    expect(lost.session.opening).toMatchObject({ purpose: 'recovery', start: surfaceState(0, 1) });
    const back = after(lost, ...openedMessages(2));
    expect(showsEntry(back)).toBe(true);
    expect(leaves(back)).toMatchObject({ status: 'ended', levels: lost.document.result.levels });
  });

  test('is forgotten with its cage', () => {
    const state = after(shown(), { type: 'generatorChanged', change: { name: 'two-4' } }, ...openedMessages(2));
    expect(state.document.minimizer).toBe(null);
  });
});

describe('an entry that is not there', () => {
  test.each([
    ['?shape=two-5&functional=bending', /no shape “two-5”/],
    ['?shape=two-3&functional=willmore', /no functional “willmore”/],
    ['?shape=two-3&functional=mvs', /^All collapsed\.$/],
    ['?shape=sphere&functional=mvs', /no minimizer of “mvs” for “sphere”/],
  ])('%s leaves a notice and the cage', (search, message) => {
    const waiting = opened(search);
    const state = after(waiting, loaded(waiting));
    expect(state.view.alert?.message).toMatch(message);
    expect(state.session.opening).toMatchObject({
      purpose: 'cage',
      source: { kind: 'generated', name: waiting.document.generator.name },
    });
    expect(leaves(after(state, ...openedMessages(1)))).toMatchObject({ status: 'resting', alert: state.view.alert });
  });

  test('nor is its cage: the first one is opened, and the notice stays', () => {
    const waiting = opened('?shape=two-5000&functional=bending');
    const state = after(
      waiting,
      loaded(waiting),
      answered({ type: 'failed', run: 1, kind: 'input', message: 'unknown cage' }),
    );
    expect(state.session.opening?.source).toMatchObject({ kind: 'generated', name: 'two-3' });
    const open = after(state, ...openedMessages(2));
    expect(open.view.alert?.title).toBe('two-5000 was not opened');
    expect(address(open)).toBe('?shape=two-3');
  });

  test('or whose points do not fit its cage, leaves the cage', () => {
    const waiting = opened('?shape=two-3&functional=bending');
    const failed = answered({ type: 'failed', run: 1, kind: 'input', message: '4 points, not 103' });
    const state = after(waiting, loaded(waiting), failed);
    expect(state.view.alert?.message).toBe('4 points, not 103');
    expect(state.session.opening).toMatchObject({ run: 2, purpose: 'cage' });
  });

  test('is not waited for when another cage is chosen meanwhile', () => {
    const waiting = opened('?shape=two-3&functional=bending');
    const chosen = after(waiting, { type: 'generatorChanged', change: { name: 'two-4' } });
    expect(after(chosen, loaded(waiting))).toBe(chosen);
    expect(after(chosen, { type: 'entryMissing', name: { shape: 'two-3', functional: 'bending' }, message: '' })).toBe(
      chosen,
    );
  });
});

describe('the studio’s address', () => {
  test('that says nothing asks for the settings that the studio begins with', () => {
    expect(initialState().document.settings).toEqual(defaultSettings);
    expect(opened('').document.settings).toEqual(defaultSettings);
  });

  test.each([
    '?shape=two-3',
    '?shape=cube-frame&shading=kappa1&camera=-20,5,1.3',
    '?shape=two-4&functional=bending&start=cage&family=hub&thickness=0.6',
    '?shape=two-3&accuracy=0.01',
    '?shape=torus&functional=blend&start=cage&weights=bending:1,mvs_cross:2&cap=flat&symmetry=off&levels=1..3',
  ])('%s opens a cage whose address it is', (search) => {
    expect(address(after(opened(search), ...openedMessages(1)))).toBe(search);
  });

  test('of an entry is the entry’s, while it loads, while it opens, when it is shown, with shading and camera', () => {
    const search = '?shape=two-3&functional=bending&shading=gaussian&camera=10,-20,0.8';
    const waiting = opened(search);
    const opening = after(waiting, loaded(waiting));
    for (const state of [waiting, opening, shown(search)]) expect(address(state)).toBe(search);
    // What is to be minimized next does not change what is shown.
    expect(address(after(shown(search), { type: 'settingsChanged', change: { cap: 'flat' } }))).toBe(search);
  });

  test('of a run is its cage’s and asks for what is minimized', () => {
    const [openedAgain] = openedMessages(2);
    const again = after(shown(), { type: 'againPressed' }, openedAgain);
    expect(address(again)).toBe('?shape=two-3&functional=bending&start=cage&levels=0..4');
  });

  test('of a file’s cage names no shape', () => {
    const file = after(shown(), { type: 'fileChosen', name: 'a.obj', text: new Uint8Array() }, ...openedMessages(2), {
      type: 'viewChanged',
      change: { shading: 'plain' },
    });
    expect(address(file)).toBe('?shading=plain');
  });

  test('that is broken is told, and what is left of it holds', () => {
    const state = after(opened('?shape=two-4&shading=red&functional=length&start=cage'), ...openedMessages(1));
    expect(state.view.alert?.message).toMatch(/“shading=red”.* functional “length”/);
    expect(leaves(state)).toMatchObject({
      generator: { name: 'two-4' },
      shading: 'mean',
      settings: { functional: 'mvs_cross' },
    });
  });
});
