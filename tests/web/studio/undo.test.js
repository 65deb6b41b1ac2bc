// SPDX-License-Identifier: MIT
/**
 * @file Undo and redo on the real core: what is a step, what it is called, and that everything comes back.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { MOST_BYTES, MOST_STEPS, redoName, undoName } from '../../../web/pages/studio/state/history.js';
import { fish } from '../../browser/fish.js';
import { bytes, createStudio } from './real.js';
import { after, answered, drop, leaves, openedMessages, resting } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').Settings} Settings */

beforeAll(() => load());

const undo = /** @type {const} */ ({ type: 'undoPressed' });
const redo = /** @type {const} */ ({ type: 'redoPressed' });
const start = /** @type {const} */ ({ type: 'startPressed' });
/** @param {Partial<Settings>} change @returns {Action} */
const set = (change) => ({ type: 'settingsChanged', change });
/** @type {Action} */
const dropFish = { type: 'fileChosen', name: 'fish.obj', text: new TextEncoder().encode(fish()) };
const bending = set({ functional: 'bending', levels: [0, 1] });

/** A studio with a converged run of bending. */
function minimized() {
  const studio = createStudio('?shape=cube');
  studio.do(bending, start);
  expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'converged' });
  return studio;
}

/** @param {ReturnType<typeof createStudio>} studio */
const shown = ({ state }) => [...(state.view.surface?.control.positions ?? [])];

describe('a step', () => {
  test('is named after what was done, and is none where nothing was', () => {
    const studio = createStudio('?shape=cube');
    studio.do();
    expect(undoName(studio.state)).toBeNull();
    studio.do({ type: 'viewChanged', change: { cage: true } }, { type: 'fitPressed' }, set({}));
    expect(undoName(studio.state)).toBeNull();
    /** @type {Array<[Action, string]>} */
    const done = [
      [bending, 'minimize Bending energy'],
      [set({ cap: 'flat' }), 'choose the cap'],
      [{ type: 'vertexPinned', vertex: 3 }, 'pin vertex 3'],
      [dropFish, 'open fish.obj'],
      [{ type: 'groupHeld', name: 'head', held: true }, 'hold head'],
      [{ type: 'holdEdited', how: 'invert' }, 'invert what is held'],
      [{ type: 'stepPressed' }, 'minimize'],
      [{ type: 'resetPressed' }, 'reset'],
    ];
    for (const [action, name] of done) {
      studio.do(action);
      expect(undoName(studio.state)).toBe(name);
    }
    expect(studio.state.history.past).toHaveLength(done.length);
    studio.do(undo);
    expect([undoName(studio.state), redoName(studio.state)]).toEqual(['minimize', 'reset']);
    studio.do(set({ tolerance: 0.1 }));
    expect(redoName(studio.state)).toBe('reset'); // settings stand still in a run that is paused
    studio.do({ type: 'cancelPressed' }, set({ tolerance: 0.1 }));
    expect(redoName(studio.state)).toBeNull();
  });

  test('is a whole stroke of the brush, unless it comes back to where it was', () => {
    const studio = createStudio('?shape=cube');
    /** @param {number} face @param {boolean} held @returns {Action} */
    const paint = (face, held) => ({ type: 'facesPainted', faces: [face], held });
    studio.do(paint(0, true), paint(1, true), paint(2, true), { type: 'paintingEnded' });
    studio.do(paint(3, true), { type: 'paintingEnded' });
    expect(studio.state.history.past.map(({ name }) => name)).toEqual(['hold faces', 'hold faces']);
    studio.do(paint(4, true), paint(4, false), { type: 'paintingEnded' });
    expect(studio.state.history.past).toHaveLength(2);
    studio.do(undo);
    expect(studio.state.document.settings.constraints).toEqual({ hold: { faces: [1, 2, 3] } });
  });

  test('is none where the core refused, and another one of a shape that is chosen before the last has opened', () => {
    const studio = createStudio('?shape=cube');
    studio.do(set({ levels: [0, 40] }));
    expect(studio.state.view.alert?.title).toBe('These settings cannot be used');
    studio.do({ type: 'fileChosen', name: 'bad.obj', text: new TextEncoder().encode('f 1 2') });
    expect(studio.state.history.past).toEqual([]);
    studio.dispatch({ type: 'generatorChanged', change: { name: 'torus' } });
    studio.dispatch({ type: 'generatorChanged', change: { name: 'two-4' } });
    studio.work();
    expect(studio.state.history.past).toHaveLength(1);
    studio.do(undo);
    expect(leaves(studio.state)).toMatchObject({ cage: { name: 'cube' }, generator: { name: 'cube' } });
  });

  test('is forgotten after many others', () => {
    const studio = createStudio('?shape=cube');
    studio.do();
    for (let i = 0; i < MOST_STEPS + 5; i++) studio.dispatch(set({ tolerance: 1 / (i + 1) }));
    expect(studio.state.history.past).toHaveLength(MOST_STEPS);
  });

  test('is forgotten when the surfaces of those after it take too much memory', () => {
    const large = /** @type {any} */ ({ level: 6, points: { length: (0.4 * MOST_BYTES) / 8 } });
    let state = after(resting(), { type: 'settingsChanged', change: { cap: 'flat' } }, ...openedMessages(2));
    for (let run = 3; run < 8; run++) {
      const saved = answered({ type: 'saved', run: run - 1, evaluations: 0, state: large });
      state = after(state, saved, drop(`${run}.obj`), ...openedMessages(run));
    }
    expect(state.history.past.map(({ name }) => name)).toEqual(['open 6.obj', 'open 7.obj']);
  });
});

