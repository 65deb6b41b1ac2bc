// SPDX-License-Identifier: MIT
/**
 * @file What the catalog knows of a minimizer, in words and numbers.
 */
import { functionals } from './functionals.js';
import { significant, withError } from './numbers.js';

/** @import {CatalogEntry} from '../files/catalog.js' */

/** @type {Record<CatalogEntry['status'], string>} */
export const statusWords = {
  converged: 'converged',
  upper_bound: 'upper bound, not converging',
  zero_attained: 'zero is attained',
  infimum_not_attained: 'infimum, not attained',
  none_found: 'no minimizer found',
};

/**
 * The energy with as much certainty as there is: 3916 ± 35, ≤ 263, 0, or a dash.
 * @param {Pick<CatalogEntry, 'status' | 'energy' | 'error'>} entry
 */
export function energyWords({ status, energy, error }) {
  if (energy === null) return '–';
  if (status === 'converged' && error !== null) {
    const told = withError(energy, error, 2);
    return told.error ? `${told.value} ± ${told.error}` : told.value;
  }
  const digits = significant(energy, status === 'upper_bound' ? 4 : 6);
  return status === 'upper_bound' ? `≤ ${digits}` : digits;
}

/** A column of the catalog: a functional, or a blend whose name joins theirs. @param {string} name */
export function columnWords(name) {
  const known = functionals.find(({ id }) => id === name);
  if (known) return known.name;
  const parts = functionals.filter(({ id }) => name === id || name.startsWith(`${id}_`) || name.endsWith(`_${id}`));
  return parts.length ? parts.map((part) => part.name).join(' + ') : name;
}
