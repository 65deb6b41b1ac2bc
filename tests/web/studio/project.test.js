// SPDX-License-Identifier: MIT
/**
 * @file What is kept of a document: taken apart and put together, as a project's file, and brought back on the real core.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../../wasm/umbilic.js';
import { createPacking } from '../../../web/pages/studio/packing.js';
import { formatProject, isProject, parseProject } from '../../../web/pages/studio/project.js';
import { undoName } from '../../../web/pages/studio/state/history.js';
import { isUntouched, keptFrom, stateFrom } from '../../../web/pages/studio/state/kept.js';
import { initialState } from '../../../web/pages/studio/state/reduce.js';
import { fish } from '../../browser/fish.js';
import { bytes, copied, createStudio } from './real.js';
import { leaves, running } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/kept.js').Kept} Kept */

beforeAll(() => load());

/** The fish with its body held, after a run, with a history. */
function minimizedFish() {
  const studio = createStudio('?shape=cube');
  studio.do(
    { type: 'settingsChanged', change: { functional: 'bending', levels: [0, 0] } },
    { type: 'startPressed' },
    { type: 'fileChosen', name: 'fish.obj', text: new TextEncoder().encode(fish()) },
    { type: 'groupHeld', name: 'body', held: true },
    { type: 'startPressed' },
    { type: 'settingsChanged', change: { origin: 'surface' } },
  );
  expect(studio.state.session.phase.name).toBe('ended');
  return studio;
}

/** @param {Kept} kept */
function reopened(kept) {
  const begun = stateFrom(initialState(), kept);
  const studio = createStudio('', begun);
  studio.do({ type: 'wakened' });
  return studio;
}

/** The energies by the core. @param {ReturnType<typeof createStudio>} studio @returns {Record<string, number>} */
function energiesOf(studio) {
  studio.do({ type: 'downloadPressed', what: 'report' });
  return JSON.parse(studio.files.at(-1)?.text ?? '').energies;
}

describe('what is kept', () => {
  test('is whole again after it was taken apart, and only what is new has to be written', () => {
    const studio = minimizedFish();
    const packing = createPacking('a');
    const kept = keptFrom(studio.state);
    const first = packing.pack(kept);
    const texts = [...first.parts.values()].filter((part) => 'text' in part);
    expect(texts).toHaveLength(1); // of all steps of the history together
    const stored = copied(first);
    const back = createPacking('b').unpack(stored.packed, stored.parts);
    expect(back).toEqual(kept);
    expect(bytes(back.document.result)).toBe(bytes(kept.document.result));
    expect(isUntouched(kept)).toBe(false);

    studio.do({ type: 'vertexPinned', vertex: 1 });
    const second = packing.pack(keptFrom(studio.state));
    expect([...second.parts.keys()].filter((key) => !first.parts.has(key))).toEqual([second.packed.past.at(-1)]);
  });

  test('of a run goes on with it: its evaluations are counted on, and its energy falls', () => {
    const studio = createStudio();
    studio.do();
    studio.dispatch({ type: 'startPressed' });
    studio.work(60);
    const kept = copied(keptFrom(studio.state));
    const { saved, samples } = kept.document.result;
    const evaluations = saved?.evaluations ?? 0;
    expect(evaluations).toBeGreaterThan(3);
    const back = reopened(kept);
    const { result } = back.state.document;
    expect(result.stop).toBe('converged');
    expect(result.samples.slice(0, evaluations)).toEqual(samples.slice(0, evaluations));
    expect(result.samples.map(({ evaluation }) => evaluation)).toEqual(result.samples.map((_, i) => i + 1));
    expect(result.first).toEqual(kept.document.result.first);
  });

  test('of a state that has not been opened in another page is nothing that was done', () => {
    const studio = createStudio('?shape=cube');
    studio.do({ type: 'viewChanged', change: { cage: true } });
    expect(isUntouched(studio.state)).toBe(true);
    expect(isUntouched(running())).toBe(false);
  });
});

describe('the file of a project', () => {
  test('brings back cage, settings, surface, energies to 1e-12, and history', () => {
    const studio = minimizedFish();
    const text = formatProject(keptFrom(studio.state), 'fish.obj');
    expect(isProject(new TextEncoder().encode(text))).toBe(true);
    const { kept, name } = parseProject(text);
    expect(name).toBe('fish.obj');
    const back = reopened(kept);
    expect(bytes(leaves(back.state).saved)).toBe(bytes(leaves(studio.state).saved));
    expect(back.state.document.settings).toEqual(studio.state.document.settings);
    const [before, after] = [energiesOf(studio), energiesOf(back)];
    for (const key of ['bending', 'mvs_cross', 'area'])
      expect(Math.abs(after[key] / before[key] - 1)).toBeLessThan(1e-12);
    while (undoName(studio.state)) {
      expect(undoName(back.state)).toBe(undoName(studio.state));
      studio.do({ type: 'undoPressed' });
      back.do({ type: 'undoPressed' });
      expect(back.state.document.settings).toEqual(studio.state.document.settings);
    }
    expect(leaves(back.state)).toMatchObject({ cage: { name: 'cube' }, status: 'resting' });
  });

  test('has the problem of its surface in the form that the core reads', () => {
    const studio = minimizedFish();
    const { problem } = JSON.parse(formatProject(keptFrom(studio.state), 'fish.obj'));
    const minimizer = new Minimizer(JSON.stringify(problem));
    const energy = studio.state.document.result.latest?.energies.bending ?? NaN;
    expect(minimizer.energies.bending / energy).toBeCloseTo(1, 12);
    minimizer.dispose();
  });

  test('of a run that goes on is that of one that is paused', () => {
    const { kept } = parseProject(formatProject(keptFrom(running()), 'two-3'));
    expect(kept.phase).toBe('paused');
    expect(kept.document.result.latest?.energies.second_form_variation).toBeNaN();
  });

  test.each([
    ['{"umbilic": "project", "version": 1, ', /^It is not whole: /],
    ['{"umbilic": "project", "version": 9}', /^It is of version 9; this page reads 1\.$/],
    ['{"umbilic": "project", "version": 1}', /^Parts of it are missing\.$/],
  ])('%s is refused with a sentence', (text, message) => {
    expect(isProject(new TextEncoder().encode(text))).toBe(true);
    expect(() => parseProject(text)).toThrow(message);
  });
});
