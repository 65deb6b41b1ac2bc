// SPDX-License-Identifier: MIT
/**
 * @file The catalog's place as the query of its address, and the addresses that its entries lead to. What is as it is at first is left out;
 * what an address says amiss is as if it were not there.
 */

/** @import {EntryStatus} from '../../files/catalog.js' */
/** @import {EntryId, Place} from './types.js' */

/** @type {EntryStatus[]} */
export const statuses = ['converged', 'upper_bound', 'zero_attained', 'infimum_not_attained', 'none_found'];

/** @returns {Place} where the catalog opens */
export function firstPlace() {
  return {
    sort: { key: 'shape', direction: 'ascending' },
    filter: { genus: null, arms: null, group: null, status: null, search: '' },
    entry: null,
  };
}

/** @param {string | null} text @returns {number | null} */
function wholeNumber(text) {
  return text !== null && /^\d{1,4}$/.test(text) ? Number(text) : null;
}

/** @param {string} query as of `location.search` @returns {Place} */
export function parsePlace(query) {
  const words = new URLSearchParams(query);
  const place = firstPlace();
  place.sort.key = words.get('sort') || place.sort.key;
  if (words.get('direction') === 'desc') place.sort.direction = 'descending';
  place.filter = {
    genus: wholeNumber(words.get('genus')),
    arms: wholeNumber(words.get('arms')),
    group: words.get('group') || null,
    status: statuses.find((status) => status === words.get('status')) ?? null,
    search: words.get('search') ?? '',
  };
  place.entry = words.get('entry') || null;
  return place;
}

/** @param {Place} place @returns {string} as of `location.search`: empty, or beginning with a question mark */
export function formatPlace({ sort, filter, entry }) {
  const words = new URLSearchParams();
  if (sort.key !== 'shape') words.set('sort', sort.key);
  if (sort.direction === 'descending') words.set('direction', 'desc');
  for (const name of /** @type {const} */ (['genus', 'arms', 'group', 'status', 'search'])) {
    const value = filter[name];
    if (value !== null && value !== '') words.set(name, String(value));
  }
  if (entry) words.set('entry', entry);
  const query = words.toString();
  return query && `?${query}`;
}

/** @param {string} shape @param {string} functional */
export function studioAddress(shape, functional) {
  return `./studio.html?${new URLSearchParams({ shape, functional })}`;
}

/** @param {EntryId[]} entries */
export function compareAddress(entries) {
  return `./compare.html?entries=${entries.map(encodeURIComponent).join(',')}`;
}
