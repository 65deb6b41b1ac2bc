// SPDX-License-Identifier: MIT
/**
 * @file The studio's entry point: its state, its reducer, the worker and the views.
 */
import { parseStudioAddress } from './address/studio.js';
import { allQuantities, deviation } from './colour/quantities.js';
import { createEffects } from './pages/studio/effects.js';
import { loadEntry } from './pages/studio/load_entry.js';
import { saveFile } from './files/save.js';
import { storeTheme, storedTheme } from './files/theme.js';
import { initialState, reduce } from './pages/studio/state/reduce.js';
import { createBoundariesView } from './pages/studio/views/boundaries.js';
import { createCageView } from './pages/studio/views/cage.js';
import { createCertificateView } from './pages/studio/views/certificate.js';
import { createClosenessView } from './pages/studio/views/closeness.js';
import { createCopyView } from './views/copy.js';
import { find, setText } from './views/dom.js';
import { createDropView, createFileTaker } from './pages/studio/views/drop.js';
import { createEntryView } from './pages/studio/views/entry.js';
import { createHeldKeyView, createHoldView } from './pages/studio/views/hold.js';
import { createLegendView } from './views/legend.js';
import { createLimitView } from './pages/studio/views/limit.js';
import { createAlertView, createDownloadsView } from './pages/studio/views/notices.js';
import { createObjectiveView } from './pages/studio/views/objective.js';
import { createPinsView } from './pages/studio/views/pins.js';
import { createPlotView } from './pages/studio/views/plot.js';
import { createRunView } from './pages/studio/views/run.js';
import { createEnergiesView, createLevelsView } from './pages/studio/views/tables.js';
import { createThemeView } from './views/theme.js';
import { deviationUnit } from './words/holding.js';
import { createClient } from './worker/client.js';

/** @import {Action} from './pages/studio/state/types.js' */

const client = createClient({
  createWorker: () => new Worker(new URL('./worker/worker.js', import.meta.url), { type: 'module' }),
  onMessage: (message) => dispatch({ type: 'answered', message }),
  onLost: (loss, detail) => dispatch({ type: 'workerLost', loss, detail }),
});
const effects = createEffects({
  client,
  save: saveFile,
  load: async (name) => {
    const found = await loadEntry(name);
    dispatch(
      'missing' in found
        ? { type: 'entryMissing', name, message: found.missing }
        : { type: 'entryLoaded', name, ...found },
    );
  },
  setAddress: (search) => history.replaceState(null, '', location.pathname + search),
});
let state = initialState(storedTheme(), parseStudioAddress(location.search));

/** @param {Action} action */
function dispatch(action) {
  const before = state;
  state = reduce(before, action);
  effects(action, before, state);
  if (state.view.theme !== before.view.theme) storeTheme(state.view.theme);
  show();
}

const takeFiles = createFileTaker(dispatch);
/** @param {string} id */
const byId = (id) => find(document, `#${id}`);
const theme = createThemeView(/** @type {HTMLButtonElement} */ (byId('theme')), (chosen) =>
  dispatch({ type: 'viewChanged', change: { theme: chosen } }),
);
const legend = createLegendView(
  byId('legend'),
  (shading) => dispatch({ type: 'viewChanged', change: { shading } }),
  (quantity) =>
    quantity === deviation ? deviationUnit(state.document.cage?.source.kind === 'text') : `in ${quantity.unit}`,
  allQuantities,
);
/** @type {ReturnType<typeof import('./pages/studio/views/surface.js').createSurfaceView> | null} */
let surface = null;
const plain = [
  createEntryView(byId('entry'), dispatch),
  createCageView(byId('cage'), dispatch, takeFiles),
  createHoldView(byId('hold'), dispatch),
  createPinsView(byId('hold'), dispatch),
  createBoundariesView(byId('boundaries'), dispatch),
  createClosenessView(byId('closeness'), dispatch),
  createHeldKeyView(byId('held-key')),
  createObjectiveView(byId('objective'), dispatch),
  createRunView(byId('run'), dispatch),
  createPlotView(byId('plot')),
  createEnergiesView(byId('energies')),
  createLevelsView(byId('levels')),
  createLimitView(byId('limit')),
  createCertificateView(byId('certificate'), dispatch),
  createDownloadsView(byId('downloads'), dispatch),
  createAlertView(byId('alert'), dispatch),
];
createDropView(byId('drop'), takeFiles);
createCopyView(/** @type {HTMLButtonElement} */ (byId('copy')));

function show() {
  const dark = theme.update(state.view.theme);
  // While the surface moves, the range changes rarely; another cage or a surface at rest gets its own range.
  const range = legend.update({
    shading: state.view.shading,
    deviations: state.view.surface?.deviations,
    curvatures: state.view.surface ? [state.view.surface.limit.curvatures] : [],
    occasion: `${state.session.run} ${state.session.phase.name === 'running'}`,
  });
  surface?.update(state, range, dark);
  for (const view of plain) view.update(state);
  setText(byId('version'), state.session.version);
}

effects(null, null, state);
show();
// The drawing code is the largest part of the page; it is loaded while the worker starts.
const { createSurfaceView } = await import('./pages/studio/views/surface.js');
surface = createSurfaceView(byId('surface'), dispatch);
show();
