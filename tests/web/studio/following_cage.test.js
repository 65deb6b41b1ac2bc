// SPDX-License-Identifier: MIT
/**
 * @file A run whose cage holds something follows a hand that moves the cage's points, on the real core: without a new run, in
 * one step, to where a run of the moved cage ends.
 */
import { readFileSync } from 'node:fs';
import { beforeAll, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { problemOfEditing } from '../../../web/pages/studio/state/editing.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { createStudio } from './real.js';

/** @typedef {import('../../../web/cage/polygons.js').Point} Point */
/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */

beforeAll(() => load());

const start = /** @type {const} */ ({ type: 'startPressed' });
/** @type {Action} */
const edits = { type: 'viewChanged', change: { pointer: 'edit' } };
/** @param {Point} by @returns {Action} */
const drag = (by) => ({ type: 'cageDragged', by });
/** @param {Point} by @returns {Action} */
const drop = (by) => ({ type: 'cageEdited', edit: { kind: 'move', by } });

const fish = readFileSync(new URL('../../../web/samples/fish.obj', import.meta.url), 'utf8');

/** A studio in which a fish has been minimized whose body is held. @param {string} text */
function minimized(text) {
  const studio = createStudio('?shape=cube');
  studio.do({ type: 'fileChosen', name: 'fish.obj', text: new TextEncoder().encode(text) });
  studio.do(
    { type: 'settingsChanged', change: { functional: 'bending', levels: [1, 1], tolerance: 1e-9 } },
    { type: 'groupHeld', name: 'body', held: true },
    { type: 'closenessChanged', closeness: { weight: 8000 } },
    start,
  );
  return studio;
}

/** The same, with the vertex of the held body selected that is farthest to one side. */
function held() {
  const studio = minimized(fish);
  studio.do(edits);
  const { points = [], faces = [], groups = [] } = studio.state.view.editing?.cage ?? {};
  const body = groups.find(({ name }) => name === 'body')?.faces ?? [];
  const [widest] = body.flatMap((face) => faces[face]).sort((a, b) => points[b][1] - points[a][1]);
  studio.do({ type: 'cageSelected', selection: { points: [widest], faces: [] } });
  return studio;
}

/** @param {ReturnType<typeof createStudio>} studio */
const energy = ({ state }) => Number(state.document.result.levels.at(-1)?.energy);

test('a held vertex that is dragged takes the surface along; undo brings back what was', () => {
  const studio = held();
  const { run } = studio.state.session;
  const [before, source, { length }] = [energy(studio), studio.state.document.cage?.source, studio.state.history.past];
  for (const z of [0.01, 0.02, 0.03]) {
    studio.dispatch(drag([0, 0, z]));
    studio.work(3);
    expect(problemOfEditing(studio.state)).toBeNull();
    expect(studio.state.session.phase.name).toBe('running');
  }
  studio.do(drop([0, 0, 0.04]));
  expect(studio.state.session).toMatchObject({ run, phase: { name: 'ended' } });
  expect(energy(studio)).not.toBeCloseTo(before, 4);
  expect(studio.state.history.past).toHaveLength(length + 1);
  expect(undoName(studio.state)).toBe('move a part of the cage');

  const { cage } = studio.state.document;
  if (cage?.source.kind !== 'text') throw new Error('not a text');
  expect(studio.state.view.editing).toMatchObject({ source: cage.source, drag: null });
  const fresh = minimized(String(cage.source.text));
  expect(energy(studio) / energy(fresh)).toBeCloseTo(1, 6);

  studio.do({ type: 'undoPressed' });
  expect(studio.state.document.cage?.source).toBe(source);
  expect(energy(studio)).toBe(before);
  studio.do({ type: 'redoPressed' });
  expect(studio.state.document.cage?.source).toBe(cage.source);
});

test('faces are not edited while the run follows', () => {
  const studio = held();
  studio.dispatch(drag([0, 0, 0.05]));
  studio.work(3);
  studio.dispatch({ type: 'cageSelected', selection: { points: [], faces: [0] } });
  studio.dispatch({ type: 'cageEdited', edit: { kind: 'remove' } });
  expect(studio.state.view.editing?.said).toBe('A run goes on. Cancel it to edit the cage.');
  expect(studio.state.session.opening).toBeNull();
});

test('where nothing is held, a moved cage is another one', () => {
  const studio = createStudio('?shape=cube');
  studio.do({ type: 'settingsChanged', change: { levels: [1, 1] } }, start, edits);
  const { run } = studio.state.session;
  studio.do({ type: 'cageSelected', selection: { points: [0], faces: [] } }, drag([0, 0, 0.05]));
  expect(studio.state.session.phase.name).toBe('ended');
  studio.do(drop([0, 0, 0.1]));
  expect(studio.state.session.run).toBeGreaterThan(run);
  expect(studio.state.session.phase.name).toBe('resting');
});
