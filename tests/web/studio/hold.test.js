// SPDX-License-Identifier: MIT
/**
 * @file What the user's choices of held faces and pins make of the state, and what they say of it.
 */
import { describe, expect, test } from '@jest/globals';
import { grown, heldFaces, heldPart } from '../../../web/pages/studio/state/hold.js';
import { withResult, withSettings, withView } from '../../../web/pages/studio/state/parts.js';
import { canStartFromSurface, reduce, startsFromSurface } from '../../../web/pages/studio/state/reduce.js';
import { energyNotes, objectiveValue, runButtons } from '../../../web/pages/studio/state/select.js';
import { defaultSettings, problemOf, settingsFrom } from '../../../web/pages/studio/state/settings.js';
import {
  changeWords,
  closenessWords,
  foundWords,
  freeName,
  freeWords,
  heldWords,
  pinWords,
  pullWords,
  regionWords,
} from '../../../web/words/holding.js';
import { after, answered, ended, energies, leaves, openedMessages, resting, running, withCage } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** Two groups that cover the six faces of a cage but for the last, which is in neither. */
const groups = [
  { name: 'head', faces: [1, 2] },
  { name: 'body', faces: [3, 4, 5] },
];

/** A state whose cage has six faces in two groups. @param {State} state @returns {State} */
const withGroups = (state) =>
  withCage(state, (cage) => ({ ...cage, groups, counts: { ...cage.counts, faces: 6, vertices: 8 } }));

/** @param {number[]} faces @param {boolean} [held] @returns {Action} */
const paint = (faces, held = true) => ({ type: 'facesPainted', faces, held });
/** @type {Action} */
const done = { type: 'paintingEnded' };
/** @param {'all' | 'invert' | 'grow' | 'clear'} how @returns {Action} */
const edit = (how) => ({ type: 'holdEdited', how });
/** @param {State} state */
const held = (state) => [...heldFaces(state.document.settings.constraints, state.document.cage)].join('');
/** @param {State} state */
const constraints = (state) => state.document.settings.constraints;

describe('painting', () => {
  test('holds faces by their numbers from 1, and a whole group by its name', () => {
    const painted = after(withGroups(resting()), paint([0, 5]));
    expect(constraints(painted)).toEqual({ hold: { faces: [1, 6] } });
    const whole = after(painted, paint([1]));
    expect(constraints(whole)).toEqual({ hold: { groups: ['head'], faces: [6] } });
    expect(held(whole)).toBe('110001');
  });

  test('frees a face of a held group, whose other faces stay held', () => {
    const freed = after(withGroups(resting()), { type: 'groupHeld', name: 'body', held: true }, paint([3], false));
    expect(constraints(freed)).toEqual({ hold: { faces: [3, 5] } });
    expect(groups.map((group) => heldPart(group, heldFaces(constraints(freed), freed.document.cage)))).toEqual([
      'none',
      'some',
    ]);
  });

  test('back and forth leaves nothing, not even an empty list', () => {
    const there = withGroups(resting());
    expect(constraints(after(there, paint([2, 4]), paint([4, 2], false)))).toEqual({});
    expect(after(there, paint([2], false))).toBe(there);
    expect(after(there, paint([6, 99]))).toBe(there);
  });

  test('asks the core once, when the stroke has ended', () => {
    const stroke = after(withGroups(resting()), paint([2]), paint([3]));
    expect(stroke.session.opening).toBeNull();
    const over = reduce(stroke, done);
    expect(over.session.opening).toMatchObject({
      purpose: 'preview',
      settings: { constraints: { hold: { faces: [3, 4] } } },
    });
    expect(reduce(over, done).session.opening).toBe(over.session.opening);
  });
});

describe('all faces at once', () => {
  test('are held, freed and exchanged', () => {
    const some = after(withGroups(resting()), { type: 'groupHeld', name: 'head', held: true });
    expect(held(after(some, edit('invert')))).toBe('001111');
    expect(constraints(after(some, edit('invert')))).toEqual({ hold: { groups: ['body'], faces: [6] } });
    expect(constraints(after(some, edit('invert'), edit('invert')))).toEqual(constraints(some));
    expect(constraints(after(some, edit('clear')))).toEqual({});
  });

  test('cannot be held: that says so, is not asked of the core, and nothing starts', () => {
    const all = after(withGroups(resting()), edit('all'));
    expect(held(all)).toBe('111111');
    expect(all.session.opening).toBeNull();
    expect(runButtons(all).primary.enabled).toBe(false);
    expect(reduce(all, { type: 'startPressed' })).toBe(all);
    expect(runButtons(after(all, paint([0], false))).primary.enabled).toBe(true);
  });

  test('grow by those that share a vertex with a held one', () => {
    // A strip of four quads: two triangles over each.
    const triangles = Uint32Array.from(
      [0, 1, 2, 3].flatMap((i) => [2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1]),
    );
    const strip = { positions: new Float32Array(30), triangles, faces: Uint32Array.of(0, 0, 1, 1, 2, 2, 3, 3) };
    expect([...grown(Uint8Array.of(1, 0, 0, 0), strip)]).toEqual([1, 1, 0, 0]);
    expect([...grown(Uint8Array.of(0, 0, 1, 0), strip)]).toEqual([0, 1, 1, 1]);
    expect([...grown(Uint8Array.of(0, 0, 0, 0), strip)]).toEqual([0, 0, 0, 0]);
  });
});

