// SPDX-License-Identifier: MIT
/**
 * @file What the user's choices at the boundaries of an open cage make of the state: conditions, fills and what the core
 * refuses of them; and how near the surface stays to the cage's own.
 */
import { describe, expect, test } from '@jest/globals';
import { conditionAt, filledBoundaries } from '../../../web/pages/studio/state/boundary.js';
import { heldFaces, problemOfCloseness } from '../../../web/pages/studio/state/hold.js';
import { boundaryLoops } from '../../../web/pages/studio/state/loops.js';
import { reduce } from '../../../web/pages/studio/state/reduce.js';
import { runButtons, statusSentence } from '../../../web/pages/studio/state/select.js';
import { defaultSettings, problemOf, settingsFrom } from '../../../web/pages/studio/state/settings.js';
import { boundaryOfFile, cageOnScreen } from '../../../web/pages/studio/state/taken.js';
import { withSettings } from '../../../web/pages/studio/state/parts.js';
import { after, answered, ended, leaves, openedMessages, resting, running, withCage } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */
/** @typedef {import('../../../wasm/types.js').BoundaryCondition} BoundaryCondition */

/** Six faces in a group, with three boundaries. */
const counts = {
  vertices: 20,
  edges: 30,
  faces: 6,
  genus: 0,
  components: [],
  groups: [{ name: 'plate', faces: 6 }],
  repairs: [],
  notes: /** @type {string[]} */ ([]),
  boundaries: [1, 2, 3].map((number) => ({ number, vertices: 4, first_vertex: 4 * number - 3, component: 1 })),
};
const plate = { name: 'plate', faces: [1, 2, 3, 4, 5, 6] };

/** A state whose cage is open. @param {State} state @returns {State} */
const opened = (state) => withCage(state, (cage) => ({ ...cage, groups: [plate], counts }));

/** @param {number | null} boundary @param {BoundaryCondition} condition @returns {Action} */
const hold = (boundary, condition) => ({ type: 'conditionChosen', boundary, condition });
/** @param {number | null} boundary @param {boolean} [filled] @returns {Action} */
const fill = (boundary, filled = true) => ({ type: 'fillPressed', boundary, filled });
/** @param {State} state */
const constraints = (state) => state.document.settings.constraints;
/** @param {State} state */
const held = (state) => [...heldFaces(constraints(state), cageOnScreen(state.document))].join('');

/** What the worker says of a run that fills boundary 2 by two faces; faces 4 to 6 are around it. @param {number} run @returns {Action} */
function filledMessage(run) {
  const [message] = openedMessages(run);
  if (message.type !== 'answered' || message.message.type !== 'opened') throw new Error('not opened');
  const notes = ["filled boundary 2 of 4 vertices with 2 faces, the group 'fill-2'"];
  const groups = [plate, { name: 'fill-2-rim', faces: [4, 5, 6] }, { name: 'fill-2', faces: [7, 8] }];
  return answered({
    ...message.message,
    cage: { ...counts, faces: 8, notes },
    groups,
    unfilled: { counts, corners: new Uint32Array(6).fill(4) },
  });
}

/** The page with boundary 2 filled. @returns {State} */
function withFill() {
  const asking = after(opened(resting()), fill(2));
  return after(asking, filledMessage(asking.session.opening?.run ?? 0));
}

