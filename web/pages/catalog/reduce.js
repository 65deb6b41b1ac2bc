// SPDX-License-Identifier: MIT
/**
 * @file The catalog page's initial state and reducer. Pure; loading and saving are in effects.js.
 */
import { MOST } from '../../address/compare.js';

/** @import {CatalogAddress} from '../../address/catalog.js' */
/** @import {Theme} from '../../files/theme.js' */
/** @import {Action, Filter, State} from './types.js' */

/** @type {Filter} */
export const anyRow = { genus: null, arms: null, group: '', status: '', search: '' };

/** @param {{address: CatalogAddress, notices: string[]}} place @param {Theme} theme @returns {State} */
export function initialState({ address, notices }, theme) {
  return { catalog: null, problem: '', address, notices, chosen: [], exporting: null, exportProblem: '', theme };
}

/** The order after a press on a column's head: ascending at first, then descending. @param {CatalogAddress} address @param {string} key */
function turned({ sort, direction }, key) {
  const downwards = sort === key && direction === 'asc';
  return { sort: key, direction: /** @type {'asc' | 'desc'} */ (downwards ? 'desc' : 'asc') };
}

/** @param {State} state @param {Partial<CatalogAddress>} change @returns {State} */
function move(state, change) {
  return { ...state, address: { ...state.address, ...change } };
}

/** @param {State} state @param {Action} action @returns {State} */
export function reduce(state, action) {
  switch (action.type) {
    case 'catalogLoaded':
      return { ...state, catalog: action.catalog };
    case 'catalogFailed':
      return { ...state, problem: action.message };
    case 'sortPressed':
      return move(state, turned(state.address, action.key));
    case 'filterChanged':
      return move(state, action.change);
    case 'filterCleared':
      return move(state, anyRow);
    case 'addressFollowed':
      return { ...state, address: action.address, notices: action.notices, exportProblem: '' };
    case 'entryOpened':
      return { ...move(state, { entry: action.entry }), exportProblem: '' };
    case 'entryClosed':
      return move(state, { entry: '' });
    case 'entryChosen': {
      const others = state.chosen.filter((entry) => entry !== action.entry);
      if (!action.chosen) return { ...state, chosen: others };
      return others.length < MOST ? { ...state, chosen: [...others, action.entry] } : state;
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
    case 'noticesDismissed':
      return { ...state, notices: [] };
    case 'themeChosen':
      return { ...state, theme: action.theme };
    case 'tablePressed':
      return state;
  }
}