describe('a pin', () => {
  test('is added once and removed from the list', () => {
    const pinned = after(
      withGroups(resting()),
      { type: 'vertexPinned', vertex: 3 },
      { type: 'vertexPinned', vertex: 8 },
    );
    expect(constraints(pinned)).toEqual({ pins: [{ vertex: 3 }, { vertex: 8 }] });
    const again = reduce(pinned, { type: 'vertexPinned', vertex: 3 });
    expect(again).toEqual(withView(pinned, { said: 'Vertex 3 is pinned already.' }));
    expect(after(again, { type: 'vertexPinned', vertex: 4 }).view.said).toBe('');
    const removed = after(pinned, { type: 'pinRemoved', index: 0 });
    expect(constraints(removed)).toEqual({ pins: [{ vertex: 8 }] });
    expect(constraints(after(removed, { type: 'pinRemoved', index: 0 }))).toEqual({});
  });

  test.each([0, 9, 1.5, NaN])('at vertex %p of a cage of eight is none', (vertex) => {
    const there = withGroups(resting());
    expect(constraints(after(there, { type: 'vertexPinned', vertex }))).toEqual({});
  });

  test('stays while faces are painted', () => {
    const both = after(withGroups(resting()), { type: 'vertexPinned', vertex: 3 }, paint([0]), paint([0], false));
    expect(constraints(both)).toEqual({ pins: [{ vertex: 3 }] });
  });
});

describe('what is held', () => {
  const asked = { free: { groups: ['head'] }, pins: [{ face: 2, uv: /** @type {[number, number]} */ ([0.5, 0.25]) }] };

  test('is part of the problem, which is restored from a file as it was', () => {
    const source = /** @type {const} */ ({ kind: 'text', name: 'a.obj', text: '' });
    const settings = settingsFrom(defaultSettings, { terms: { bending: 1 }, constraints: asked });
    expect(problemOf(source, settings, null)).toMatchObject({ constraints: asked });
    expect(problemOf(source, defaultSettings, null)).not.toHaveProperty('constraints');
    expect(settingsFrom(settings, { terms: { bending: 1 } }).constraints).toEqual({});
  });

  test('may be said by what is free; the first change says it by what is held', () => {
    const there = withGroups(resting());
    const state = withSettings(there, { constraints: asked });
    expect(held(state)).toBe('001111');
    expect(constraints(after(state, paint([5], false)))).toEqual({ hold: { groups: ['body'] }, pins: asked.pins });
  });

  test('belongs to its cage: another one begins with nothing held', () => {
    const painted = after(withGroups(resting()), paint([2]));
    const opening = reduce(painted, { type: 'generatorChanged', change: { name: 'cube' } });
    expect(opening.session.opening?.settings.constraints).toEqual({});
    expect(held(opening)).toBe('001000');
    const run = opening.session.opening?.run ?? 0;
    const opened = after(opening, ...openedMessages(run));
    expect(constraints(opened)).toEqual({});
    expect(opened.document.result.settings.constraints).toEqual({});
  });

  test('changes while a run goes on, and applies from the next Start, which begins from the cage', () => {
    const painted = after(withGroups(running()), paint([2]), done);
    expect(leaves(painted)).toMatchObject({ status: 'running', opening: null });
    expect(painted.document.result.settings.constraints).toEqual({});
    const over = after(withGroups(ended()), { type: 'settingsChanged', change: { origin: 'surface' } });
    expect(startsFromSurface(over)).toBe(true);
    const changed = after(over, paint([2]), done);
    expect(canStartFromSurface(changed)).toBe(false);
    const started = reduce(changed, { type: 'startPressed' });
    expect(started.session.opening).toMatchObject({
      purpose: 'start',
      then: 'run',
      start: null,
      settings: { constraints: { hold: { faces: [3] } } },
    });
    expect(startsFromSurface(after(changed, paint([2], false)))).toBe(true);
  });

  test('is kept when the core refuses it, and Start asks again', () => {
    const asking = after(withGroups(resting()), paint([2]), done);
    const run = asking.session.opening?.run ?? 0;
    const refused = reduce(asking, answered({ type: 'failed', run, kind: 'input', message: 'constraints: no' }));
    expect(refused.view.alert?.message).toBe('constraints: no');
    expect(held(refused)).toBe('001000');
    expect(reduce(refused, { type: 'startPressed' }).session.opening).toMatchObject({ purpose: 'start', then: 'run' });
  });

  test('starts with the core’s answer to it, or with a new question if the answer is about something else', () => {
    const asking = after(withGroups(resting()), paint([2]), done);
    expect(reduce(asking, { type: 'startPressed' }).session.opening).toEqual({
      ...asking.session.opening,
      then: 'run',
    });
    const onwards = after(asking, paint([3]), { type: 'startPressed' });
    expect(onwards.session.opening).toMatchObject({
      then: 'run',
      settings: { constraints: { hold: { faces: [3, 4] } } },
    });
  });

  test('survives the loss of the worker, whose surface comes back with what its run held', () => {
    const lost = after(withGroups(ended()), paint([2]), { type: 'workerLost', loss: 'broken', detail: '' });
    expect(held(lost)).toBe('001000');
    expect(lost.session.opening).toMatchObject({ purpose: 'recovery', settings: { constraints: {} } });
  });
});

