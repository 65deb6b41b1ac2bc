// SPDX-License-Identifier: MIT
/**
 * @file The studio's entry point: its documents, where they are kept, and the views that show one of them.
 */
import { parseStudioAddress } from './address/studio.js';
import { allQuantities, computedOf, deviation } from './colour/quantities.js';
import { saveFile } from './files/save.js';
import { storeTheme, storedTheme } from './files/theme.js';
import { isolateNextVisit } from './pages/isolation.js';
import { createDesk } from './pages/studio/desk.js';
import { createKeeper } from './pages/studio/keeper.js';
import { linkOf, problemIn } from './pages/studio/link.js';
import { loadEntry } from './pages/studio/load_entry.js';
import { createOwnership } from './pages/studio/ownership.js';
import { fileName, typeOf } from './pages/studio/names.js';
import { isProject } from './pages/studio/project.js';
import { initialState } from './pages/studio/state/reduce.js';
import { activeWeights } from './pages/studio/state/settings.js';
import { computedValues } from './pages/studio/state/wish.js';
import { createBeforeView } from './pages/studio/views/before.js';
import { createBoundariesView } from './pages/studio/views/boundaries.js';
import { createCageView } from './pages/studio/views/cage.js';
import { createCameraView } from './pages/studio/views/camera.js';
import { createCertificateView } from './pages/studio/views/certificate.js';
import { createClosenessView } from './pages/studio/views/closeness.js';
import { createCrossingsView } from './pages/studio/views/crossings.js';
import { createDocumentsView } from './pages/studio/views/documents.js';
import { createDownloadsView } from './pages/studio/views/downloads.js';
import { createDropView, createFileTaker } from './pages/studio/views/drop.js';
import { createCageEditingView } from './pages/studio/views/cage_editing.js';
import { createEditView } from './pages/studio/views/edit.js';
import { createEntryView } from './pages/studio/views/entry.js';
import { createExamplesView } from './pages/studio/views/examples.js';
import { createHeldKeyView, createHoldView } from './pages/studio/views/hold.js';
import { createInvitation, INVITED } from './pages/studio/views/invitation.js';
import { createLimitView } from './pages/studio/views/limit.js';
import { createAlertView } from './pages/studio/views/notices.js';
import { createObjectiveView } from './pages/studio/views/objective.js';
import { createPasteView } from './pages/studio/views/paste.js';
import { createPinsView } from './pages/studio/views/pins.js';
import { takePicture } from './pages/studio/views/picture.js';
import { createPlotView } from './pages/studio/views/plot.js';
import { createRunView } from './pages/studio/views/run.js';
import { createSectionView } from './pages/studio/views/section.js';
import { createShowView } from './pages/studio/views/show.js';
import { createEnergiesView, createLevelsView } from './pages/studio/views/tables.js';
import { createTriangleView } from './pages/studio/views/triangle.js';
import { createUndrawnView } from './pages/studio/views/undrawn.js';
import { createCopyView } from './views/copy.js';
import { find, setText } from './views/dom.js';
import { createGlossaryView } from './views/glossary.js';
import { createKeyListView } from './views/key_list.js';
import { createLegendView } from './views/legend.js';
import { createMenus } from './views/menu.js';
import { createThemeView } from './views/theme.js';
import { densityUnit } from './words/functionals.js';
import { deviationUnit } from './words/holding.js';
import { keyGroups } from './words/keys.js';
import { createClient } from './worker/client.js';
import { createSpare } from './worker/spare.js';
import { createRequests } from './worker/requests.js';

/** @import {Action, State} from './pages/studio/state/types.js' */

