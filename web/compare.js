// SPDX-License-Identifier: MIT
/**
 * @file The comparison page's entry point: its state, its reducer and the views that show it.
 */
import { parseCompareAddress } from './address/compare.js';
import { loadCatalog, loadReport } from './files/catalog.js';
import { storeTheme, storedTheme } from './files/theme.js';
import { createEffects } from './pages/compare/effects.js';
import { initialState, reduce } from './pages/compare/reduce.js';
import { createPanesView } from './pages/compare/views/panes.js';
import { createTableView } from './pages/compare/views/table.js';
import { createToolsView } from './pages/compare/views/tools.js';
import { createCopyView } from './views/copy.js';
import { find } from './views/dom.js';
import { createGlossaryView } from './views/glossary.js';
import { createKeyListView } from './views/key_list.js';
import { createLegendView } from './views/legend.js';
import { createNoticesView } from './views/page_notices.js';
import { createThemeView } from './views/theme.js';
import { keyGroups } from './words/keys.js';
import { createRequests } from './worker/requests.js';

/** @import {Action, State} from './pages/compare/types.js' */

/** @type {import('./worker/surfaces.js').MakeSurface} */
const makeSurface = createRequests(
  () => new Worker(new URL('./worker/surfaces.js', import.meta.url), { type: 'module' }),
);
const effects = createEffects({
  dispatch: (action) => dispatch(action),
  loadReport,
  // Without drawing, no surface is needed.
  makeSurface: (question) => (panes.draws ? makeSurface(question) : Promise.resolve('')),
  setAddress: (search) => history.replaceState(null, '', location.pathname + search),
});
let state = initialState(storedTheme(), parseCompareAddress(location.search));

/** @param {Action} action */
function dispatch(action) {
  const before = state;
  state = reduce(before, action);
  effects(state);
  if (state.theme !== before.theme) storeTheme(state.theme);
  show();
}

/** @param {string} id */
const byId = (id) => find(document, `#${id}`);
createGlossaryView(find(document, '.top'));
createKeyListView(find(document, '.top'), keyGroups.compare);
const theme = createThemeView(find(document, '#theme'), (chosen) => dispatch({ type: 'themeChosen', theme: chosen }));
/** Curvatures are in units of that of a sphere with the same area. */
const legend = createLegendView(byId('legend'), {
  choose: (shading) => dispatch({ type: 'shadingChosen', shading }),
  unit: () => '1 on a sphere of equal area',
});
const panes = createPanesView(byId('panes'), dispatch);
const views = [
  createNoticesView(byId('notices'), () => dispatch({ type: 'noticesDismissed' })),
  createToolsView(byId('comparison'), dispatch, panes.draws),
  createTableView(byId('energies')),
];
createCopyView(find(document, '#copy'));

/** @param {State} shown @returns {Float32Array[]} */
function curvatures({ surfaces }) {
  return Object.values(surfaces).flatMap((surface) => ('problem' in surface ? [] : [surface.spread]));
}

function show() {
  theme.update(state.theme);
  panes.update(state, legend.update({ shading: state.shading, curvatures: curvatures(state), occasion: '' }));
  for (const view of views) view.update(state);
}

effects(state);
show();
loadCatalog().then(
  (catalog) => dispatch({ type: 'catalogLoaded', catalog }),
  (error) => dispatch({ type: 'catalogFailed', message: `The catalog was not loaded: ${error.message}` }),
);