describe('words', () => {
  test('say how much is held, and when a change applies', () => {
    expect(heldWords(0, 6)).toBe('Nothing is held.');
    expect(heldWords(2, 6)).toBe('2 of 6 faces held');
    expect(changeWords(true, 'running')).toMatch(/next Start/);
    expect(changeWords(true, 'ended')).toMatch(/next Start begins from the cage/);
    expect([changeWords(false, 'ended'), changeWords(true, 'resting')]).toEqual(['', '']);
  });

  test('say where pins are and what they hold', () => {
    expect(pinWords({ vertex: 17 })).toBe('Vertex 17');
    expect(pinWords({ face: 3, uv: [0.5, 0.25] })).toBe('Face 3 at (0.5, 0.25)');
    expect(pinWords({ vertex: 4, at: [0, NaN, 1.5], normal: true })).toBe(
      'Vertex 4 to (0, free, 1.5), with its normal',
    );
    expect(pinWords({ vertex: 4, position: false, normal: [0, 0, 1] })).toBe('Vertex 4, normal only');
  });

  test('say how strongly pins and regions pull, and which region it is', () => {
    const pull = { pull: /** @type {[number, number, number]} */ ([0, -1.5, 2]), strength: 2.5 };
    expect(pullWords(pull).value).toBe('2.500 / length');
    expect(pullWords(pull).direction).toMatch(/\(0, −1.5, 2\)$/);
    const region = { ...pull, faces: 2, first_face: 1 };
    expect(regionWords(region, groups)).toBe('head');
    expect(regionWords({ ...region, faces: 3 }, groups)).toBe('3 faces, from face 1');
    expect(regionWords({ ...region, first_face: 4 }, groups)).toBe('2 faces, from face 4');
  });

  test('say what a closeness is in, and the weight that was found for a distance', () => {
    expect(closenessWords({ within: 1 }, true)).toMatch(/in the file’s units\.$/);
    expect(closenessWords(undefined, false)).toMatch(/in the cage’s units\.$/);
    expect(closenessWords({ weight: 1 }, true)).toMatch(/per length⁴\.$/);
    const report = {
      held_faces: 0,
      free_faces: 6,
      deviation: 0.9,
      closeness: 12,
      regions: [],
      boundaries: [],
      pins: [],
      notes: [],
    };
    expect(foundWords(report, { closeness: { within: 1 } })).toEqual([expect.stringContaining('weight 12.0000')]);
    expect(foundWords(report, { closeness: { weight: 12 } })).toEqual([]);
    expect(foundWords(null, { closeness: { within: 1 } })).toEqual([]);
  });

  test('say over what was minimized, and name the factor of third-order energies', () => {
    const free = { ...energies(40), area: 5.16, area_factor: 11.5 };
    const now = { ...energies(100), area: 12, free };
    expect(freeWords(now, ['bending'])).toEqual([
      'Minimized over the free faces, 43 % of the area; the other rows are the whole surface’s.',
    ]);
    expect(freeWords(now, ['bending', 'mvs_cross'])[1]).toContain('A₀ = 11.5000');
    expect(freeWords(energies(100), ['mvs'])).toEqual([]);
    const open = { ...now, free: { ...free, area: 12 } };
    expect(freeWords(open, ['mvs'])).toEqual([expect.stringMatching(/^A is constant/)]);
    expect([now, open].map(freeName)).toEqual(['over the free faces', 'with the constant area A₀']);
    expect(objectiveValue({ ...defaultSettings, functional: 'bending' }, now)).toBe(40);
    const state = withResult(ended(), { latest: { energies: now, evaluations: 5, level: 2 } });
    expect(energyNotes(state).map(({ words }) => words)).toEqual(freeWords(now, ['mvs_cross']));
  });
});