/** Why the browser does not keep the documents; null if it does. @type {string | null} */
let unkept = null;
/** @type {import('./worker/store.js').AskStore} */
const ask = createRequests(() => new Worker(new URL('./worker/store.js', import.meta.url), { type: 'module' }));
const keeper = createKeeper({
  ask,
  told(failure) {
    if (failure === unkept) return;
    unkept = failure;
    show();
  },
});
const createWorker = createSpare(() => new Worker(new URL('./worker/worker.js', import.meta.url), { type: 'module' }));
/** The entry that the address names is loaded while the store is read. @type {ReturnType<typeof loadEntry> | null} */
let early = null;
const { wanted } = initialState('system', parseStudioAddress(location.search)).session;
if (wanted) early = loadEntry(wanted);
const desk = createDesk({
  outside: {
    connect: (hear) => createClient({ createWorker, ...hear }),
    save: saveFile,
    takePicture: savePicture,
    load: async (name) => {
      const loaded = name.shape === wanted?.shape && name.functional === wanted.functional ? early : null;
      early = null;
      const found = await (loaded ?? loadEntry(name));
      return 'missing' in found
        ? { type: 'entryMissing', name, message: found.missing, retry: found.retry }
        : { type: 'entryLoaded', name, ...found };
    },
  },
  keeper,
  ownership: createOwnership(),
  setAddress: (search, id) => history.replaceState({ document: id }, '', location.pathname + search),
  changed: () => show(),
});

/** @param {Action} action */
function dispatch(action) {
  if (action.type === 'viewChanged' && action.change.theme) storeTheme(action.change.theme);
  desk.dispatch(action);
}

/** What the numbers of the legend are. @param {import('./colour/quantities.js').Quantity} quantity */
function unit(quantity) {
  if (quantity === deviation) return deviationUnit(isFile(desk.state));
  if (computedOf(quantity.shading) !== 'energy') return `in ${quantity.unit}`;
  return densityUnit(activeWeights(desk.state.document.settings));
}

/** How the surface on the screen is coloured. @type {Pick<import('./pages/studio/views/picture.js').Seen, 'range' | 'dark'>} */
let seen = { range: null, dark: false };

/**
 * @param {import('./pages/studio/state/types.js').State} state
 * @param {import('./pages/studio/state/types.js').DownloadOptions} options
 * @returns {Promise<Action>}
 */
async function savePicture(state, options) {
  try {
    const { createSurfaceView } = await drawing;
    const picture = await takePicture(byId('surface'), createSurfaceView, { state, ...seen }, options);
    saveFile(fileName(state, 'picture', options), await picture.arrayBuffer(), typeOf('picture'));
    return { type: 'pictureTaken', failure: null };
  } catch (error) {
    return { type: 'pictureTaken', failure: error instanceof Error ? error.message : String(error) };
  }
}

function saveProject() {
  const project = desk.project();
  if (project) saveFile(project.name, project.text, 'application/json');
}

/** Whether the cage is a file's. @param {State} state */
const isFile = ({ document: { cage } }) => cage?.source.kind === 'text';

