// SPDX-License-Identifier: MIT
/**
 * @file The catalog's addresses: what they say comes back, and what they say amiss is left out.
 */
import { describe, expect, test } from '@jest/globals';
import {
  compareAddress,
  firstPlace,
  formatPlace,
  parsePlace,
  studioAddress,
} from '../../../web/pages/catalog/address.js';

/** @import {Place} from '../../../web/pages/catalog/types.js' */

/** @type {Place[]} */
const places = [
  firstPlace(),
  { ...firstPlace(), sort: { key: 'genus', direction: 'descending' } },
  { ...firstPlace(), sort: { key: 'shape', direction: 'descending' } },
  {
    sort: { key: 'mvs_cross', direction: 'ascending' },
    filter: { genus: 0, arms: 3, group: 'D3h', status: 'upper_bound', search: 'two & “three”' },
    entry: 'two-3.mvs_cross',
  },
];

describe('an address', () => {
  test.each(places)('of a place leads back to it: %j', (place) => {
    expect(parsePlace(formatPlace(place))).toEqual(place);
  });

  test('of the place where the catalog opens is empty', () => expect(formatPlace(firstPlace())).toBe(''));

  test('names what differs from there only', () => {
    const place = { ...firstPlace(), sort: /** @type {const} */ ({ key: 'genus', direction: 'ascending' }) };
    expect(formatPlace(place)).toBe('?sort=genus');
  });

  test.each([
    '?genus=many',
    '?genus=-1',
    '?arms=1e3',
    '?status=fine',
    '?direction=up',
    '?sort=',
    '?what=ever',
    '?entry=',
  ])('%s says nothing that is understood', (query) => expect(parsePlace(query)).toEqual(firstPlace()));

  test('of an entry in the studio, and of several side by side, names them', () => {
    expect(studioAddress('two-3', 'mvs_cross')).toBe('./studio.html?shape=two-3&functional=mvs_cross');
    expect(compareAddress(['two-3.bending', 'torus.mvs'])).toBe('./compare.html?entries=two-3.bending,torus.mvs');
  });
});
