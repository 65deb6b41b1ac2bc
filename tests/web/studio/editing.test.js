// SPDX-License-Identifier: MIT
/**
 * @file Edits of the cage on the real core: another document in the same tab, one step each, what is held follows where it
 * fits.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Cage, load } from '../../../wasm/umbilic.js';
import { formatObj } from '../../../web/cage/obj.js';
import { needsCage, problemOfEditing } from '../../../web/pages/studio/state/editing.js';
import { redoName, undoName } from '../../../web/pages/studio/state/history.js';
import { box, faceAt, pointAt } from '../cage/cages.js';
import { createStudio } from './real.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').CageEdit} CageEdit */

beforeAll(() => load());

const fine = box(3);
const [top, bottom] = [faceAt(fine, [1.5, 1.5, 3]), faceAt(fine, [1.5, 1.5, 0])];
const grouped = {
  ...fine,
  groups: [
    { name: 'cap', faces: [top] },
    { name: 'foot', faces: [bottom] },
  ],
};
/** @type {Action} */
const edits = { type: 'viewChanged', change: { pointer: 'edit' } };
/** @param {number[]} faces @param {number[]} [points] @returns {Action} */
const select = (faces, points = []) => ({ type: 'cageSelected', selection: { points, faces } });
/** @param {CageEdit} edit @returns {Action} */
const edit = (edit) => ({ type: 'cageEdited', edit });

/** A studio with a box whose cage is edited. */
function createBox() {
  const studio = createStudio('?shape=cube');
  const text = new TextEncoder().encode(formatObj(grouped));
  studio.do({ type: 'fileChosen', name: 'box.obj', text }, edits);
  return studio;
}

/** @param {ReturnType<typeof createStudio>} studio */
const opened = ({ state }) => state.document.cage;

