// SPDX-License-Identifier: MIT
/**
 * @file The catalog's state: what orders and filters show, what can be chosen, and what is told of downloads.
 */
import { describe, expect, test } from '@jest/globals';
import { parseCatalogAddress } from '../../../web/address/catalog.js';
import { initialState, reduce } from '../../../web/pages/catalog/reduce.js';
import { allRows, filterValues, findEntry, visibleRows } from '../../../web/pages/catalog/select.js';
import { catalog, catalogWithHole } from './small.js';

/** @import {Action, Filter, State} from '../../../web/pages/catalog/types.js' */

/** @param {...Action} actions @returns {State} */
const after = (...actions) => actions.reduce(reduce, { ...initialState(parseCatalogAddress(''), 'system'), catalog });
/** @param {State} state */
const names = (state) => visibleRows(state).map(({ shape }) => shape.name);
/** @param {string} key @returns {Action} */
const sort = (key) => ({ type: 'sortPressed', key });
/** @param {Partial<Filter>} change @returns {Action} */
const filter = (change) => ({ type: 'filterChanged', change });

describe('rows', () => {
  test('are those of the catalog, with an entry or none for each column', () => {
    const rows = allRows(catalog);
    expect(rows.map(({ shape }) => shape.name)).toEqual(catalog.shapes.map(({ name }) => name));
    expect(rows[0].entries.map((entry) => entry?.energy)).toEqual([112.76693, 263.41, undefined]);
  });

  test('come in the catalog’s order, which a press turns around and another restores', () => {
    expect(names(after())).toEqual(['two-3', 'tetrahedron-frame', 'octahedron-frame', 'torus']);
    expect(names(after(sort('shape')))).toEqual(['torus', 'octahedron-frame', 'tetrahedron-frame', 'two-3']);
    expect(names(after(sort('shape'), sort('shape')))).toEqual(names(after()));
  });

  test('are ordered by genus and by energy, and by the new key upwards first', () => {
    expect(names(after(sort('genus')))).toEqual(['torus', 'two-3', 'tetrahedron-frame', 'octahedron-frame']);
    expect(names(after(sort('genus'), sort('bending')))).toEqual(names(after(sort('genus'))));
    expect(names(after(sort('bending'), sort('bending')))).toEqual([
      'octahedron-frame',
      'tetrahedron-frame',
      'two-3',
      'torus',
    ]);
  });

  test('without an energy come last in either direction', () => {
    expect(names(after(sort('mvs')))).toEqual(['torus', 'octahedron-frame', 'two-3', 'tetrahedron-frame']);
    expect(names(after(sort('mvs'), sort('mvs')))).toEqual(['two-3', 'octahedron-frame', 'torus', 'tetrahedron-frame']);
  });

  test.each(
    /** @type {Array<[Partial<Filter>, string[]]>} */ ([
      [{ genus: 3 }, ['tetrahedron-frame']],
      [{ arms: 3 }, ['two-3', 'tetrahedron-frame']],
      [{ group: 'Oh' }, ['octahedron-frame']],
      [{ status: 'upper_bound' }, ['two-3', 'octahedron-frame']],
      [{ search: 'FRAME' }, ['tetrahedron-frame', 'octahedron-frame']],
      [{ search: 'junctions arms' }, ['two-3']],
      [{ search: 'genus 7' }, ['octahedron-frame']],
      [{ arms: 3, status: 'none_found' }, ['tetrahedron-frame']],
      [{ genus: 4 }, []],
    ]),
  )('that pass %j are %j', (change, expected) => expect(names(after(filter(change)))).toEqual(expected));

  test('of a hole are found by its words and by its genus, and have no arms to filter by', () => {
    const state = { ...after(), catalog: catalogWithHole };
    /** @param {Partial<Filter>} change */
    const passing = (change) => names(reduce(state, filter(change)));
    for (const search of ['hole', '5-sided', 'open curvature held']) expect(passing({ search })).toEqual(['hole-5']);
    expect(passing({ genus: 0 })).toEqual(['hole-5']);
    expect(passing({ group: 'C5v' })).toEqual(['hole-5']);
    expect(names(state).at(-1)).toBe('hole-5');
    expect(filterValues(catalogWithHole).arms).toEqual(filterValues(catalog).arms);
  });

  test('are all back when the filter is cleared, in the order that was chosen', () => {
    const state = after(sort('genus'), filter({ genus: 3 }), filter({ search: 'x' }), { type: 'filterCleared' });
    expect(names(state)).toEqual(names(after(sort('genus'))));
  });

  test('can be filtered by what there is', () => {
    expect(filterValues(catalog)).toEqual({ genus: [1, 2, 3, 7], arms: [3, 4], group: ['D3h', 'D6h', 'Oh', 'Td'] });
  });
});

describe('entries', () => {
  test('are found by shape and functional', () => {
    expect(findEntry(catalog, 'torus.mvs')?.entry.status).toBe('zero_attained');
    expect(findEntry(catalog, 'torus.mvs')?.shape.genus).toBe(1);
    for (const id of ['torus', 'torus.willmore', '']) expect(findEntry(catalog, id)).toBeNull();
    expect(findEntry(null, 'torus.mvs')).toBeNull();
  });

  test('are chosen in the order of the presses, four at most, each once', () => {
    /** @param {string} entry @returns {Action} */
    const choose = (entry) => ({ type: 'entryChosen', entry, chosen: true });
    expect(after(choose('a'), choose('b'), choose('a')).chosen).toEqual(['b', 'a']);
    const full = after(...['a', 'b', 'c', 'd', 'e'].map(choose));
    expect(full.chosen).toEqual(['a', 'b', 'c', 'd']);
    const fewer = reduce(full, { type: 'entryChosen', entry: 'b', chosen: false });
    expect(reduce(fewer, choose('e')).chosen).toEqual(['a', 'c', 'd', 'e']);
    expect(reduce(full, { type: 'choiceCleared' }).chosen).toEqual([]);
  });

  test('are opened and closed, and an address that is followed says which', () => {
    const open = after({ type: 'entryOpened', entry: 'torus.mvs' });
    expect(open.address.entry).toBe('torus.mvs');
    expect(reduce(open, { type: 'entryClosed' }).address.entry).toBe('');
    const place = parseCatalogAddress('?sort=genus&genus=many');
    const followed = reduce(open, { type: 'addressFollowed', ...place });
    expect(followed.address).toMatchObject({ sort: 'genus', genus: null, entry: '' });
    expect(followed.notices).toHaveLength(1);
  });

  test('are downloaded one at a time, and a failure is told until the next', () => {
    /** @type {Action} */
    const press = { type: 'downloadPressed', entry: 'torus.mvs', what: 'stl' };
    const busy = after(press);
    expect(busy.exporting).toEqual({ entry: 'torus.mvs', what: 'stl' });
    expect(reduce(busy, { ...press, what: 'glb' })).toBe(busy);
    expect(reduce(busy, { type: 'exported' }).exporting).toBeNull();
    const failed = reduce(busy, { type: 'exportFailed', message: 'no memory' });
    expect(failed).toMatchObject({ exporting: null, exportProblem: 'no memory' });
    expect(reduce(failed, press).exportProblem).toBe('');
  });
});
