// SPDX-License-Identifier: MIT
/**
 * @file The parts of an entry's details: a list of facts, its energies under every functional, and its levels.
 */
import { entryName } from '../../../address/compare.js';
import { catalogAddress } from '../../../files/catalog.js';
import { element } from '../../../views/dom.js';
import { groupSymbol } from '../../../views/group.js';
import { boundaryWords, columnWords, junctionWords, opinionWords, typeset } from '../../../words/entries.js';
import { functionals } from '../../../words/functionals.js';
import { freeName, freeWords } from '../../../words/holding.js';
import { compact, counted, integer, significant, upperBound, withError } from '../../../words/numbers.js';

/** @import {Energies, FunctionalName} from '../../../../wasm/types.js' */
/** @import {CatalogEntry, CatalogFunctional, CatalogStart} from '../../../files/catalog.js' */
/** @import {findEntry} from '../select.js' */

/** @typedef {NonNullable<ReturnType<typeof findEntry>>} Found */

/** An energy below this is rounding error. */
const ROUND_OFF = 1e-9;
/** An integral of the Gaussian curvature below this is zero within the quadrature error. */
const INTEGRAL_ERROR = 1e-6;
/** Number of digits of energies, and of energies known in theory. */
const ENERGY_DIGITS = 8;
const EXACT_DIGITS = 9;

/** @param {string} term @param {...(Node | string)} value */
const fact = (term, ...value) => element('div', {}, element('dt', {}, term), element('dd', {}, ...value));

/** The facts about an entry besides its energy. @param {Found} found @param {CatalogStart[]} starts all of the catalog @returns {HTMLElement[]} */
export function facts({ entry, shape }, starts) {
  const { group, certificate, below, second_family: second, limit, paper, exact, energy, settings } = entry;
  const list = [fact('Genus', `${shape.genus}${shape.sides ? ', open' : ''}`)];
  if (boundaryWords(shape)) list.push(fact('Boundary', `${boundaryWords(shape)}, that of the cage’s own surface`));
  if (junctionWords(shape)) list.push(fact('Frame', junctionWords(shape)));
  if (group) list.push(fact('Symmetry', ...groupSymbol(group.name), `, order ${group.order}`));
  if (limit?.order) list.push(fact('Observed order', compact(limit.order, 2)));
  if (paper !== null) {
    const ratio = energy === null ? '' : `, ratio ${compact(energy / paper)}`;
    list.push(fact('The paper', `${integer(paper)}${ratio}`));
  }
  if (exact !== null) {
    const source = entry.exact_source ? `, ${typeset(entry.exact_source)}` : '';
    list.push(fact('Exact', `${compact(exact, EXACT_DIGITS)}${source}`));
  }
  if (second && second.energy !== null) {
    const { value, error } = withError(second.energy, second.error ?? NaN, 2);
    const bound = second.error === null ? `≤ ${upperBound(second.energy)}` : `${value} ± ${error}`;
    const verdict = second.agrees === null ? '' : second.agrees ? ', agrees' : ', does not agree';
    list.push(fact(`From ${second.family} cages`, bound + verdict));
  }
  const same = starts.filter((start) => entryName(start) === entryName(entry));
  if (same.length) {
    const thicknesses = same.map(({ thickness }) => compact(thickness)).join(', ');
    const energies = same.map((start) => significant(start.energy, ENERGY_DIGITS)).join(', ');
    list.push(fact(`From thickness ${thicknesses}`, `${energies}, level ${same[0].level}`));
  }
  if (certificate) {
    const { negative, level } = certificate;
    const words = negative
      ? `${counted(negative, 'direction lowers', 'directions lower')} the energy, level ${level}`
      : `a local minimum among all surfaces near it${shape.sides ? ' with this boundary' : ''}, level ${level}`;
    list.push(fact('Certificate', words));
  }
  if (below) list.push(fact('Below it', ...belowWords(below)));
  if (settings)
    list.push(
      fact(
        'Settings',
        `cap ${settings.cap}, levels ${settings.levels.join('–')}, tolerance ${compact(settings.tolerance)}`,
      ),
    );
  return list;
}

