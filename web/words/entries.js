// SPDX-License-Identifier: MIT
/**
 * @file Names of the catalog's shapes, columns and entries, and what is known about them in words.
 */
import { cageWords } from './cages.js';
import { functionalWords } from './functionals.js';
import { compact, counted, integer, significant, upperBound, withError } from './numbers.js';

/** @import {FunctionalName} from '../../wasm/types.js' */
/** @import {CatalogEntry, CatalogFunctional, CatalogShape, EntryStatus} from '../files/catalog.js' */

/** Number of digits of an extrapolated energy's error, of an infimum, and of an energy known in theory. */
const ERROR_DIGITS = 2;
const INFIMUM_DIGITS = 6;
const EXACT_DIGITS = 7;
/** Of an energy that was computed another way. */
const OPINION_DIGITS = 6;

/** @param {string} words */
export const capitalized = (words) => words[0].toUpperCase() + words.slice(1);

const SUBSCRIPTS = '₀₁₂₃₄₅₆₇₈₉';
const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/**
 * Typesets the catalog's sentences, which are in ASCII: xi_{2,1} becomes ξ₂,₁, 8 pi^2 becomes 8π², and -11 % gets a
 * true minus.
 * @param {string} text
 */
export function typeset(text) {
  /** @param {string} number @param {string} digits */
  const set = (number, digits) => number.replace(/\d/g, (digit) => digits[Number(digit)]);
  return text
    .replace(/\bxi_\{(\d+),(\d+)\}/g, (_, k, m) => `ξ${set(k, SUBSCRIPTS)},${set(m, SUBSCRIPTS)}`)
    .replace(/(\d) pi\b/g, '$1π')
    .replace(/\^(\d+)/g, (_, power) => set(power, SUPERSCRIPTS))
    .replace(/(^|\s)-(?=\d)/g, '$1−')
    .replaceAll("'", '’');
}

/** @param {string} name of a shape */
export function shapeTitle(name) {
  return name === 'sphere' ? 'Sphere' : cageWords(name).title;
}

/** "8 junctions of 3 arms". @param {CatalogShape} shape @returns {string} empty if there are none, or if the title says so already */
export function junctionWords({ name, junctions, arms }) {
  return junctions && !name.startsWith('two-') ? `${counted(junctions, 'junction')} of ${counted(arms, 'arm')}` : '';
}

/** What is held at the boundary of a hole: "curvature held". @param {CatalogShape} shape @returns {string} empty for closed shapes */
export function boundaryWords({ constraints }) {
  return constraints?.boundary?.condition ? `${constraints.boundary.condition} held` : '';
}

/**
 * A column's head.
 * @param {CatalogFunctional} functional
 * @returns {{name: string, formula: string, taste: string}}
 */
export function columnWords({ weights }) {
  const parts = /** @type {Array<[FunctionalName, number]>} */ (Object.entries(weights)).map(([id, weight]) => ({
    ...functionalWords(id),
    weight,
  }));
  if (parts.length === 1) return parts[0];
  /** @param {(part: typeof parts[number]) => string} word */
  const sum = (word) =>
    parts.map((part) => (part.weight === 1 ? word(part) : `${compact(part.weight)} × ${word(part)}`)).join(' + ');
  return {
    name: sum(({ short }) => short),
    formula: sum(({ formula }) => formula),
    taste: 'A blend: round, and even in its curvature.',
  };
}

/** @type {Record<EntryStatus, {name: string, meaning: string}>} */
export const statusWords = {
  converged: {
    name: 'converged',
    meaning:
      'Three levels of refinement converge. The energy is their limit, and the bar also holds for orders of convergence below the observed one.',
  },
  upper_bound: {
    name: 'upper bound',
    meaning:
      'The energies of the levels do not settle. The number is the energy of a genuine surface, so the infimum is not above it.',
  },
  zero_attained: { name: 'attained', meaning: 'The functional is zero on this surface, and never less.' },
  infimum_not_attained: {
    name: 'infimum, not attained',
    meaning: 'Energies come as close to the number as one likes, but no surface has it.',
  },
  none_found: { name: 'none found', meaning: 'No run ended with a surface that could stand for a minimizer.' },
};

/**
 * An entry's energy.
 * @param {CatalogEntry} entry
 * @returns {{value: string, error: string, note: string}} `error` is empty if there is none, `note` if the number needs
 *   no explanation
 */
export function energyWords({ status, energy, error }) {
  const note = status === 'converged' || status === 'upper_bound' ? '' : statusWords[status].name;
  if (energy === null) return { value: '–', error: '', note };
  switch (status) {
    case 'converged':
      return { ...withError(energy, error ?? NaN, ERROR_DIGITS), note };
    case 'upper_bound':
      return { value: `≤ ${upperBound(energy)}`, error: '', note };
    default:
      return { value: significant(energy, INFIMUM_DIGITS), error: '', note };
  }
}

/** Values to compare an entry with: the paper's, and the one known in theory. @param {CatalogEntry} entry @returns {string[]} */
export function besideWords({ status, paper, exact }) {
  const words = [];
  if (paper !== null) words.push(`paper ${integer(paper)}`);
  // A known infimum is already the theoretical value.
  const computed = status === 'converged' || status === 'upper_bound';
  if (computed && exact !== null) words.push(`exact ${compact(exact, EXACT_DIGITS)}`);
  return words;
}

/** What a second opinion says of the surface that is shown. @param {CatalogEntry} entry @returns {string} empty if there is none */
export function opinionWords({ second_opinion: opinion }) {
  if (!opinion || opinion.energy === null || opinion.difference === null) return '';
  const difference = compact(Math.abs(opinion.difference), 1);
  return `Computed another way: ${compact(opinion.energy, OPINION_DIGITS)} (difference ${difference})`;
}

/**
 * The commands that compute an entry from scratch.
 * @param {CatalogShape} shape
 * @param {CatalogFunctional} functional
 * @param {CatalogEntry} entry
 */
export function commands({ name, cage, constraints }, { weights }, { settings }) {
  const family = cageWords(cage.generator).frame ? ` --family ${cage.family}` : '';
  const thickness = (cage.thickness ?? 1) === 1 ? '' : ` --thickness ${cage.thickness}`;
  const polygon = cage.sides ? ` --sides ${cage.sides} --rise ${cage.rise}` : '';
  const condition = constraints?.boundary?.condition;
  const boundary = condition ? ` --boundary ${condition} --holes hole` : '';
  const metric = settings.metric === 'auto' ? '' : ` --metric ${settings.metric}`;
  const sum = Object.entries(weights).map(([id, weight]) => `${id}=${weight}`);
  const objective = sum.length > 1 ? `--weights ${sum.join(',')}` : `--functional ${Object.keys(weights)[0]}`;
  const tolerance = settings.tolerance === 1e-6 ? '' : ` --tolerance ${settings.tolerance}`;
  const iterations = settings.max_iterations === 1000 ? '' : ` --max-iterations ${settings.max_iterations}`;
  const rings = settings.cap_rings === 4 ? '' : ` --cap-rings ${settings.cap_rings}`;
  const file = `${name}.obj`;
  return [
    `umbilic cage ${cage.generator}${family}${thickness}${polygon} -o ${file}`,
    `umbilic optimize ${file} ${objective}${boundary} --levels ${settings.levels.join('..')}${rings}${metric}${tolerance}${iterations}`,
  ].join('\n');
}

/** A citation of the catalog. @param {string} version @param {string} address of the catalog */
export function citation(version, address) {
  return `umbilic ${version}, a catalog of minimizers of curvature functionals, ${address}`;
}