test('the texts of cages count as memory too, each once', () => {
  let state = resting();
  for (let run = 2; run < 8; run++) {
    const text = new Uint8Array(0.4 * MOST_BYTES);
    state = after(state, { type: 'fileChosen', name: `${run}.obj`, text }, ...openedMessages(run));
    state = after(state, { type: 'startPressed' }, { type: 'viewChanged', change: {} });
    state = { ...state, session: { ...state.session, phase: { name: 'resting' } } };
  }
  // The first two go back to the same cage, the last one to another: 0.8 of what may be remembered.
  expect(state.history.past.map(({ name }) => name)).toEqual(['minimize', 'open 7.obj', 'minimize']);
});

describe('undo', () => {
  test.each(
    /** @type {Array<[string, Action]>} */ ([
      ['a file that was dropped', dropFish],
      ['another shape', { type: 'generatorChanged', change: { name: 'two-3' } }],
      ['a moved slider', { type: 'generatorChanged', change: { thickness: 1.2 } }],
      ['another run', start],
      ['a reset', { type: 'resetPressed' }],
    ]),
  )('after %s brings the surface back with all that was known of it', (_, action) => {
    const studio = minimized();
    const before = bytes(studio.state.document);
    const surface = shown(studio);
    studio.do(action);
    const there = bytes(studio.state.document);
    expect(there).not.toBe(before);
    const other = shown(studio);
    studio.do(undo);
    expect(bytes(studio.state.document)).toBe(before);
    expect(shown(studio)).toEqual(surface);
    expect(studio.state.session.phase.name).toBe('ended');
    studio.do(redo);
    expect(bytes(studio.state.document)).toBe(there);
    expect(shown(studio)).toEqual(other);
  });

  test('while a run goes on keeps its last copy, from which redo goes on', () => {
    const studio = createStudio();
    studio.do();
    studio.dispatch(start);
    studio.work(40);
    expect(studio.state.session.phase.name).toBe('running');
    const { saved } = studio.state.document.result;
    expect(saved?.evaluations).toBeGreaterThan(0);
    studio.dispatch(undo);
    studio.work();
    expect(leaves(studio.state)).toMatchObject({ status: 'resting', samples: [] });
    studio.do(redo);
    expect(leaves(studio.state)).toMatchObject({ status: 'paused', saved });
    expect(studio.state.document.result.samples.at(-1)?.evaluation).toBe(saved?.evaluations);
    studio.do(start);
    const { samples, stop } = studio.state.document.result;
    expect(stop).toBe('converged');
    expect(samples.map(({ evaluation }) => evaluation)).toEqual(samples.map((_, i) => i + 1));
    expect(samples[(saved?.evaluations ?? 0) + 1].energy).toBeLessThan(samples[0].energy);
  });

  test('of what is held leaves a run that goes on alone', () => {
    const studio = createStudio();
    studio.do();
    studio.dispatch(start);
    studio.work(20);
    studio.dispatch({ type: 'vertexPinned', vertex: 1 });
    studio.work(20);
    const { run } = studio.state.session;
    studio.dispatch(undo);
    expect(leaves(studio.state)).toMatchObject({ status: 'running', run, settings: { constraints: {} } });
    expect(redoName(studio.state)).toBe('pin vertex 1');
  });
});

test('200 random steps of undo and redo end in the same bytes, wherever they go and however far the worker comes', () => {
  const studio = createStudio('?shape=cube');
  studio.do(
    bending,
    { type: 'vertexPinned', vertex: 2 },
    { type: 'vertexPinned', vertex: 7 },
    start,
    set({ functional: 'willmore' }),
    start,
    { type: 'generatorChanged', change: { name: 'two-3' } },
    set({ cap: 'flat' }),
    { type: 'stepPressed' },
    dropFish,
    { type: 'groupHeld', name: 'head', held: true },
    { type: 'resetPressed' },
    { type: 'stepPressed' },
    { type: 'cancelPressed' },
    set({ origin: 'surface' }),
    start,
  );
  const count = studio.state.history.past.length;
  expect(count).toBeGreaterThan(12);

  /** All documents along the history, from its end to its beginning. */
  function walk() {
    const found = [];
    while (redoName(studio.state)) studio.do(redo);
    for (let i = 0; i < count; i++) {
      found.push(bytes(studio.state.document));
      studio.do(undo);
    }
    expect(undoName(studio.state)).toBeNull();
    return [...found, bytes(studio.state.document)];
  }

  const before = walk();
  expect(new Set(before).size).toBe(count + 1);
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 200; i++) {
    studio.dispatch(random() < 0.5 ? undo : redo);
    studio.work(Math.floor(random() * 6));
  }
  studio.work();
  const after = walk();
  for (const [i, document] of after.entries()) expect(JSON.parse(document)).toEqual(JSON.parse(before[i]));
  expect(after).toEqual(before);
}, 300_000);
