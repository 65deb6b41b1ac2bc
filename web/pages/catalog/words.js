// SPDX-License-Identifier: MIT
/**
 * @file What only the catalog says: where its shapes have junctions, how an entry is computed again, and how it is cited.
 */
import { cageWords } from '../../words/cages.js';
import { counted } from '../../words/numbers.js';

/** @import {CatalogEntry, CatalogFunctional, CatalogShape} from '../../files/catalog.js' */

/** "8 junctions of 3 arms". @param {CatalogShape} shape @returns {string} empty where there are none, or where the title says it */
export function junctionWords({ name, junctions, arms }) {
  return junctions && !name.startsWith('two-') ? `${counted(junctions, 'junction')} of ${counted(arms, 'arm')}` : '';
}

/**
 * The commands that compute an entry from nothing.
 * @param {CatalogShape} shape
 * @param {CatalogFunctional} functional
 * @param {CatalogEntry} entry
 */
export function commands({ name, cage }, { weights }, { settings }) {
  const family = cageWords(cage.generator).frame ? ` --family ${cage.family}` : '';
  const thickness = cage.thickness === 1 ? '' : ` --thickness ${cage.thickness}`;
  const sum = Object.entries(weights).map(([id, weight]) => `${id}=${weight}`);
  const objective = sum.length > 1 ? `--weights ${sum.join(',')}` : `--functional ${Object.keys(weights)[0]}`;
  const file = `${name}.obj`;
  return [
    `umbilic cage ${cage.generator}${family}${thickness} -o ${file}`,
    `umbilic optimize ${file} ${objective} --levels ${settings.levels.join('..')}`,
  ].join('\n');
}

/** How the catalog is cited. @param {string} version @param {string} address of the catalog */
export function citation(version, address) {
  return `umbilic ${version}, a catalog of minimizers of curvature functionals, ${address}`;
}
