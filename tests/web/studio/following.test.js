// SPDX-License-Identifier: MIT
/**
 * @file A run follows the weights of its blend on the real core, while it goes on, rests or has ended; undo leads it back.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { heldNormal } from '../../../web/pages/studio/state/normals.js';
import { createStudio } from './real.js';
import { leaves } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */

beforeAll(() => load());

const start = /** @type {const} */ ({ type: 'startPressed' });
const undo = /** @type {const} */ ({ type: 'undoPressed' });
const redo = /** @type {const} */ ({ type: 'redoPressed' });
/** @param {number} weight @param {boolean} [moving] @returns {Action} */
const weigh = (weight, moving = false) => ({ type: 'weightsChanged', weights: { mvs_cross: weight }, moving });

/** A studio with a blend of bending and MVS_cross on a frame, of which one level is asked. */
function blending(share = 0.01) {
  const studio = createStudio('?shape=two-3');
  const weights = { ...studio.state.document.settings.weights, bending: 1, mvs_cross: share };
  studio.do({ type: 'settingsChanged', change: { functional: 'blend', weights, levels: [1, 1] } });
  return studio;
}

/** Where a run with this weight ends. @param {number} share */
function minimum(share) {
  const studio = blending(share);
  studio.do(start);
  return energy(studio);
}

/** @param {ReturnType<typeof createStudio>} studio */
const energy = ({ state }) => Number(state.document.result.levels.at(-1)?.energy);

test('goes to the minimum of the last weight of a slider that is moved in the middle of a run, which is one step', () => {
  const studio = blending();
  studio.work();
  studio.dispatch(start);
  studio.work(12);
  const { length } = studio.state.history.past;
  for (const weight of [0.02, 0.05, 0.1]) {
    studio.dispatch(weigh(weight, true));
    studio.work(3);
    expect(studio.state.session.phase.name).toBe('running');
  }
  studio.do(weigh(0.1));
  expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'converged' });
  expect(energy(studio) / minimum(0.1)).toBeCloseTo(1, 5);
  expect(studio.state.document.result.settings.weights.mvs_cross).toBe(0.1);
  expect(studio.state.history.past).toHaveLength(length + 1);
  expect(undoName(studio.state)).toBe('change a weight');
});

test('of an ended run begins again from its surface, and undo and redo lead there and back', () => {
  const studio = blending();
  studio.do(start);
  const before = energy(studio);
  const { evaluation } = studio.state.document.result.samples.at(-1) ?? { evaluation: 0 };
  studio.do(weigh(0.011));
  const { samples, levels, stop } = studio.state.document.result;
  expect([levels.length, stop]).toEqual([1, 'converged']);
  expect(samples[0].evaluation).toBe(1);
  expect(samples.at(-1)?.evaluation).toBeLessThan(evaluation);
  const after = energy(studio);
  expect(after).toBeGreaterThan(1.001 * before);
  studio.do(undo);
  expect(energy(studio) / before).toBeCloseTo(1, 5);
  studio.do(redo);
  expect(energy(studio) / after).toBeCloseTo(1, 5);
});

test('waits in a run that is paused', () => {
  const studio = blending();
  studio.work();
  studio.dispatch(start);
  studio.work(12);
  studio.dispatch({ type: 'pausePressed' });
  studio.do(weigh(0.1));
  expect(studio.state.session.phase).toEqual({ name: 'paused', asked: null });
  expect(studio.state.document.result.samples).toEqual([]);
  studio.do(start);
  expect(energy(studio) / minimum(0.1)).toBeCloseTo(1, 5);
});

test('is not asked where nothing weighs, or where the run minimizes one functional', () => {
  const studio = blending();
  studio.do(start, { type: 'weightsChanged', weights: { bending: 0 } });
  expect(studio.state.document.result.stop).toBe('converged');
  const { targets } = studio.state.session;
  studio.do(weigh(0));
  expect(studio.state.session.targets).toBe(targets);

  const single = createStudio('?shape=cube');
  single.do({ type: 'settingsChanged', change: { functional: 'bending', levels: [0, 1] } }, start);
  const { result } = single.state.document;
  single.do({ type: 'settingsChanged', change: { functional: 'blend' } }, weigh(0.3));
  expect(single.state.session.targets).toBeNull();
  expect(single.state.document.result).toBe(result);
});

