// SPDX-License-Identifier: MIT
/**
 * @file The comparison's state: entries that are chosen, added and removed, surfaces that come and go, and the address of it all.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { describe, expect, test } from '@jest/globals';
import { entryName, parseCompareAddress } from '../../../web/address/compare.js';
import { createEffects } from '../../../web/pages/compare/effects.js';
import { functionalsOf, initialState, reduce } from '../../../web/pages/compare/reduce.js';
import { catalogWithHole } from '../catalog/small.js';
import { catalog, report } from '../catalog.js';

/** @typedef {import('../../../web/pages/compare/types.js').Action} Action */
/** @typedef {import('../../../web/pages/compare/types.js').State} State */

/** A tetrahedron. */
function mesh() {
  return {
    centre: new Float64Array(3),
    positions: Float32Array.from([0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2]),
    normals: new Float32Array(12),
    curvatures: new Float32Array(8).fill(1),
    triangles: Uint32Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
    faces: new Uint32Array(0),
    edges: new Uint32Array(),
    spread: new Float32Array(),
  };
}

/** @param {string} search */
const opened = (search) => initialState('system', parseCompareAddress(search));
/** @param {State} state @param {...Action} actions */
const after = (state, ...actions) => actions.reduce(reduce, state);
/** @param {State} state */
const names = ({ entries }) => entries.map(entryName);
/** @type {Action} */
const loaded = { type: 'catalogLoaded', catalog: catalog() };

describe('entries', () => {
  test('are those of the address, two at least and four at most', () => {
    let state = opened('?entries=two-3.bending,two-3.mvs');
    expect(names(after(state, { type: 'entryRemoved', index: 0 }))).toEqual(['two-3.bending', 'two-3.mvs']);
    state = after(state, loaded, { type: 'entryAdded' });
    expect(names(state)).toEqual(['two-3.bending', 'two-3.mvs', 'two-3.bending_mvs_cross']); // the next that is not there
    state = after(state, { type: 'entryAdded' }, { type: 'entryAdded' });
    expect(state.entries).toHaveLength(4);
    expect(names(after(state, { type: 'entryRemoved', index: 1 }))).not.toContain('two-3.mvs');
  });

  test('are changed one by one; surfaces that none of them shows are let go', () => {
    const state = after(
      opened('?entries=two-3.bending,sphere.bending'),
      loaded,
      { type: 'surfaceLoaded', name: 'two-3.bending', surface: mesh() },
      { type: 'surfaceLoaded', name: 'sphere.bending', surface: mesh() },
      { type: 'surfaceLoaded', name: 'torus.bending', surface: mesh() },
    );
    expect(Object.keys(state.surfaces)).toEqual(['two-3.bending', 'sphere.bending']);
    const changed = after(state, { type: 'entryChosen', index: 1, change: { shape: 'two-3' } });
    expect(names(changed)).toEqual(['two-3.bending', 'two-3.bending']);
    expect(Object.keys(changed.surfaces)).toEqual(['two-3.bending']);
  });

  test('of a shape that has one functional are chosen and added under that, then another shape under it', () => {
    const open = after(opened('?entries=two-3.bending,two-3.mvs'), { type: 'catalogLoaded', catalog: catalogWithHole });
    const chosen = after(open, { type: 'entryChosen', index: 0, change: { shape: 'hole-5' } });
    expect(names(chosen)[0]).toBe('hole-5.mvs');
    expect(functionalsOf(catalogWithHole, 'hole-5').map(({ name }) => name)).toEqual(['mvs']);
    const last = after(open, { type: 'entryChosen', index: 1, change: { shape: 'hole-5' } }, { type: 'entryAdded' });
    expect(names(last)).toEqual(['two-3.bending', 'hole-5.mvs', 'two-3.mvs']);
  });

  test('that an address does not name are the first ones, with a notice until it is dismissed', () => {
    const state = opened('?entries=two-3');
    expect(names(state)).toEqual(['two-3.bending', 'two-3.mvs', 'two-3.mvs_cross']);
    expect(state.notices).toHaveLength(1);
    expect(after(state, { type: 'noticesDismissed' }).notices).toEqual([]);
  });
});

describe('effects', () => {
  /** A page without a browser. @param {string} search */
  function page(search) {
    let state = opened(search);
    /** @type {any[]} */
    const asked = [];
    /** @type {string[]} */
    const addresses = [];
    const effects = createEffects({
      dispatch,
      loadReport: async (name) => {
        if (name.startsWith('sphere')) throw new Error('the file is gone');
        return report();
      },
      makeSurface: async (question) => {
        asked.push(question);
        return mesh();
      },
      setAddress: (address) => addresses.push(address),
    });
    /** @param {Action} action */
    function dispatch(action) {
      state = reduce(state, action);
      effects(state);
    }
    effects(state);
    return {
      asked,
      addresses,
      dispatch,
      now: () => state,
      settled: () => sleep(5),
    };
  }

  test('load each surface once, with its share of the quads, as large as the unit sphere', async () => {
    const { asked, dispatch, now, settled } = page('?entries=two-3.bending,two-3.bending_mvs_cross');
    expect(asked).toEqual([]);
    dispatch(loaded);
    dispatch({ type: 'fitPressed' });
    await settled();
    expect(asked).toHaveLength(2);
    expect(asked[0]).toMatchObject({ what: 'mesh', report: report(), quads: 80_000 });
    const shown = now().surfaces['two-3.bending'];
    expect(shown).toHaveProperty('positions');
    dispatch({ type: 'entryChosen', index: 1, change: { functional: 'bending' } });
    await settled();
    expect(asked).toHaveLength(2);
  });

  test('say why there is no surface', async () => {
    const { dispatch, now, settled } = page('?entries=two-3.mvs,sphere.bending,two-9.bending');
    dispatch(loaded);
    await settled();
    expect(now().surfaces).toEqual({
      'two-3.mvs': { problem: 'All collapsed.' },
      'sphere.bending': { problem: 'the file is gone' },
      'two-9.bending': { problem: 'The catalog has no such entry.' },
    });
  });

  test('let the address follow entries, shading and camera, and nothing else', () => {
    const { addresses, dispatch } = page('?entries=two-3.bending,two-3.mvs');
    dispatch({ type: 'themeChosen', theme: 'dark' });
    dispatch({ type: 'shadingChosen', shading: 'kappa1' });
    dispatch({ type: 'cameraMoved', camera: { azimuth: 5, elevation: -5, distance: 2, target: [0, 0, 0] } });
    dispatch({ type: 'fitPressed' });
    dispatch({ type: 'entryChosen', index: 0, change: { shape: 'two-4' } });
    expect(addresses).toEqual([
      '?entries=two-3.bending,two-3.mvs',
      '?entries=two-3.bending,two-3.mvs&shading=kappa1',
      '?entries=two-3.bending,two-3.mvs&shading=kappa1&camera=5,-5,2',
      '?entries=two-4.bending,two-3.mvs&shading=kappa1&camera=5,-5,2',
    ]);
  });
});
