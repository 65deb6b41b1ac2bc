// SPDX-License-Identifier: MIT
/**
 * @file The entry point of the catalog, which is also the home page: its state, its reducer and the views that show it.
 * Code that draws or computes is loaded only when a download needs it.
 */
import { parseCatalogAddress } from './address/catalog.js';
import { loadCatalog, loadReport } from './files/catalog.js';
import { saveFile } from './files/save.js';
import { storeTheme, storedTheme } from './files/theme.js';
import { createEffects } from './pages/catalog/effects.js';
import { initialState, reduce } from './pages/catalog/reduce.js';
import { createChoiceView } from './pages/catalog/views/choice.js';
import { createDetailsView } from './pages/catalog/views/details.js';
import { createFiltersView } from './pages/catalog/views/filters.js';
import { createReadingView } from './pages/catalog/views/reading.js';
import { createTableView } from './pages/catalog/views/table.js';
import { find } from './views/dom.js';
import { createGlossaryView } from './views/glossary.js';
import { createKeyListView } from './views/key_list.js';
import { createNoticesView } from './views/page_notices.js';
import { createThemeView } from './views/theme.js';
import { keyGroups } from './words/keys.js';
import { createRequests } from './worker/requests.js';

/** @import {Action} from './pages/catalog/types.js' */

const effects = createEffects({
  dispatch: (action) => dispatch(action),
  makeSurface: createRequests(() => new Worker(new URL('./worker/surfaces.js', import.meta.url), { type: 'module' })),
  loadReport,
  save: saveFile,
  setAddress(search, how) {
    const address = location.pathname + search;
    if (how === 'push') history.pushState(null, '', address);
    else history.replaceState(null, '', address);
  },
});
let state = initialState(parseCatalogAddress(location.search), storedTheme());

/** @param {Action} action */
function dispatch(action) {
  const before = state;
  state = reduce(before, action);
  effects(action, before, state);
  if (state.theme !== before.theme) storeTheme(state.theme);
  show();
}

/** @param {string} id */
const byId = (id) => find(document, `#${id}`);
createGlossaryView(find(document, '.top'));
createKeyListView(find(document, '.top'), keyGroups.catalog);
const theme = createThemeView(find(document, '#theme'), (chosen) => dispatch({ type: 'themeChosen', theme: chosen }));
const views = [
  createNoticesView(byId('notices'), () => dispatch({ type: 'noticesDismissed' })),
  createFiltersView(byId('filters'), dispatch),
  createTableView(byId('table'), dispatch),
  createChoiceView(byId('choice'), dispatch),
  createDetailsView(find(document, '#details'), dispatch),
  createReadingView(byId('reading')),
];

function show() {
  theme.update(state.theme);
  for (const view of views) view.update(state);
}

addEventListener('popstate', () => dispatch({ type: 'addressFollowed', ...parseCatalogAddress(location.search) }));
show();
loadCatalog().then(
  (catalog) => dispatch({ type: 'catalogLoaded', catalog }),
  (error) => dispatch({ type: 'catalogFailed', message: `The catalog was not loaded: ${error.message}` }),
);