const takeFiles = createFileTaker({
  open(name, text) {
    if (isProject(text)) desk.openProject(name, text);
    else dispatch({ type: 'fileChosen', name, text });
  },
  openBeside(name, text) {
    if (isProject(text)) desk.openProject(name, text);
    else desk.openBeside({ name, text });
  },
  refuse: (name, message) => dispatch({ type: 'fileRefused', name, message }),
});
/** @param {string} id */
const byId = (id) => find(document, `#${id}`);
if (location.hash === INVITED) createInvitation(() => byId('file').click());
createGlossaryView(find(document, '.top'));
createKeyListView(find(document, '.top'), keyGroups.studio);
const theme = createThemeView(/** @type {HTMLButtonElement} */ (byId('theme')), (chosen) =>
  dispatch({ type: 'viewChanged', change: { theme: chosen } }),
);
theme.update(storedTheme()); // the page shows before its documents are read
const legend = createLegendView(byId('legend'), {
  choose: (shading) => dispatch({ type: 'viewChanged', change: { shading } }),
  unit,
  offered: allQuantities,
  pin: (ends) => {
    const { shading } = desk.state.view;
    dispatch({ type: 'viewChanged', change: { pinned: ends && { shading, ...ends } } });
  },
});
/** @type {ReturnType<typeof import('./pages/studio/views/surface.js').createSurfaceView> | null} */
let surface = null;
const documents = createDocumentsView(byId('documents'), {
  show: (id) => desk.show(id),
  close: (id) => void desk.close(id),
  create: () => desk.create(),
  reopen: () => void desk.reopen(),
});
const section = createSectionView(find(document, '.stage'), dispatch);
const plain = [
  createEditView(byId('edit'), dispatch, saveProject),
  createEntryView(byId('entry'), dispatch),
  createCageView(byId('cage'), dispatch, takeFiles),
  createHoldView(byId('hold'), dispatch),
  createPinsView(byId('hold'), dispatch),
  createCageEditingView(byId('hold'), dispatch),
  createBoundariesView(byId('boundaries'), dispatch),
  createClosenessView(byId('closeness'), dispatch),
  createHeldKeyView(byId('held-key')),
  createCrossingsView(byId('crossings')),
  createObjectiveView(byId('objective'), dispatch),
  createTriangleView(byId('triangle'), dispatch),
  createExamplesView(byId('objective')),
  createRunView(byId('run'), dispatch),
  createShowView(byId('show'), dispatch),
  section,
  createBeforeView(byId('surface'), dispatch),
  createCameraView(byId('camera'), dispatch),
  createPlotView(byId('plot')),
  createEnergiesView(byId('energies')),
  createLevelsView(byId('levels')),
  createLimitView(byId('limit')),
  createCertificateView(byId('certificate'), dispatch),
  createAlertView(byId('alert'), dispatch, saveProject),
];
const downloads = createDownloadsView(byId('downloads'), dispatch, byId('surface'));
createMenus(byId('surface'));
createDropView(byId('drop'), takeFiles);
createPasteView(takeFiles);
createCopyView(/** @type {HTMLButtonElement} */ (byId('copy')), async () => {
  const found = await linkOf(desk.state);
  if ('link' in found) return new URL(found.link || location.pathname, location.href).href;
  dispatch({ type: 'linkRefused', message: found.refused });
  return null;
});
addEventListener('hashchange', async () => {
  const problem = await problemIn(location.hash);
  if (problem) desk.openBeside(problem);
});

function show() {
  if (!desk.isOpen) return;
  const { state } = desk;
  const dark = theme.update(state.view.theme);
  // While the surface moves, the range changes rarely; another cage or a surface at rest gets its own range.
  const { shading, surface: shown, pinned, isolines } = state.view;
  const range = legend.update({
    shading,
    computed: computedValues(state),
    curvatures: shown ? [shown.limit.curvatures] : [],
    mesh: shown?.limit,
    pinned: pinned?.shading === shading ? pinned : null,
    isolines,
    occasion: `${state.session.run} ${state.session.phase.name === 'running'}`,
  });
  surface?.update(state, range, dark);
  downloads.update(state, range);
  seen = { range, dark };
  for (const view of plain) view.update(state);
  documents.update({ tabs: desk.tabs(), canReopen: desk.canReopen, unkept, elsewhere: desk.elsewhere });
  setText(byId('version'), state.session.version);
}

// The picture has colours of the page.
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show);
addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && desk.flush());
addEventListener('beforeunload', (event) => {
  if (!desk.isUnkept) return;
  void desk.flush();
  event.preventDefault();
});

// The drawing code is the largest part of the page; it is loaded while the worker starts.
const drawing = import('./pages/studio/views/surface.js');
drawing.catch(() => {}); // handled below
await desk.restore({
  search: location.search,
  shown: history.state?.document ?? null,
  theme: storedTheme(),
  problem: await problemIn(location.hash),
});
try {
  const { createSurfaceView } = await drawing;
  surface = createSurfaceView(byId('surface'), dispatch, legend.mark, section.tell);
} catch {
  createUndrawnView(byId('surface')).tell('unloaded');
}
show();
isolateNextVisit();