describe('the condition', () => {
  test('of each boundary is tangent unless it is said, and what says nothing is left out', () => {
    const there = opened(resting());
    expect([1, 2, 3].map((number) => conditionAt(constraints(there), number))).toEqual([
      'tangent',
      'tangent',
      'tangent',
    ]);
    const chosen = after(there, hold(2, 'free'), hold(3, 'position'));
    expect(constraints(chosen)).toEqual({
      boundary: {
        loops: [
          { loop: 2, condition: 'free' },
          { loop: 3, condition: 'position' },
        ],
      },
    });
    expect(constraints(after(chosen, hold(2, 'tangent'), hold(3, 'tangent')))).toEqual({});
  });

  test('does not keep faces of a cage with holes from being held by their numbers', () => {
    const there = opened(resting());
    const state = withCage(there, (cage) => ({ ...cage, groups: [], counts: { ...counts, faces: 4, holes: 2 } }));
    expect(held(after(state, { type: 'facesPainted', faces: [5], held: true }))).toBe('000001');
  });

  test('of all replaces that of each, and the other way round', () => {
    const all = after(opened(resting()), hold(2, 'free'), hold(null, 'position'));
    expect(constraints(all)).toEqual({ boundary: { condition: 'position' } });
    const one = after(all, hold(1, 'tangent'));
    expect([1, 2].map((number) => conditionAt(constraints(one), number))).toEqual(['tangent', 'position']);
    expect(constraints(after(one, hold(null, 'tangent')))).toEqual({});
  });

  test('by stretches of a problem’s file is kept until the boundary gets one', () => {
    const loops = [{ loop: 2, from: 5, to: 7, condition: /** @type {const} */ ('free') }];
    const there = opened(resting());
    const state = withSettings(there, { constraints: { boundary: { loops } } });
    expect(conditionAt(constraints(state), 2)).toBeNull();
    expect(constraints(after(state, hold(1, 'free'))).boundary?.loops?.slice(0, 1)).toEqual(loops);
    expect(constraints(after(state, hold(2, 'tangent')))).toEqual({});
  });

  test('asks the core at rest, and waits while a run goes on or has ended', () => {
    expect(after(opened(resting()), hold(1, 'free')).session.opening).toMatchObject({ purpose: 'preview' });
    expect(after(opened(running()), hold(1, 'free')).session.opening).toBeNull();
    expect(after(opened(ended()), hold(1, 'free')).session.opening).toBeNull();
  });
});

