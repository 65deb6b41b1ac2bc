// SPDX-License-Identifier: MIT
/**
 * @file All energies of the compared surfaces, one column each; the smallest of each functional is marked.
 */
import { studioLink } from '../../../address/links.js';
import { element, whenChanged } from '../../../views/dom.js';
import { columnWords, energyWords, shapeTitle, typeset } from '../../../words/entries.js';
import { functionals } from '../../../words/functionals.js';
import { significant } from '../../../words/numbers.js';
import { energyTable } from '../energies.js';
import { entryOf } from '../reduce.js';

/** @import {EntryName} from '../../../address/compare.js' */
/** @import {Catalog, CatalogEntry} from '../../../files/catalog.js' */
/** @import {Cell} from '../energies.js' */
/** @import {State} from '../types.js' */

/** @param {HTMLElement} root */
export function createTableView(root) {
  const show = whenChanged((/** @type {Catalog | null} */ catalog, /** @type {EntryName[]} */ names) => {
    if (!catalog) return root.replaceChildren();
    const entries = names.map((name) => entryOf(catalog, name));
    const heads = names.map((name) => {
      const column = catalog.functionals.find((one) => one.name === name.functional);
      return element(
        'th',
        { scope: 'col' },
        element('a', { href: studioLink(name), title: 'Open in the studio' }, shapeTitle(name.shape)),
        element('span', {}, column ? columnWords(column).name : name.functional),
      );
    });
    const known = element(
      'tr',
      { class: 'known' },
      element('th', { scope: 'row' }, 'What it minimizes'),
      ...entries.map((entry) =>
        element('td', entry?.reason ? { title: typeset(entry.reason) } : {}, ...knownOf(entry)),
      ),
    );
    const rows = energyTable(entries).map(({ functional, cells }) => {
      const { name, formula } = functionals.find(({ id }) => id === functional) ?? { name: functional, formula: '' };
      return element('tr', {}, element('th', { scope: 'row', title: formula }, name), ...cells.map(cellOf));
    });
    root.replaceChildren(
      element(
        'table',
        { class: 'comparison' },
        element('caption', { class: 'hidden' }, 'Energies of the surfaces side by side'),
        element('thead', {}, element('tr', {}, element('td'), ...heads)),
        element('tbody', {}, known, ...rows),
      ),
    );
  });
  return {
    /** @param {State} state */
    update: ({ catalog, entries }) => show(catalog, entries),
    dispose: () => root.replaceChildren(),
  };
}

/** @param {CatalogEntry | null} entry @returns {Array<Node | string>} */
function knownOf(entry) {
  if (!entry) return ['–'];
  const { value, error, note } = energyWords(entry);
  return [
    element('strong', {}, error ? `${value} ± ${error}` : value),
    ...(note ? [' ', element('span', { class: 'note' }, note)] : []),
  ];
}

/** @param {Cell} cell */
function cellOf({ value, least }) {
  const text = value === null ? '–' : significant(value);
  return element('td', {}, least ? element('strong', { class: 'least', title: 'The least of the row' }, text) : text);
}