describe('an edit', () => {
  test('opens another cage under the old name, as text that the core reads back; undo brings the same source back', () => {
    const studio = createBox();
    const before = opened(studio)?.source;
    studio.do(select([top, bottom]), edit({ kind: 'bridge' }));
    expect(opened(studio)).toMatchObject({ name: 'box.obj', counts: { genus: 1, faces: 56 } });
    expect(undoName(studio.state)).toBe('bridge');
    const source = opened(studio)?.source;
    if (source?.kind !== 'text') throw new Error('not a text');
    expect(new TextDecoder().decode(new TextEncoder().encode(String(source.text)))).toBe(source.text);
    const read = Cage.read(source.text);
    expect(read.obj()).toBe(source.text);
    read.dispose();
    expect(studio.state.view.editing).toMatchObject({ selection: { points: [], faces: [52, 53, 54, 55] } });
    studio.do({ type: 'undoPressed' });
    expect(opened(studio)?.source).toBe(before);
    expect(redoName(studio.state)).toBe('bridge');
    expect(studio.state.view.editing?.cage.faces).toEqual(fine.faces);
    studio.do({ type: 'redoPressed' });
    expect(opened(studio)?.source).toBe(source);
  });

  test('of a generated shape is called after it', () => {
    const studio = createStudio('?shape=two-3');
    studio.do(edits, select([0]), edit({ kind: 'extrude', by: 0.1 }));
    expect(opened(studio)?.name).toBe('Two junctions, 3 arms edited');
    expect(opened(studio)?.source.kind).toBe('text');
    expect(undoName(studio.state)).toBe('extrude faces');
  });

  test('takes along what is held, and says what no longer fits', () => {
    const studio = createBox();
    studio.do(
      { type: 'groupHeld', name: 'cap', held: true },
      { type: 'groupHeld', name: 'foot', held: true },
      { type: 'facesPainted', faces: [0, 53], held: true },
      { type: 'paintingEnded' },
      { type: 'vertexPinned', vertex: 1 },
      { type: 'vertexPinned', vertex: 56 },
    );
    const { constraints } = studio.state.document.settings;
    studio.do(select([], [pointAt(fine, [0, 0, 0])]), edit({ kind: 'move', by: [0.1, 0, 0] }));
    expect(studio.state.document.settings.constraints).toEqual(constraints);
    expect(studio.state.document.result.settings.constraints).toEqual(constraints);
    studio.do(select([0, bottom]), edit({ kind: 'remove' }));
    const now = studio.state.document.settings.constraints;
    expect(now.hold?.groups).toEqual(['cap']);
    expect(now.hold?.faces).toEqual([52]);
    expect(now.pins).toEqual([{ vertex: 1 }, { vertex: 56 }]);
    expect(studio.state.view.editing?.said).toBe('No longer fits: 2 held parts.');
    expect(opened(studio)?.counts.boundaries).toHaveLength(2);
  });

  test('drops the conditions of single boundaries and what fills them, and keeps the common one', () => {
    const studio = createBox();
    studio.do(
      select([top, bottom]),
      edit({ kind: 'remove' }),
      { type: 'conditionChosen', boundary: null, condition: 'free' },
      { type: 'conditionChosen', boundary: 1, condition: 'position' },
      { type: 'fillPressed', boundary: 2, filled: true },
      select([faceAt(fine, [0, 1.5, 1.5])]),
      edit({ kind: 'extrude', by: 0.2 }),
    );
    expect(studio.state.document.settings).toMatchObject({
      fill: null,
      constraints: { boundary: { condition: 'free' } },
    });
    expect(studio.state.view.editing?.said).toBe('No longer fits: 1 boundary condition, 1 fill.');
  });

  test('that is impossible changes nothing and says why', () => {
    const studio = createBox();
    const { document, history } = studio.state;
    for (const kind of /** @type {const} */ (['remove', 'bridge', 'split'])) {
      studio.do(edit({ kind }));
      expect(studio.state.view.editing?.said).toMatch(/^Select /);
    }
    expect(studio.state.document).toBe(document);
    expect(studio.state.history).toBe(history);
  });

  test('waits for what is being opened', () => {
    const studio = createBox();
    studio.do(select([top]));
    studio.dispatch(edit({ kind: 'extrude', by: 1 }));
    studio.dispatch(edit({ kind: 'extrude', by: 1 }));
    expect(studio.state.view.editing?.said).toBe('Another cage or surface is being opened.');
    studio.work();
    expect(opened(studio)?.counts.faces).toBe(58);
  });
});

describe('the mode', () => {
  test('asks for the cage once for each that is open, and only while it is on', () => {
    const studio = createStudio('?shape=cube');
    studio.do();
    expect(needsCage(studio.state)).toBe(false);
    studio.dispatch(edits);
    expect(needsCage(studio.state)).toBe(true);
    studio.work();
    expect(needsCage(studio.state)).toBe(false);
    expect(studio.state.view.editing?.cage.faces).toHaveLength(6);
    studio.do({ type: 'generatorChanged', change: { name: 'two-3' } });
    expect(studio.state.view.editing?.cage.faces.length).toBe(opened(studio)?.counts.faces);
  });

  test('leaves a run alone', () => {
    const studio = createBox();
    studio.do(select([top]));
    studio.dispatch({ type: 'startPressed' });
    studio.work(3);
    expect(problemOfEditing(studio.state)).toBe('A run goes on. Cancel it to edit the cage.');
    const { editing } = studio.state.view;
    studio.dispatch(edit({ kind: 'remove' }));
    expect(studio.state.view.editing).toBe(editing);
    expect(studio.state.session.opening).toBeNull();
    studio.dispatch({ type: 'cancelPressed' });
    studio.work();
    expect(problemOfEditing(studio.state)).toBeNull();
    studio.do(select([top]), edit({ kind: 'remove' }));
    expect(opened(studio)?.counts.faces).toBe(53);
    expect(studio.state.session.phase.name).toBe('resting');
    studio.do({ type: 'undoPressed' });
    expect(studio.state.session.phase.name).toBe('ended');
  });
});
