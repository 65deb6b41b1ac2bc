// SPDX-License-Identifier: MIT
/**
 * @file A minimizer of the catalog as the studio shows it: found by its names, opened as the end of a run that need not be run.
 */
import { beginOpening, openGenerated } from './opening.js';

/** @import {CapName, Energies, FunctionalName, LevelReport, Limit} from '../../wasm/types.js' */
/** @import {EntryName} from '../address/compare.js' */
/** @import {Weights} from '../address/weights.js' */
/** @import {Catalog, CatalogEntry, CatalogSurface} from '../files/catalog.js' */
/** @import {Action, Settings, State} from './types.js' */

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

/**
 * What a run was asked that ends in the entry.
 * @param {Settings} settings
 * @param {CatalogEntry['settings']} used
 * @param {Weights} weights
 * @returns {Settings}
 */
function settingsOf(settings, used, weights) {
  const names = /** @type {FunctionalName[]} */ (Object.keys(weights));
  const none = Object.fromEntries(Object.keys(settings.weights).map((name) => [name, 0]));
  return {
    ...settings,
    ...(names.length === 1
      ? { functional: names[0] }
      : { functional: 'blend', weights: /** @type {Settings['weights']} */ ({ ...none, ...weights }) }),
    cap: /** @type {CapName} */ (used.cap),
    symmetry: used.symmetry,
    levels: used.levels,
    tolerance: used.tolerance,
    maxIterations: used.max_iterations,
    origin: 'cage',
  };
}

/** @param {CatalogEntry} entry @returns {Energies} */
export function energiesOf({ energies, quadrature_error }) {
  const known = Object.fromEntries(Object.entries(energies).map(([name, value]) => [name, orNaN(value)]));
  return /** @type {Energies} */ ({ ...known, quadratureError: orNaN(quadrature_error) });
}

/** @param {CatalogEntry} entry @returns {LevelReport[]} whose seconds are not known */
export function levelsOf({ levels }) {
  return levels.map(({ energy_reported, quadrature = 0, ...level }) => ({
    ...level,
    quadrature,
    energy: orNaN(level.energy),
    energyReported: orNaN(energy_reported),
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
    settings: settingsOf(state.settings, entry.settings, weights),
  };
  return beginOpening(prepared, {
    source: {
      kind: 'minimizer',
      ...prepared.generator,
      level: surface.level,
      points: Float64Array.from(surface.points),
    },
    purpose: 'entry',
    then: 'hold',
    levelOffset: surface.level,
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
