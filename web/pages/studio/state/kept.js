// SPDX-License-Identifier: MIT
/**
 * @file What of the studio's state is kept between visits, and the state that it becomes again. Pure.
 */
import { hasMoved } from './restore.js';

/** @import {Document, History, Phase, State, View} from './types.js' */

/** What is kept of how the surface was looked at. */
const KEPT_VIEW = /** @type {const} */ ([
  'shading',
  'pinned',
  'isolines',
  'cage',
  'original',
  'patches',
  'camera',
  'projection',
]);

/** @typedef {Pick<View, typeof KEPT_VIEW[number]>} KeptView */

/**
 * Plain data. `view` is how the surface was looked at; what is missing there was not known when it was kept.
 * @typedef {object} Kept
 * @property {Document} document
 * @property {History} history
 * @property {Phase['name']} phase
 * @property {Partial<KeptView>} view
 */

/** @param {View} view @returns {KeptView} */
const pick = (view) => /** @type {KeptView} */ (Object.fromEntries(KEPT_VIEW.map((name) => [name, view[name]])));

/** @param {State} state @returns {Kept} */
export function keptFrom({ document, history, session, view }) {
  return { document, history, phase: session.phase.name, view: pick(view) };
}

/**
 * The state without a worker, until it is wakened.
 * @param {State} blank
 * @param {Kept} kept
 * @returns {State}
 */
export function stateFrom(blank, { document, history, phase, view }) {
  const session = { ...blank.session, phase: phaseFrom(phase), opening: null, wanted: null };
  return { document, history, session, view: { ...blank.view, ...view } };
}

/** @param {Phase['name']} name @returns {Phase} */
function phaseFrom(name) {
  if (name === 'running' || name === 'paused') return { name, asked: null };
  return name === 'ended' ? { name, certifying: null } : { name: 'resting' };
}

/** Whether an address can name it: a generated cage, of which nothing is held. @param {Document} document */
const hasAddress = ({ cage, settings: { constraints, fill } }) =>
  cage?.source.kind !== 'text' && Object.keys(constraints).length === 0 && fill === null;

/** Whether nobody has done anything with it: its address says all there is. @param {Kept | State} state */
export const isUntouched = ({ document, history }) =>
  history.past.length + history.future.length === 0 &&
  (document.result.catalogs || (!hasMoved(document.result) && hasAddress(document)));

/** Whether the worker has something to do for it. @param {State} state */
export const isBusy = ({ session: { phase, opening, exporting } }) =>
  phase.name === 'running' || Boolean(opening) || exporting || ('certifying' in phase && phase.certifying !== null);

/** Whether what is kept differs. @param {State} before @param {State} after */
export const keepsOther = (before, after) =>
  before.document !== after.document ||
  before.history !== after.history ||
  before.session.phase.name !== after.session.phase.name ||
  KEPT_VIEW.some((name) => before.view[name] !== after.view[name]);
