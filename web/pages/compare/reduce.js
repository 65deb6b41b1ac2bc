// SPDX-License-Identifier: MIT
/**
 * @file The comparison page's initial state and reducer. Pure.
 */
import { FEWEST, MOST, entryName, parseCompareAddress } from '../../address/compare.js';
import { reduceView } from '../view_state.js';

/** @import {CompareAddress, EntryName} from '../../address/compare.js' */
/** @import {Catalog} from '../../files/catalog.js' */
/** @import {Theme} from '../../files/theme.js' */
/** @import {Action, State} from './types.js' */

/**
 * @param {Theme} [theme]
 * @param {{address: CompareAddress, notices: string[]}} [said]
 * @returns {State}
 */
export function initialState(theme = 'system', { address, notices } = parseCompareAddress('')) {
  return { ...address, catalog: null, surfaces: {}, fits: 0, theme, notices };
}

/** The catalog's entry of this name. @param {Catalog | null} catalog @param {EntryName} name */
export function entryOf(catalog, { shape, functional }) {
  return catalog?.entries.find((entry) => entry.shape === shape && entry.functional === functional) ?? null;
}

/** The functionals under which the catalog has this shape, in its order. @param {Catalog} catalog @param {string} shape */
export const functionalsOf = (catalog, shape) =>
  catalog.functionals.filter(({ name }) => entryOf(catalog, { shape, functional: name }));

/**
 * The entry that is added next: the last shape under the first functional that is not shown with it yet, or else, under the
 * last functional, the first shape after it that is not shown yet.
 * @param {State} state
 * @returns {EntryName}
 */
function nextEntry({ catalog, entries }) {
  const last = entries[entries.length - 1];
  if (!catalog) return last;
  const names = catalog.shapes.map(({ name }) => name);
  const place = names.indexOf(last.shape) + 1;
  const others = [...names.slice(place), ...names.slice(0, place)];
  const candidates = [
    ...functionalsOf(catalog, last.shape).map(({ name }) => ({ shape: last.shape, functional: name })),
    ...others.map((shape) => ({ shape, functional: last.functional })),
  ];
  const taken = new Set(entries.map(entryName));
  return candidates.find((name) => entryOf(catalog, name) && !taken.has(entryName(name))) ?? last;
}

/**
 * The entry with a change; of a shape that the catalog does not have under the functional, under its first one.
 * @param {Catalog | null} catalog
 * @param {EntryName} name
 * @returns {EntryName}
 */
function known(catalog, name) {
  if (!catalog || entryOf(catalog, name)) return name;
  const [functional] = functionalsOf(catalog, name.shape);
  return functional ? { ...name, functional: functional.name } : name;
}

/**
 * Changes the entries, and drops surfaces that no entry shows any more.
 * @param {State} state
 * @param {EntryName[]} entries
 * @returns {State}
 */
function withEntries(state, entries) {
  const names = new Set(entries.map(entryName));
  const kept = Object.entries(state.surfaces).filter(([name]) => names.has(name));
  return { ...state, entries, surfaces: Object.fromEntries(kept) };
}

/**
 * @param {State} state
 * @param {Action} action
 * @returns {State}
 */
export function reduce(state, action) {
  const { entries } = state;
  switch (action.type) {
    case 'catalogLoaded':
      return { ...state, catalog: action.catalog };
    case 'catalogFailed':
      return { ...state, notices: [...state.notices, action.message] };
    case 'surfaceLoaded': {
      if (!entries.some((entry) => entryName(entry) === action.name)) return state;
      return { ...state, surfaces: { ...state.surfaces, [action.name]: action.surface } };
    }
    case 'entryChosen':
      return withEntries(
        state,
        entries.map((entry, i) => (i === action.index ? known(state.catalog, { ...entry, ...action.change }) : entry)),
      );
    case 'entryAdded':
      return entries.length < MOST ? withEntries(state, [...entries, nextEntry(state)]) : state;
    case 'entryRemoved':
      return entries.length > FEWEST ? withEntries(state, entries.toSpliced(action.index, 1)) : state;
    default:
      return reduceView(state, action);
  }
}
