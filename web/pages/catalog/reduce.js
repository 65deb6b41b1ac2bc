// SPDX-License-Identifier: MIT
/**
 * @file The catalog's state at the start, and what the user's actions make of it. Pure; what must be loaded or saved is in effects.js.
 */
import { firstPlace } from './address.js';

/** @import {Theme} from '../../files/theme.js' */
/** @import {Action, Place, Sort, State} from './types.js' */

/** Entries that can be compared. */
export const MOST_CHOSEN = 4;
export const LEAST_CHOSEN = 2;

/** @param {Place} place @param {Theme} theme @returns {State} */
export function initialState(place, theme) {
  return { catalog: null, problem: '', place, chosen: [], exporting: null, exportProblem: '', theme };
}

/** The first press orders upwards, the next one downwards. @param {Sort} sort @param {string} key @returns {Sort} */
function turned(sort, key) {
  const downwards = sort.key === key && sort.direction === 'ascending';
  return { key, direction: downwards ? 'descending' : 'ascending' };
}

/** @param {State} state @param {Partial<Place>} change @returns {State} */
function move(state, change) {
  return { ...state, place: { ...state.place, ...change } };
}

/** @param {State} state @param {Action} action @returns {State} */
export function reduce(state, action) {
  const { place, chosen } = state;
  switch (action.type) {
    case 'catalogLoaded':
      return { ...state, catalog: action.catalog };
    case 'catalogFailed':
      return { ...state, problem: action.message };
    case 'sortPressed':
      return move(state, { sort: turned(place.sort, action.key) });
    case 'filterChanged':
      return move(state, { filter: { ...place.filter, ...action.change } });
    case 'filterCleared':
      return move(state, { filter: firstPlace().filter });
    case 'addressFollowed':
      return { ...state, place: action.place, exportProblem: '' };
    case 'entryOpened':
      return { ...move(state, { entry: action.entry }), exportProblem: '' };
    case 'entryClosed':
      return move(state, { entry: null });
    case 'entryChosen': {
      const others = chosen.filter((entry) => entry !== action.entry);
      if (!action.chosen) return { ...state, chosen: others };
      return others.length < MOST_CHOSEN ? { ...state, chosen: [...others, action.entry] } : state;
    }
    case 'choiceCleared':
      return { ...state, chosen: [] };
    case 'downloadPressed':
      if (state.exporting) return state;
      return { ...state, exporting: { entry: action.entry, what: action.what }, exportProblem: '' };
    case 'exported':
      return { ...state, exporting: null };
    case 'exportFailed':
      return { ...state, exporting: null, exportProblem: action.message };
    case 'themeChosen':
      return { ...state, theme: action.theme };
    case 'tablePressed':
      return state;
  }
}
