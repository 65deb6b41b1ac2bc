// SPDX-License-Identifier: MIT
/**
 * @file How the studio's state changes when the worker has opened what it was asked to open, or could not. Pure.
 */
import { editingOf, withoutDrag } from './editing.js';
import { afterEntryOpened, endedWith, openWithout } from './entry.js';
import { keptOf, nothingKept } from './hold.js';
import { firstGenerator, openGenerated } from './opening.js';
import {
  certifyingOf,
  noResult,
  phases,
  withDocument,
  withResult,
  withSession,
  withSettings,
  withView,
} from './parts.js';
import { placedRefusal } from './refusal.js';
import { settingsFrom, sourceOf } from './settings.js';
import { cagesOf } from './taken.js';

/** @import {Opened} from '../../../worker/protocol.js' */
/** @import {OpenCage, Opening, State} from './types.js' */

/**
 * @param {State} state
 * @param {Opening} opening
 * @param {Opened} message
 * @returns {State}
 */
export function afterOpened(state, opening, message) {
  const { run, source, settings, purpose, then } = opening;
  const { counts, groups, taken } = cagesOf(message);
  const { result } = state.document;
  const held = message.held ?? null;
  const opened = withView(
    withSession(state, {
      run,
      before: null,
      opening: null,
      refused: null,
      exporting: false,
      estimate: message.estimate ?? null,
    }),
    {
      coarse: false,
    },
  );
  if (purpose === 'recovery') {
    const phase = then === 'hold' ? state.session.phase : phases.running;
    const before = opening.start ? (result.saved?.evaluations ?? 0) : null;
    return withSession(withResult(opened, { settings, group: message.group, taken, held }), { phase, before });
  }
  const start = purpose === 'start' ? opening.start : (message.asked?.start ?? null);
  const fresh = withSession(
    withDocument(opened, { result: { ...noResult(settings), group: message.group, taken, held, start } }),
    {
      phase: then === 'hold' ? phases.resting : phases.running,
    },
  );
  if (opening.entry && opening.report && source.kind === 'generated') {
    const cage = { source, name: source.name, counts, groups };
    const saved = opening.start && { state: opening.start, evaluations: 0 };
    const shown = withView(withResult(withDocument(fresh, { cage }), { saved }), { alert: null });
    return afterEntryOpened(shown, opening.entry, opening.report, message.level);
  }
  if (purpose !== 'cage') return withResult(fresh, { latest: result.latest, saved: result.saved });
  return afterCageOpened(fresh, opening, message, { counts, groups });
}

/**
 * Shows another cage: everything of the one before is gone from the screen.
 * @param {State} fresh
 * @param {Opening} opening
 * @param {Opened} message
 * @param {Pick<OpenCage, 'counts' | 'groups'>} cage
 * @returns {State}
 */
function afterCageOpened(fresh, { source, edited }, message, cage) {
  const { document, view } = fresh;
  const shown = withView(
    withDocument(fresh, {
      settings: { ...document.settings, ...(edited?.kept ?? nothingKept), origin: 'cage' },
      minimizer: null,
    }),
    // A notice about the address must stay visible when the first cage opens.
    { boundary: null, pin: null, said: '', fitDue: !edited, alert: document.cage ? null : view.alert },
  );
  if (source.kind === 'problem') return afterFileOpened(shown, source.name, message, cage);
  const kept = source.kind === 'text' && message.text !== undefined ? { ...source, text: message.text } : source;
  const named = withDocument(shown, { cage: { source: kept, name: source.name, ...cage } });
  return edited ? withView(named, { editing: editingOf(kept, edited) }) : named;
}

/**
 * Opens a file. A problem brings its settings; a report is shown as the end of its run.
 * @param {State} shown
 * @param {string} fileName
 * @param {Opened} message
 * @param {Pick<OpenCage, 'counts' | 'groups'>} cage
 * @returns {State}
 */
function afterFileOpened(shown, fileName, { level, asked, report }, cage) {
  if (!asked) return shown;
  const source = sourceOf(asked.cage, fileName);
  const settings = settingsFrom(shown.document.settings, asked);
  const opened = withDocument(withResult(shown, { settings }), {
    cage: { source, name: source.name, ...cage },
    settings,
    ...(source.kind === 'generated' && {
      generator: { name: source.name, family: source.family, thickness: source.thickness },
    }),
  });
  return report ? withSettings(endedWith(opened, report, level), { origin: 'surface' }) : opened;
}

/** The notice for a file that cannot be opened. The core's message may begin with the file's name too. @param {string} name @param {string} message */
function notOpened(name, message) {
  const title = `${name} was not opened`;
  return { title, message: message.startsWith(`${name}: `) ? message.slice(name.length + 2) : message };
}

/** @param {State} state @param {number} run @param {string} message @returns {State} */
export function afterFailed(state, run, message) {
  const { opening, phase } = state.session;
  if (opening?.run === run) return afterRefused(state, opening, message);
  if (run !== state.session.run) return state;
  const certifying = certifyingOf(phase);
  const title = certifying ? 'Whether it is a minimum cannot be told' : 'This did not work';
  const over = withSession(state, { exporting: false, phase: certifying ? phases.ended : phase });
  return withView(over, { alert: { title, message } });
}

/** @param {State} state @param {Opening} opening @param {string} message @returns {State} */
function afterRefused(state, { purpose, source }, message) {
  const { document, session } = state;
  const { phase } = session;
  const closed = withSession(state, { opening: null, phase: phase.name === 'loading' ? phases.resting : phase });
  if (purpose === 'entry') return openWithout(closed, message);
  if (purpose === 'cage') {
    const withAlert = withView(withoutDrag(closed), { alert: notOpened(source.name, message) });
    // If the address names a shape that does not exist, opens the default shape instead.
    const nothing = !document.cage && source.name !== firstGenerator.name;
    if (!nothing) return withAlert;
    return openGenerated(withSession(withDocument(withAlert, { generator: firstGenerator }), { phase }));
  }
  const refused = placedRefusal(state, message);
  const settings = { ...document.result.settings, ...keptOf(document.settings) };
  if (!refused) {
    return withView(withDocument(closed, { settings }), {
      alert: { title: 'These settings cannot be used', message },
    });
  }
  // What could not be filled stays open; everything else waits to be changed.
  const { fill } = refused.place === 'fill' ? document.result.settings : settings;
  return withSession(withDocument(closed, { settings: { ...settings, fill } }), { refused });
}
