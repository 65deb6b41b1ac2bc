// SPDX-License-Identifier: MIT
/**
 * @file What the page's state becomes when a file is opened: of a cage, a problem or a report, or one that is refused.
 */
import { describe, expect, test } from '@jest/globals';
import { reduce } from '../../../web/pages/studio/state/reduce.js';
import { defaultSettings, problemOf } from '../../../web/pages/studio/state/settings.js';
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
  resting,
  running,
  stepped,
  surfaceState,
} from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

describe('a file', () => {
  test('is not lost when a setting changes before it has opened', () => {
    const change = { type: /** @type {const} */ ('settingsChanged'), change: { cap: /** @type {const} */ ('flat') } };
    const opening = after(resting(), drop('spot.obj'), change);
    expect(opening.session.opening).toMatchObject({
      run: 3,
      purpose: 'cage',
      source: { kind: 'text', name: 'spot.obj' },
      settings: { cap: 'flat' },
    });
  });

  test('is opened beside what is there, which stays until it has opened', () => {
    const opening = after(resting(), drop('spot.obj'));
    expect(opening.session.opening).toMatchObject({
      run: 2,
      purpose: 'cage',
      source: { kind: 'text', name: 'spot.obj' },
    });
    expect(opening.document.cage?.name).toBe('two-3');
    const opened = after(opening, ...openedMessages(2));
    expect(leaves(opened)).toMatchObject({ run: 2, fits: 2, opening: null, cage: { name: 'spot.obj' } });
  });

  test('that is refused leaves everything as it was, with the reason', () => {
    const before = ended();
    const refused = after(
      before,
      drop('bad.obj'),
      answered({ type: 'failed', run: 2, kind: 'input', message: 'bad.obj: line 12: face has 2 vertices' }),
    );
    expect(refused.view.alert).toEqual({ title: 'bad.obj was not opened', message: 'line 12: face has 2 vertices' });
    for (const part of /** @type {const} */ (['surface', 'cage', 'run', 'samples', 'saved', 'status', 'settings'])) {
      expect(leaves(refused)[part]).toBe(leaves(before)[part]);
    }
    expect(reduce(refused, { type: 'alertDismissed' }).view.alert).toBeNull();
  });

  test('does not disturb a run that goes on when it is refused', () => {
    const state = after(
      running(),
      drop('bad.obj'),
      answered({ type: 'failed', run: 2, kind: 'input', message: 'line 1: no' }),
      stepped(1, 2),
    );
    expect(state.session.phase.name).toBe('running');
    expect(state.document.result.samples).toHaveLength(7);
  });

  test('that opens clears the alert about the one before', () => {
    const refused = after(
      resting(),
      drop('bad.obj'),
      answered({ type: 'failed', run: 2, kind: 'input', message: 'no' }),
    );
    expect(after(refused, drop('good.obj'), ...openedMessages(3)).view.alert).toBeNull();
  });
});

describe('the file of a cage that is no text', () => {
  test('is kept as the text that the core has made of it', () => {
    const [first, ...others] = openedMessages(2);
    const message = /** @type {any} */ (first).message;
    const state = after(resting(), drop('cube.ply'), answered({ ...message, text: 'v 1 2 3' }), ...others);
    expect(state.document.cage?.source).toEqual({ kind: 'text', name: 'cube.ply', text: 'v 1 2 3' });
  });
});

describe('the file of a problem or a report', () => {
  const json = new TextEncoder().encode(' {"umbilic": "report"}');
  const asked = {
    cage: { generator: 'torus', ratio: 0.3 },
    terms: { bending: 1 },
    options: { cap: /** @type {const} */ ('flat'), levels: /** @type {[number, number]} */ ([1, 3]) },
  };
  /** @param {any} [report] @returns {State} */
  function opened(report) {
    const [first, ...others] = openedMessages(2);
    const message = /** @type {any} */ (first).message;
    return after(
      resting(),
      { type: 'fileChosen', name: 'kept.json', text: json },
      answered({ ...message, asked, ...(report && { report }) }),
      ...others,
    );
  }

  test('is told from a cage by its first character, and opened as it is', () => {
    const opening = after(resting(), { type: 'fileChosen', name: 'kept.json', text: json });
    expect(opening.session.opening?.source).toEqual({ kind: 'problem', name: 'kept.json', text: json });
    expect(problemOf(/** @type {any} */ (opening.session.opening).source, defaultSettings, null)).toBe(
      ' {"umbilic": "report"}',
    );
  });

  test('brings its cage and its settings', () => {
    const state = opened();
    expect(leaves(state)).toMatchObject({ status: 'resting', run: 2, generator: { name: 'torus', family: 'flag' } });
    expect(state.document.cage?.source).toEqual({
      kind: 'generated',
      name: 'torus',
      family: 'flag',
      thickness: 1,
      ratio: 0.3,
    });
    expect(state.document.settings).toMatchObject({
      functional: 'bending',
      cap: 'flat',
      levels: [1, 3],
      tolerance: 1e-6,
    });
    expect(state.document.result.settings).toEqual(state.document.settings);
  });

  test('of a report is the end of its run, which goes on from its surface', () => {
    const report = { levels: [levelReport(3)], limit: noLimit(), energies: energies(80), problem: asked };
    const state = opened(report);
    expect(leaves(state)).toMatchObject({
      status: 'ended',
      stop: 'converged',
      limit: noLimit(),
      levels: report.levels,
    });
    const again = reduce(state, { type: 'startPressed' });
    expect(again.session.opening).toMatchObject({ purpose: 'start', then: 'run', start: surfaceState(0, 2) });
  });
});
