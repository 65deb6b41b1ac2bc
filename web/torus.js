// SPDX-License-Identifier: MIT
/**
 * @file The torus page's entry point: its state, its reducer and the views.
 */
import { parseTorusAddress } from './address/torus.js';
import { storeTheme, storedTheme } from './files/theme.js';
import { createEffects } from './pages/torus/effects.js';
import { initialState, reduce } from './pages/torus/reduce.js';
import { createControlsView } from './pages/torus/views/controls.js';
import { createEnergiesPlotView } from './pages/torus/views/energies_plot.js';
import { createNumbersView } from './pages/torus/views/numbers.js';
import { createRatioPlotView } from './pages/torus/views/ratio_plot.js';
import { createCopyView } from './views/copy.js';
import { find } from './views/dom.js';
import { createGlossaryView } from './views/glossary.js';
import { createKeyListView } from './views/key_list.js';
import { createNoticesView } from './views/page_notices.js';
import { createThemeView } from './views/theme.js';
import { keyGroups } from './words/keys.js';
import { createRequests } from './worker/requests.js';

/** @import {Action} from './pages/torus/types.js' */

/** @type {(question: import('./worker/tori.js').Question) => Promise<any>} */
const ask = createRequests(() => new Worker(new URL('./worker/tori.js', import.meta.url), { type: 'module' }));
const effects = createEffects({
  dispatch: (action) => dispatch(action),
  energiesOf: (ratios) => ask({ ratios }),
  minimizersOf: (weights) => ask({ weights }),
  setAddress: (search) => history.replaceState(null, '', location.pathname + search),
});
let state = initialState(storedTheme(), parseTorusAddress(location.search));

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
createKeyListView(find(document, '.top'), keyGroups.torus);
const theme = createThemeView(find(document, '#theme'), (chosen) => dispatch({ type: 'themeChosen', theme: chosen }));
/** @type {Array<{update: (shown: typeof state) => void}>} */
const views = [
  createNoticesView(byId('notices'), () => dispatch({ type: 'noticesDismissed' })),
  createControlsView(byId('blend'), dispatch),
  createNumbersView(byId('numbers')),
  createEnergiesPlotView(byId('energies-plot'), dispatch),
  createRatioPlotView(byId('ratio-plot')),
];
createCopyView(find(document, '#copy'));

function show() {
  theme.update(state.theme);
  for (const view of views) view.update(state);
}

effects(state);
show();
// The drawing code is the largest part of the page; numbers and plots need not wait for it.
const { createPictureView } = await import('./pages/torus/views/picture.js');
views.push(createPictureView(byId('surface'), dispatch));
show();