describe('a fill', () => {
  test('of one boundary, of all, and taken back is that of the problem', () => {
    const source = /** @type {const} */ ({ kind: 'text', name: 'a.obj', text: '' });
    const one = after(opened(resting()), fill(2));
    expect(problemOf(source, one.document.settings, null)).toMatchObject({ fill: { loops: [2] } });
    expect(one.session.opening?.settings.fill).toEqual({ loops: [2] });
    const all = after(one, fill(null));
    expect(filledBoundaries(all.document.settings.fill, all.document.cage)).toEqual([1, 2, 3]);
    const back = after(all, fill(null, false));
    expect(back.document.settings.fill).toBeNull();
    expect(problemOf(source, back.document.settings, null)).not.toHaveProperty('fill');
    expect(settingsFrom(defaultSettings, { terms: { bending: 1 }, fill: {} }).fill).toEqual({});
    expect(filledBoundaries({}, all.document.cage)).toEqual([1, 2, 3]);
  });

  test('is shown at once after a run, too, whose surface has another cage', () => {
    expect(after(opened(ended()), fill(1)).session.opening).toMatchObject({ purpose: 'preview' });
    expect(after(opened(running()), fill(1)).session.opening).toBeNull();
  });

  test('holds what does not touch it, and is listed among the groups', () => {
    const filled = withFill();
    expect(filled.document.cage?.counts.faces).toBe(6);
    expect(filled.document.result.taken?.groups.map(({ name }) => name)).toEqual(['plate', 'fill-2-rim', 'fill-2']);
    expect(constraints(filled)).toEqual({});
    expect(held(filled)).toBe('11100000');
  });

  test('can be painted over but for its new faces, and nothing held is said', () => {
    const painted = after(withFill(), { type: 'facesPainted', faces: [3, 6], held: true });
    expect(constraints(painted)).toEqual({ hold: { faces: [1, 2, 3, 4] } });
    expect(held(painted)).toBe('11110000');
    const clear = after(painted, { type: 'holdEdited', how: 'clear' });
    expect(constraints(clear)).toEqual({ hold: {} });
    expect(held(clear)).toBe('00000000');
    const group = after(clear, { type: 'groupHeld', name: 'fill-2', held: true });
    expect(constraints(group)).toEqual({ hold: { groups: ['fill-2'] } });
  });

  test('leaves the other boundaries their numbers in the file, though the run counts them anew', () => {
    const filled = withFill();
    expect(
      [1, 2, 3].map((number) => boundaryOfFile(filled.document.cage, filled.document.result.taken, number)),
    ).toEqual([1, 3, null]);
    expect([1, 2, 3].map((number) => boundaryOfFile(opened(resting()).document.cage, null, number))).toEqual([1, 2, 3]);
  });

  test('that is taken back leaves no name of a group behind', () => {
    const clear = after(withFill(), { type: 'holdEdited', how: 'clear' });
    const group = after(clear, { type: 'groupHeld', name: 'fill-2', held: true });
    expect(constraints(after(group, fill(2, false)))).toEqual({});
    const both = after(group, { type: 'facesPainted', faces: [0], held: true });
    expect(constraints(after(both, fill(2, false)))).toEqual({ hold: { faces: [1] } });
    expect(constraints(after(both, fill(1)))).toEqual({ hold: { groups: ['fill-2'], faces: [1] } });
    expect(constraints(after(group, fill(1), fill(2, false)))).toEqual({ hold: {} });
  });

  test('of a problem’s file, which says what is free, goes on with another fill', () => {
    const filled = withFill();
    /** @param {import('../../../wasm/types.js').FaceSelection} free */
    const saying = (free) => withSettings(filled, { constraints: { free } });
    const byItself = saying({ groups: ['fill-2', 'fill-2-rim'], faces: [] });
    expect(held(byItself)).toBe(held(filled));
    expect(constraints(after(byItself, fill(1)))).toEqual({});
    const more = saying({ groups: ['fill-2'], faces: [6] });
    expect(held(more)).toBe('11111000');
    expect(constraints(after(more, fill(1)))).toEqual({ hold: { faces: [1, 2, 3, 4, 5] } });
  });

  test('takes the condition of its boundary with it', () => {
    const there = after(opened(resting()), hold(1, 'free'), hold(2, 'free'));
    expect(constraints(after(there, fill(2)))).toEqual({ boundary: { loops: [{ loop: 1, condition: 'free' }] } });
  });

  test('of a cage that is refined first has four faces for each of the file, which are held together', () => {
    const asking = after(opened(resting()), fill(2));
    const action = filledMessage(asking.session.opening?.run ?? 0);
    if (action.type !== 'answered' || action.message.type !== 'opened') throw new Error('not opened');
    const all = [...Array(24).keys()].map((face) => face + 1);
    const groups = [
      { name: 'plate', faces: all },
      { name: 'fill-2-rim', faces: [22, 24] },
      { name: 'fill-2', faces: [25, 26] },
    ];
    const cage = { ...action.message.cage, faces: 26 };
    const filled = reduce(asking, answered({ ...action.message, cage, groups }));
    expect(filled.document.cage?.groups).toEqual([plate]);
    expect(held(filled)).toBe('1'.repeat(21) + '01000');
    const painted = after(filled, { type: 'facesPainted', faces: [21], held: true });
    expect(constraints(painted)).toEqual({ hold: { groups: ['plate', 'fill-2-rim'] } });
    const erased = after(painted, { type: 'facesPainted', faces: [1], held: false });
    expect(constraints(erased)).toEqual({ hold: { groups: ['fill-2-rim'], faces: [2, 3, 4, 5, 6] } });
    expect(held(erased).slice(0, 8)).toBe('00001111');
  });
});

