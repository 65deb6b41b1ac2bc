// SPDX-License-Identifier: MIT
/**
 * @file Types and loading of the catalog's files, in the schema in which `npm run catalog` writes them.
 */

/** @import {CertificateReport, Constraints, Energies, FunctionalName, GeneratedCage, Group, LevelReport, LimitStatus, Options, Report} from '../../wasm/types.js' */

/**
 * How the energy of an entry is known. `converged`: extrapolated, with an error bar. `upper_bound`: the energy of an
 * actual surface. `zero_attained` and `infimum_not_attained`: the infimum itself. `none_found`: not known.
 * @typedef {'converged' | 'upper_bound' | 'zero_attained' | 'infimum_not_attained' | 'none_found'} EntryStatus
 */

/** A column of the catalog. @typedef {{name: string, weights: Partial<Record<FunctionalName, number>>}} CatalogFunctional */

/**
 * A row of the catalog. `junctions` and `arms` (per junction) are 0 if the shape has no junctions. Only holes, which are open,
 * have `sides` and `constraints`.
 * @typedef {{name: string, genus: number, junctions: number, arms: number, sides?: number, cage: GeneratedCage, constraints?: Constraints}} CatalogShape
 */

/** A quantity is null if it diverges; an entry has no functional that is newer than it. @typedef {Partial<Record<FunctionalName, number | null>> & Record<'area' | 'gaussian' | 'quadrature_error', number | null> & {resolved: boolean} & Partial<Pick<Energies, 'below_bound' | 'embedded' | 'free'>>} EntryEnergies */

/**
 * Levels that an earlier version computed lack the members that came later.
 * @typedef {'credible' | 'thickened' | 'predicted_decrease' | 'parametrization_stages' | 'factorizations' | 'narrower_caps_energy' | 'narrower_caps_evaluations'} LaterMember
 * @typedef {Omit<LevelReport, 'energy_reported' | 'seconds' | LaterMember> & Partial<Pick<LevelReport, LaterMember>>
 *   & {energy_reported: number | null, seconds: null}} EntryLevel
 */

/** The result for the other family of cages. `agrees` is null if one of the two energies has no error bar. @typedef {{family: string, energy: number | null, error: number | null, agrees: boolean | null, levels: EntryLevel[]}} SecondFamily */

/**
 * A surface below the entry's, with less symmetry. `minimizer` is the file of its report.
 * @typedef {{energy: number, group: Group, level: number, faces: number, certificate: CertificateReport | null, minimizer: string}} LowerMinimizer
 */

/** What another way of computing finds of the minimized energy of the surface that is shown, and what the main value has more, relatively. @typedef {{energy: number | null, difference: number | null}} SecondOpinion */

/**
 * @typedef {object} CatalogEntry
 * @property {string} shape
 * @property {string} functional
 * @property {EntryStatus} status
 * @property {number | null} energy null if none was found
 * @property {number | null} error half-width of the error bar, if converged
 * @property {string} [reason] one sentence, for statuses that need one
 * @property {number | null} paper what the paper's Table 1 prints
 * @property {number | null} exact the infimum among surfaces of this symmetry, if it is known in theory
 * @property {string} [exact_source]
 * @property {Group} group
 * @property {Required<Omit<Options, 'accuracy' | 'second_opinion'>>} settings
 * @property {EntryEnergies} energies energies of the last level's surface
 * @property {SecondOpinion} [second_opinion] not of entries that an earlier version computed
 * @property {EntryLevel[]} levels
 * @property {{status: LimitStatus, energy: number | null, order: number | null, error: number | null, lower?: number | null}} limit
 * @property {CertificateReport | null} certificate
 * @property {LowerMinimizer} [below] what the minimizer descends to, where its certificate counts directions of descent
 * @property {SecondFamily | null} second_family the result for the other family of cages
 * @property {string | null} minimizer file name of the run's report, in the catalog's folder
 * @property {number} level level of the minimizer, in Catmull-Clark steps from the cage
 * @property {number} faces number of faces of the minimizer's control mesh
 */

/** The result of a run from a cage of another thickness. @typedef {{shape: string, functional: string, thickness: number, energy: number, level: number}} CatalogStart */

/** @typedef {{version: string, functionals: CatalogFunctional[], shapes: CatalogShape[], entries: CatalogEntry[], starts: CatalogStart[]}} Catalog */

/**
 * The address of a file of the catalog, relative to the pages.
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

/** Parses a report. In its JSON text, null always stands for a number that is not finite. @param {string} text @returns {Report} */
export const parseReport = (text) => JSON.parse(text, (_, value) => (value === null ? NaN : value));

/** @param {string} name an entry's `minimizer` @returns {Promise<Report>} */
export const loadReport = async (name) => parseReport(await (await load(name)).text());
