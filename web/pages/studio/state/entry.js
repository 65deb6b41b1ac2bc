// SPDX-License-Identifier: MIT
/**
 * @file How the studio shows a minimizer of the catalog: found by its names, opened as the end of a run.
 */
import { beginOpening, openGenerated } from './opening.js';
import { phases, withDocument, withResult, withSession, withView } from './parts.js';
import { settingsFrom, sourceOf } from './settings.js';

/** @import {EntryName} from '../../../address/compare.js' */
/** @import {Catalog, CatalogEntry} from '../../../files/catalog.js' */
/** @import {Action, Outcome, State} from './types.js' */

/**
 * @param {Catalog} catalog
 * @param {EntryName} name
 * @returns {{entry: CatalogEntry} | {missing: string}} `missing` is a sentence that says why there is none
 */
export function findEntry({ shapes, functionals, entries }, { shape, functional }) {
  if (!shapes.some(({ name }) => name === shape)) return { missing: `The catalog has no shape “${shape}”.` };
  if (!functionals.some(({ name }) => name === functional))
    return { missing: `The catalog has no functional “${functional}”.` };
  const entry = entries.find((one) => one.shape === shape && one.functional === functional);
  if (!entry?.minimizer)
    return { missing: entry?.reason ?? `The catalog has no minimizer of “${functional}” for “${shape}”.` };
  return { entry };
}

/**
 * Opens the surface of an entry that has been loaded.
 * @param {State} state
 * @param {Extract<Action, {type: 'entryLoaded'}>} action
 * @returns {State}
 */
export function openEntry(state, { name, entry, report }) {
  if (state.session.wanted !== name || state.session.phase.name === 'unavailable') return state;
  const source = sourceOf(report.problem.cage, name.shape);
  if (source.kind !== 'generated') return openWithout(state, 'It has no generated cage.');
  const prepared = withDocument(withSession(state, { wanted: null }), {
    generator: { name: source.name, family: source.family, thickness: source.thickness },
    settings: settingsFrom(state.document.settings, report.problem),
  });
  const start = { level: report.surface.level, points: Float64Array.from(report.surface.points) };
  return beginOpening(prepared, { source, purpose: 'entry', then: 'hold', start, entry, report });
}

/**
 * Opens the cage, with a notice, if the minimizer does not exist or cannot be opened.
 * @param {State} state
 * @param {string} message
 * @param {EntryName | null} [retry] the entry, if it may be there another time
 * @returns {State}
 */
export function openWithout(state, message, retry = null) {
  const title = 'The catalog’s minimizer was not opened';
  return openGenerated(withView(state, { alert: { title, message, ...(retry && { retry }) } }));
}

/**
 * Shows the opened surface as the end of the run that the catalog describes.
 * @param {State} opened
 * @param {CatalogEntry} entry
 * @param {Outcome} report
 * @param {number} level of the surface
 * @returns {State}
 */
export function afterEntryOpened(opened, entry, report, level) {
  const { settings } = opened.document.result;
  const shown = withResult(endedWith(opened, report, level), { catalogs: true });
  return withView(withDocument(shown, { minimizer: { entry, settings } }), { fitDue: true });
}

/**
 * Shows the end of the run that a report describes.
 * @param {State} opened whose result is blank
 * @param {Outcome} report
 * @param {number} level of the surface
 * @returns {State}
 */
export function endedWith(opened, { levels, limit, energies, certificate, constraints }, level) {
  const ended = withResult(opened, {
    stop: levels.at(-1)?.stop ?? null,
    levels,
    limit,
    latest: { energies, evaluations: 0, level },
    certificate: certificate ?? null,
    constrained: constraints ?? null,
  });
  return withSession(ended, { phase: phases.ended });
}

/** Whether the surface on the screen is the catalog's. @param {State} state */
export const showsEntry = ({ document }) => document.result.catalogs;
