// SPDX-License-Identifier: MIT
/**
 * @file The catalog's files as the pages read them, in the schema in which `npm run catalog` writes them.
 */

/** @import {CertificateReport, FunctionalName, GeneratedCage, Group, LevelReport, LimitStatus, Options, Report} from '../../wasm/types.js' */

/**
 * What is known of a minimizer. The energy of `converged` is extrapolated and has an error bar; that of `upper_bound` is a genuine
 * surface's; that of `zero_attained` and `infimum_not_attained` is the infimum itself.
 * @typedef {'converged' | 'upper_bound' | 'zero_attained' | 'infimum_not_attained' | 'none_found'} EntryStatus
 */

/** A column. @typedef {{name: string, weights: Partial<Record<FunctionalName, number>>}} CatalogFunctional */

/**
 * A row. `junctions` and `arms` of each junction are 0 where there are none.
 * @typedef {{name: string, genus: number, junctions: number, arms: number, cage: GeneratedCage}} CatalogShape
 */

/** Null where a quantity diverges. @typedef {Record<FunctionalName | 'area' | 'gaussian' | 'quadrature_error', number | null> & {whole: boolean}} EntryEnergies */

/** @typedef {Omit<LevelReport, 'energy_reported' | 'seconds'> & {energy_reported: number | null, seconds: null}} EntryLevel */

/** `agrees`: null where one of the two has no error bar. @typedef {{family: string, energy: number | null, error: number | null, agrees: boolean | null, levels: EntryLevel[]}} SecondFamily */

/**
 * @typedef {object} CatalogEntry
 * @property {string} shape
 * @property {string} functional
 * @property {EntryStatus} status
 * @property {number | null} energy null if none was found
 * @property {number | null} error half-width of the error bar, if converged
 * @property {string} [reason] one sentence, where the status needs one
 * @property {number | null} paper what the paper's Table 1 prints
 * @property {number | null} exact the infimum within the symmetry, where mathematics has it
 * @property {string} [exact_source]
 * @property {Group} group
 * @property {Required<Options>} settings
 * @property {EntryEnergies} energies of the last level's surface
 * @property {EntryLevel[]} levels
 * @property {{status: LimitStatus, energy: number | null, order: number | null, error: number | null}} limit
 * @property {CertificateReport | null} certificate
 * @property {SecondFamily | null} second_family the same from other cages
 * @property {string | null} minimizer the file of its run's report, beside the catalog
 * @property {number} level of that surface, in Catmull-Clark steps from the cage
 * @property {number} faces of its control mesh
 */

/** The same minimizer from a cage of another thickness. @typedef {{shape: string, functional: string, thickness: number, energy: number, level: number}} CatalogStart */

/** @typedef {{version: string, functionals: CatalogFunctional[], shapes: CatalogShape[], entries: CatalogEntry[], starts: CatalogStart[]}} Catalog */

/**
 * The address of a file of the catalog, for pages beside its folder.
 * @param {string} name "catalog.json", "two-3.bending.json", "pictures/two-3.bending.webp"
 */
export function catalogAddress(name) {
  return `./catalog/${name}`;
}

/** @param {string} name @returns {Promise<Response>} */
async function load(name) {
  const response = await fetch(catalogAddress(name));
  if (!response.ok) throw new Error(`${name} was not loaded: ${response.status} ${response.statusText}`);
  return response;
}

/** @returns {Promise<Catalog>} */
export const loadCatalog = async () => (await load('catalog.json')).json();

/** A report knows null only in the place of a number that is not finite. @param {string} text @returns {Report} */
export const parseReport = (text) => JSON.parse(text, (_, value) => (value === null ? NaN : value));

/** @param {string} name an entry's `minimizer` @returns {Promise<Report>} */
export const loadReport = async (name) => parseReport(await (await load(name)).text());
