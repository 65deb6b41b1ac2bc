// SPDX-License-Identifier: MIT
/**
 * @file Search and menus that filter the rows, the number of rows shown, and the download of the whole table.
 */
import { statuses } from '../../../address/catalog.js';
import { counted } from '../../../words/numbers.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { filterValues, visibleRows } from '../select.js';
import { capitalized, statusWords } from '../../../words/entries.js';

/** @import {Catalog} from '../../../files/catalog.js' */
/** @import {Action, Filter, State} from '../types.js' */

/** @param {string} all @param {Array<[value: string, text: string]>} values */
function options(all, values) {
  const every = element('option', { value: '' }, all);
  return [every, ...values.map(([value, text]) => element('option', { value }, text))];
}

/** The change of the filter that a menu's value stands for. @param {string} name @param {string} value @returns {Partial<Filter>} */
function changeOf(name, value) {
  if (name === 'genus' || name === 'arms') return { [name]: value === '' ? null : Number(value) };
  return { [name]: value };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createFiltersView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const search = /** @type {HTMLInputElement} */ (find(root, '[name=search]'));
  const clear = find(root, '[name=clear]');
  const count = find(root, '[role=status]');
  const menus = /** @type {const} */ (['genus', 'arms', 'group', 'status']).map((name) => ({
    name,
    menu: /** @type {HTMLSelectElement} */ (find(root, `[name=${name}]`)),
  }));
  root.addEventListener('submit', (event) => event.preventDefault(), { signal });
  search.addEventListener('input', () => dispatch({ type: 'filterChanged', change: { search: search.value } }), {
    signal,
  });
  for (const { name, menu } of menus) {
    menu.addEventListener('change', () => dispatch({ type: 'filterChanged', change: changeOf(name, menu.value) }), {
      signal,
    });
  }
  clear.addEventListener('click', () => dispatch({ type: 'filterCleared' }), { signal });
  find(root, '[name=csv]').addEventListener('click', () => dispatch({ type: 'tablePressed' }), { signal });

  const fill = whenChanged((/** @type {Catalog} */ catalog) => {
    const values = filterValues(catalog);
    const present = new Set(catalog.entries.map(({ status }) => status));
    const [genus, arms, group, status] = menus.map(({ menu }) => menu);
    genus.replaceChildren(
      ...options(
        'Any genus',
        values.genus.map((value) => [String(value), `Genus ${value}`]),
      ),
    );
    arms.replaceChildren(
      ...options(
        'Any arms',
        values.arms.map((value) => [String(value), counted(value, 'arm')]),
      ),
    );
    group.replaceChildren(
      ...options(
        'Any symmetry',
        values.group.map((value) => [value, value]),
      ),
    );
    status.replaceChildren(
      ...options(
        'Any status',
        statuses.filter((one) => present.has(one)).map((one) => [one, capitalized(statusWords[one].name)]),
      ),
    );
  });

  return {
    /** @param {State} state */
    update(state) {
      if (!state.catalog) return;
      fill(state.catalog);
      const { address } = state;
      if (search.value !== address.search) search.value = address.search;
      for (const { name, menu } of menus) menu.value = String(address[name] ?? '');
      const shown = visibleRows(state).length;
      const all = state.catalog.shapes.length;
      setText(count, shown === all ? counted(all, 'shape') : `${shown} of ${counted(all, 'shape')}`);
      clear.hidden = shown === all && address.search === '' && menus.every(({ menu }) => menu.value === '');
    },
    dispose: () => listening.abort(),
  };
}