describe('what the core refuses', () => {
  /** @param {State} state @param {string} message */
  const refuse = (state, message) =>
    reduce(state, answered({ type: 'failed', run: state.session.opening?.run ?? 0, kind: 'input', message }));
  const curvature =
    'a.obj: constraints.boundary: the cage says nothing of the curvature across its boundary at vertex 9: hold the faces';

  test('of a condition is said at its boundary, and keeps Start from asking again until something is changed', () => {
    const asking = after(opened(resting()), hold(2, 'free'), hold(3, 'curvature'));
    const refused = refuse(asking, curvature);
    expect(refused.view.alert).toBeNull();
    expect(refused.session.refused).toMatchObject({ place: 'boundary', boundary: 3 });
    expect(refused.session.refused?.message).toMatch(/^The cage says nothing of .* hold the faces\.$/);
    expect(conditionAt(constraints(refused), 3)).toBe('curvature');
    expect(runButtons(refused).primary.enabled).toBe(false);
    expect(statusSentence(refused)).toMatch(/^Cannot start/);
    expect(reduce(refused, { type: 'startPressed' })).toBe(refused);
    const mended = after(refused, hold(3, 'position'));
    expect(leaves(mended)).toMatchObject({ refused: null, opening: { purpose: 'preview' } });
    expect(runButtons(mended).primary.enabled).toBe(true);
  });

  test('of a fill is said at its boundary, which stays open', () => {
    const refused = refuse(after(opened(resting()), fill(2)), 'a.obj: fill: boundary 2 is too long.');
    expect(refused.session.refused).toEqual({ place: 'fill', boundary: 2, message: 'Boundary 2 is too long.' });
    expect(refused.document.settings.fill).toBeNull();
    expect(runButtons(refused).primary.enabled).toBe(true);
    const nameless = refuse(after(opened(resting()), fill(3)), 'fill: every face touches a filled boundary');
    expect(nameless.session.refused).toMatchObject({ boundary: 3 });
    expect(refuse(after(opened(resting()), fill(null)), 'fill: every face').session.refused).toMatchObject({
      boundary: null,
    });
  });

  test('of anything else is a notice', () => {
    const refused = refuse(after(opened(resting()), hold(2, 'free')), 'a.obj: constraints.pins[0]: no');
    expect(leaves(refused)).toMatchObject({ refused: null, alert: { message: 'a.obj: constraints.pins[0]: no' } });
  });
});

describe('the closeness', () => {
  /** @param {import('../../../web/pages/studio/state/types.js').Closeness | null} closeness @returns {Action} */
  const stay = (closeness) => ({ type: 'closenessChanged', closeness });

  test('is a distance or a weight of the problem, or nothing', () => {
    const within = after(opened(resting()), stay({ within: 0.2 }));
    expect(constraints(within)).toEqual({ closeness: { within: 0.2 } });
    expect(within.session.opening).toMatchObject({ purpose: 'preview' });
    const weight = after(within, stay({ weight: 0 }));
    expect(constraints(weight)).toEqual({ closeness: { weight: 0 } });
    expect(constraints(after(weight, stay(null)))).toEqual({});
  });

  test.each([{ within: 0 }, { within: NaN }, { within: Infinity }, { weight: -1 }, { weight: NaN }])(
    '%p is none, which is said, not asked of the core, and not started',
    (closeness) => {
      const wrong = after(opened(resting()), stay(closeness));
      expect(problemOfCloseness(constraints(wrong))).toMatch(/is a number/);
      expect(wrong.session.opening).toBeNull();
      expect(runButtons(wrong).primary.enabled).toBe(false);
    },
  );
});

describe('the boundary of a mesh', () => {
  test('is its loops of edges with one triangle, in the order of their smallest vertices', () => {
    // A square ring of 8 triangles with the corners 0 to 3 around the hole and 4 to 7 outside, and a triangle by itself.
    const ring = [0, 1, 2, 3].flatMap((i) => {
      const next = (i + 1) % 4;
      return [4 + i, 4 + next, next, 4 + i, next, i];
    });
    const loops = boundaryLoops({ triangles: Uint32Array.from([10, 9, 8, ...ring]) });
    expect(loops.map((loop) => loop.toSorted((a, b) => a - b))).toEqual([
      [0, 1, 2, 3],
      [4, 5, 6, 7],
      [8, 9, 10],
    ]);
    const outside = loops[1];
    expect(outside[(outside.indexOf(5) + 1) % 4]).toBe(6); // along the loop
    expect(boundaryLoops({ triangles: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2) })).toEqual([]);
  });
});