test('leads a pin to where its fields say, of a run of any functional; undo does not know where it lay at first', () => {
  const studio = createStudio('?shape=torus');
  studio.do(
    { type: 'settingsChanged', change: { functional: 'bending', levels: [0, 0] } },
    { type: 'vertexPinned', vertex: 1 },
    { type: 'vertexPinned', vertex: 25 },
    start,
  );
  const place = () => studio.state.document.result.constrained?.pins[0].position ?? [];
  const [x, y, z] = /** @type {[number, number, number]} */ (place());
  /** @param {number} up @param {boolean} moving @returns {Action} */
  const move = (up, moving) => ({ type: 'pinMoved', index: 0, at: [x + up, y, z], moving });
  studio.dispatch(move(0.05, true));
  studio.dispatch(move(0.1, true));
  studio.do(move(0.1, false));
  expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'converged' });
  expect(place()[0]).toBeCloseTo(x + 0.1, 9);
  expect(undoName(studio.state)).toBe('move a pin');
  studio.do(move(0.2, false));
  expect(place()[0]).toBeCloseTo(x + 0.2, 9);
  studio.do(undo);
  expect(place()[0]).toBeCloseTo(x + 0.1, 9);
  const { targets } = studio.state.session;
  studio.do(undo);
  expect(studio.state.session.targets).toBe(targets);
  expect(studio.state.document.settings.constraints.pins).toEqual([{ vertex: 1 }, { vertex: 25 }]);
});

test('turns the normal that a pin holds; held as it was, only a new run knows it', () => {
  const studio = createStudio('?shape=torus');
  /** @param {boolean | [number, number, number]} normal @param {boolean} [moving] @returns {Action} */
  const turn = (normal, moving = false) => ({ type: 'pinTurned', index: 0, normal, moving });
  studio.do(
    { type: 'settingsChanged', change: { functional: 'bending', levels: [1, 1] } },
    { type: 'vertexPinned', vertex: 1 },
    { type: 'vertexPinned', vertex: 25 },
  );
  const normal = () => [...(studio.state.view.surface?.limit.normals.slice(0, 3) ?? [])];
  studio.do(turn(true));
  expect(undoName(studio.state)).toBe('hold a normal');
  expect(studio.state.document.settings.constraints.pins?.[0]).toEqual({ vertex: 1, normal: true });
  const own = normal();
  studio.do(start);
  normal().forEach((x, axis) => expect(x).toBeCloseTo(own[axis], 5));

  const tilted = /** @type {[number, number, number]} */ ([own[0] + 0.1, own[1] - 0.2, own[2] + 0.2]);
  const length = Math.hypot(...tilted);
  studio.dispatch(turn([tilted[0] / 2, tilted[1] / 2, tilted[2] / 2], true));
  studio.do(turn(tilted));
  expect(undoName(studio.state)).toBe('turn a normal');
  expect(leaves(studio.state)).toMatchObject({ status: 'ended', stop: 'converged' });
  normal().forEach((x, axis) => expect(x).toBeCloseTo(tilted[axis] / length, 5));
  heldNormal({ vertex: 1, normal: tilted }, { normals: new Float32Array(3) })?.forEach((x, axis) =>
    expect(x).toBeCloseTo(tilted[axis] / length, 12),
  );

  const { targets } = studio.state.session;
  studio.do(turn([0, 0, 0]));
  expect(studio.state.document.settings.constraints.pins?.[0].normal).toEqual(tilted);
  studio.do(undo);
  expect(studio.state.session.targets).toBe(targets);
  expect(studio.state.document.settings.constraints.pins?.[0].normal).toBe(true);
  studio.do(turn(false));
  expect(studio.state.document.settings.constraints.pins?.[0]).toEqual({ vertex: 1 });
});
