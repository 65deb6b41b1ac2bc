// SPDX-License-Identifier: MIT
/**
 * @file A minimizer of the catalog as the studio shows it: found by its names, opened as the end of a run that need not be run.
 */
import { beginOpening, openGenerated } from './opening.js';
import { settingsFrom } from './settings.js';

/** @import {CapName, Energies, LevelReport, Limit, Options} from '../../wasm/types.js' */
/** @import {EntryName} from '../address/compare.js' */
/** @import {Weights} from '../address/weights.js' */
/** @import {Catalog, CatalogEntry, CatalogSurface} from '../files/catalog.js' */
/** @import {Action, State} from './types.js' */

/** JSON knows no NaN. @param {number | null | undefined} value */
const orNaN = (value) => value ?? NaN;

/**
 * @param {Catalog} catalog
 * @param {EntryName} name
 * @returns {{entry: CatalogEntry, weights: Weights} | {missing: string}} `missing`: why there is none, in a sentence
 */
export function findEntry({ shapes, functionals, entries }, { shape, functional }) {
  if (!shapes.some(({ name }) => name === shape)) return { missing: `The catalog has no shape “${shape}”.` };
  const column = functionals.find(({ name }) => name === functional);
  if (!column) return { missing: `The catalog has no functional “${functional}”.` };
  const entry = entries.find((one) => one.shape === shape && one.functional === functional);
  if (!entry?.minimizer)
    return { missing: entry?.reason ?? `The catalog has no minimizer of “${functional}” for “${shape}”.` };
  return { entry, weights: column.weights };
}

/** What the run was asked that ends in the entry. @param {CatalogEntry} entry @returns {Options} */
const optionsOf = ({ settings: { cap, levels, tolerance, max_iterations, symmetry } }) => ({
  cap: /** @type {CapName} */ (cap),
  levels,
  tolerance,
  max_iterations,
  symmetry,
});

/** @param {CatalogEntry} entry @returns {Energies} */
export function energiesOf({ energies, quadrature_error }) {
  const known = Object.fromEntries(Object.entries(energies).map(([name, value]) => [name, orNaN(value)]));
  return /** @type {Energies} */ ({ ...known, quadrature_error: orNaN(quadrature_error), whole: true });
}

/** @param {CatalogEntry} entry @returns {LevelReport[]} whose seconds are not known */
export function levelsOf({ levels }) {
  return levels.map(({ energy_reported, quadrature = 0, ...level }) => ({
    ...level,
    quadrature,
    energy: orNaN(level.energy),
    energy_reported: orNaN(energy_reported),
    seconds: NaN,
  }));
}

/** @param {CatalogEntry} entry @returns {Limit} */
export function limitOf({ extrapolated: { status, energy, order, error } }) {
  return { status, energy: orNaN(energy), order: orNaN(order), error: orNaN(error) };
}

/**
 * The entry is there: its surface is opened.
 * @param {State} state
 * @param {Extract<Action, {type: 'entryLoaded'}>} action
 * @returns {State}
 */
export function openEntry(state, { name, entry, weights, surface }) {
  if (state.wanted !== name) return state;
  const { generator, family, thickness } = surface.cage;
  /** @type {State} */
  const prepared = {
    ...state,
    wanted: null,
    generator: { name: generator, family, thickness },
    settings: settingsFrom(state.settings, { terms: weights, options: optionsOf(entry) }),
  };
  return beginOpening(prepared, {
    source: { kind: 'generated', ...prepared.generator },
    purpose: 'entry',
    then: 'hold',
    start: { level: surface.level, points: Float64Array.from(surface.points) },
    entry,
  });
}

/**
 * There is no such minimizer, or it cannot be opened: its cage, and why.
 * @param {State} state
 * @param {string} message
 * @returns {State}
 */
export function openWithout(state, message) {
  return openGenerated({ ...state, alert: { title: 'The catalog’s minimizer was not opened', message } });
}

/**
 * What opening has made of a surface is the end of the run that the catalog tells of.
 * @param {State} opened
 * @param {CatalogEntry} entry
 * @returns {State}
 */
export function afterEntryOpened(opened, entry) {
  const latest = { energies: energiesOf(entry), evaluations: 0 };
  return {
    ...opened,
    status: 'ended',
    stop: entry.levels.at(-1)?.stop ?? 'converged',
    progress: null,
    samples: [],
    levels: levelsOf(entry),
    limit: limitOf(entry),
    first: null,
    latest,
    saved: null,
    certificate: entry.certificate,
    minimizer: { entry, settings: opened.runSettings, run: opened.run },
    fitDue: true,
  };
}

/** Whether the surface on the screen is the catalog's. @param {State} state */
export function showsEntry({ minimizer, run }) {
  return minimizer !== null && minimizer.run === run;
}