/** @param {import('../../../files/catalog.js').LowerMinimizer} below @returns {Array<Node | string>} */
function belowWords({ energy, group, level, certificate, minimizer }) {
  const proved = certificate?.negative === 0 ? ', a local minimum' : '';
  const file = element('a', { href: catalogAddress(minimizer), download: minimizer }, 'its report');
  return [
    `${significant(energy, ENERGY_DIGITS)} at level ${level}, symmetry `,
    ...groupSymbol(group.name),
    `${proved}: `,
    file,
    ', which the studio opens when it is dropped there',
  ];
}

/** @param {string} name @param {string} formula @param {number | null} value @param {boolean} objective */
function energyRow(name, formula, value, objective) {
  const text = value === null ? 'diverges' : significant(Math.abs(value) < ROUND_OFF ? 0 : value, ENERGY_DIGITS);
  return element(
    'tr',
    objective ? { class: 'objective' } : {},
    element('th', { scope: 'row', title: formula }, name),
    element('td', {}, text),
  );
}

/** The energies of an entry's surface under every functional. @param {CatalogEntry} entry @param {CatalogFunctional} functional @returns {HTMLElement[]} */
export function energyTable(entry, functional) {
  const { energies } = entry;
  const parts = Object.entries(functional.weights);
  const terms = /** @type {FunctionalName[]} */ (Object.keys(functional.weights));
  const { free } = energies;
  const rows = functionals.flatMap(({ id, name, formula }) => {
    const energy = energies[id];
    if (energy === undefined) return []; // the entry is older than the functional
    return [energyRow(name, formula, energy, parts.length === 1 && id in functional.weights && !free)];
  });
  if (parts.length > 1 || free) {
    const { name, formula } = columnWords(functional);
    const minimized = free ?? energies;
    const sum = parts.reduce(
      (total, [id, weight]) => total + weight * (minimized[/** @type {FunctionalName} */ (id)] ?? NaN),
      0,
    );
    const told = free ? `${name}, ${freeName(/** @type {Energies} */ (energies))}` : name;
    rows.unshift(energyRow(told, formula, sum, true));
  }
  if (energies.gaussian !== null) {
    const value = energies.gaussian / (4 * Math.PI);
    const text = significant(Math.abs(value) < INTEGRAL_ERROR ? 0 : value);
    rows.push(element('tr', {}, element('th', { scope: 'row' }, '∫ K dA / 4π'), element('td', {}, text)));
  }
  const table = element('table', { class: 'energies' }, element('tbody', {}, ...rows));
  const { quadrature_error } = energies;
  const error = quadrature_error === null ? '' : ` Quadrature error ${compact(quadrature_error, 2)}.`;
  const opinion = opinionWords(entry);
  return [
    table,
    ...freeWords(/** @type {Energies} */ (energies), terms).map((words) => element('p', { class: 'note' }, words)),
    element('p', { class: 'note' }, `By a finer rule than the one that was minimized.${error}`),
    ...(opinion ? [element('p', { class: 'note' }, `${opinion}.`)] : []),
  ];
}

/** @param {CatalogEntry} entry */
export function levelTable({ levels }) {
  const heads = ['Level', 'Patches', 'Unknowns', 'Energy'].map((name) => element('th', { scope: 'col' }, name));
  const rows = levels.map(({ level, patches, unknowns, energy_reported }) =>
    element(
      'tr',
      {},
      element('td', {}, String(level)),
      element('td', {}, integer(patches)),
      element('td', {}, integer(unknowns)),
      element('td', {}, energy_reported === null ? 'diverges' : significant(energy_reported, ENERGY_DIGITS)),
    ),
  );
  return element(
    'table',
    { class: 'levels' },
    element('thead', {}, element('tr', {}, ...heads)),
    element('tbody', {}, ...rows),
  );
}
