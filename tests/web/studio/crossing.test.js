// SPDX-License-Identifier: MIT
/**
 * @file When the worker is asked where the surface crosses itself, and what is said of it.
 */
import { beforeEach, describe, expect, test } from '@jest/globals';
import { createEffects } from '../../../web/pages/studio/effects.js';
import { crossingsKnown } from '../../../web/pages/studio/state/crossing.js';
import { reduce } from '../../../web/pages/studio/state/reduce.js';
import { crossingsWords } from '../../../web/words/crossings.js';
import { answered, energies, mesh, resting, running } from './state.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** @type {any[]} */
let sent;
/** @type {ReturnType<typeof createEffects>} */
let effects;
beforeEach(() => {
  sent = [];
  const nothing = () => {};
  const client = { send: (/** @type {any} */ command) => sent.push(command), abandon: nothing, restart: nothing };
  effects = createEffects({ client, save: nothing, takePicture: nothing, load: nothing, setAddress: nothing });
});

/** @param {State} state @param {...Action} actions @returns {State} */
function run(state, ...actions) {
  return actions.reduce((before, action) => {
    const next = reduce(before, action);
    effects(action, before, next);
    return next;
  }, state);
}

/** @param {Partial<import('../../../web/pages/studio/state/types.js').View>} change @returns {Action} */
const look = (change) => ({ type: 'viewChanged', change });

/** @param {number} places @param {number} [evaluations] */
const found = (places, evaluations = 0) =>
  answered({
    type: 'searched',
    run: 1,
    evaluations,
    crossings: { segments: new Float32Array(6), places, triangles: 12_345 },
  });

/** @param {State} state */
const words = (state) => crossingsWords(crossingsKnown(state));
const searches = () => sent.filter(({ type }) => type === 'search');

describe('the worker searches', () => {
  test('once for a surface at rest, when its crossings are shown or a file for printing is chosen', () => {
    const asked = run(resting(), look({ crossings: true }), look({ printing: true }), look({ isolines: true }));
    expect(searches()).toEqual([{ type: 'search', run: 1 }]);
    expect(words(asked)).toMatch(/^Looking/);
    const known = run(asked, found(2), look({ crossings: false }), look({ crossings: true }));
    expect(searches()).toHaveLength(1);
    expect(words(known)).toBe('The surface crosses itself in 2 places.');
    expect(words(run(asked, found(1)))).toBe('The surface crosses itself in 1 place.');
    expect(words(run(asked, found(0)))).toMatch(/does not cross itself, as far as 12\s345 triangles show/);
  });

  test('again when another surface has come to rest, and takes no answer about the one before', () => {
    const known = run(resting(), look({ crossings: true }), found(2));
    const surface = { patches: 24, limit: mesh(), density: 1, control: mesh() };
    const moved = run(known, answered({ type: 'surfaced', run: 1, evaluations: 7, ...surface }));
    expect(words(moved)).toMatch(/when it rests/);
    const measured = run(
      moved,
      answered({ type: 'measured', run: 1, evaluations: 7, level: 0, energies: energies(150) }),
    );
    expect(searches()).toHaveLength(2);
    expect(words(run(measured, found(2)))).toMatch(/^Looking/);
    expect(words(run(measured, found(3, 7)))).toMatch('3 places');
  });

  test('not while it moves, and not where its energy proves that it is embedded', () => {
    expect(words(run(running(), look({ crossings: true })))).toMatch(/when it rests/);
    const proved = { ...energies(30), embedded: true };
    const state = run(
      resting(),
      answered({ type: 'measured', run: 1, evaluations: 0, level: 0, energies: proved }),
      look({ printing: true }),
    );
    expect(searches()).toEqual([]);
    expect(words(state)).toBe('The surface does not cross itself: embedded, as below 8π.');
    expect(words(resting())).toBe('');
  });
});
