// SPDX-License-Identifier: MIT
/**
 * @file Everything that is known of one entry, in a dialog: its energy and where it comes from, its energies under all functionals, its
 * levels, and its downloads.
 */
import { MOST, entryName } from '../../../address/compare.js';
import { studioLink } from '../../../address/links.js';
import { functionals } from '../../../words/functionals.js';
import { compact, counted, significant, upperBound, whole, withError } from '../../../words/numbers.js';
import { element, find, whenChanged } from '../../../views/dom.js';
import { groupSymbol } from '../../../views/group.js';
import { findEntry } from '../select.js';
import { capitalized, columnWords, commands, junctionWords, shapeTitle, statusWords } from '../../../words/entries.js';
import { energyNodes, picture } from './cell.js';

/** @import {CatalogEntry, CatalogStart} from '../../../files/catalog.js' */
/** @import {Action, Download, EntryId, State} from '../types.js' */

/** @typedef {NonNullable<ReturnType<typeof findEntry>>} Found */

/** Below this, an integral is round-off. */
const ROUND_OFF = 1e-9;
/** Digits of a level's energy, and of what mathematics has. */
const LEVEL_DIGITS = 8;
const EXACT_DIGITS = 9;

/** @type {Array<{what: Download, name: string, title: string}>} */
const downloads = [
  { what: 'cage', name: 'Cage', title: 'The generated control cage, OBJ' },
  { what: 'control', name: 'Control mesh', title: 'The final control mesh with all digits, OBJ' },
  { what: 'limit', name: 'Limit mesh', title: 'The limit surface as quads with normals, OBJ' },
  { what: 'stl', name: 'STL', title: 'The limit surface for printing, 100 mm across' },
  { what: 'glb', name: 'GLB', title: 'The limit surface as a glTF model' },
];

/** @param {string} words */
const sentence = (words) => capitalized(words).replace(/\.?$/, '.');

/** @param {string} term @param {...(Node | string)} value */
const fact = (term, ...value) => element('div', {}, element('dt', {}, term), element('dd', {}, ...value));

/** @param {Found} found @param {CatalogStart[]} starts of the catalog @returns {HTMLElement[]} */
function facts({ entry, shape }, starts) {
  const { group, certificate, second_family: second, extrapolated, paper, exact, energy, settings } = entry;
  const list = [fact('Genus', String(shape.genus))];
  if (junctionWords(shape)) list.push(fact('Frame', junctionWords(shape)));
  if (group) list.push(fact('Symmetry', ...groupSymbol(group.name), `, order ${group.order}`));
  if (extrapolated?.order) list.push(fact('Observed order', compact(extrapolated.order, 2)));
  if (paper !== null) {
    const ratio = energy === null ? '' : `, ratio ${compact(energy / paper)}`;
    list.push(fact('The paper', `${whole(paper)}${ratio}`));
  }
  if (exact !== null) {
    const source = entry.exact_source ? `, ${entry.exact_source}` : '';
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
    const energies = same.map((start) => `${compact(start.thickness)} × as thick: ${significant(start.energy)}`);
    list.push(fact('From other cages', energies.join('; ')));
  }
  if (certificate) {
    const { negative, level } = certificate;
    const words = negative
      ? `${counted(negative, 'direction lowers', 'directions lower')} the energy, level ${level}`
      : `a local minimum among all surfaces near it, level ${level}`;
    list.push(fact('Certificate', words));
  }
  if (settings)
    list.push(
      fact(
        'Settings',
        `cap ${settings.cap}, levels ${settings.levels.join('–')}, tolerance ${compact(settings.tolerance)}`,
      ),
    );
  return list;
}

/** @param {CatalogEntry} entry @param {Found['functional']} functional */
function energyTable({ energies, quadrature_error }, { weights }) {
  const rows = functionals.map(({ id, name, formula }) => {
    const value = energies[id];
    const objective = id in weights;
    const text = value === null ? 'diverges' : significant(Math.abs(value) < ROUND_OFF ? 0 : value, LEVEL_DIGITS);
    return element(
      'tr',
      objective ? { class: 'objective' } : {},
      element('th', { scope: 'row', title: formula }, name),
      element('td', {}, text),
    );
  });
  if (energies.gaussian !== null) {
    const value = energies.gaussian / (4 * Math.PI);
    const text = significant(Math.abs(value) < 1e-6 ? 0 : value);
    rows.push(element('tr', {}, element('th', { scope: 'row' }, '∫ K dA / 4π'), element('td', {}, text)));
  }
  const table = element('table', { class: 'energies' }, element('tbody', {}, ...rows));
  const error = quadrature_error === null ? '' : ` Quadrature error ${compact(quadrature_error, 2)}.`;
  return [table, element('p', { class: 'note' }, `By a finer rule than the one that was minimized.${error}`)];
}

/** @param {CatalogEntry} entry */
function levelTable({ levels }) {
  const heads = ['Level', 'Patches', 'Unknowns', 'Energy'].map((name) => element('th', { scope: 'col' }, name));
  const rows = levels.map(({ level, patches, unknowns, energy_reported }) =>
    element(
      'tr',
      {},
      element('td', {}, String(level)),
      element('td', {}, whole(patches)),
      element('td', {}, whole(unknowns)),
      element('td', {}, energy_reported === null ? 'diverges' : significant(energy_reported, LEVEL_DIGITS)),
    ),
  );
  return element(
    'table',
    { class: 'levels' },
    element('thead', {}, element('tr', {}, ...heads)),
    element('tbody', {}, ...rows),
  );
}

/**
 * @param {HTMLDialogElement} dialog
 * @param {(action: Action) => void} dispatch
 */
export function createDetailsView(dialog, dispatch) {
  const content = find(dialog, '.content');
  dialog.addEventListener('close', () => dispatch({ type: 'entryClosed' }));
  dialog.addEventListener('click', ({ target }) => target === dialog && dialog.close());
  find(dialog, '.close').addEventListener('click', () => dialog.close());

  /** @type {HTMLButtonElement[]} */
  let buttons = [];
  let choose = element('input', { type: 'checkbox' });
  const problem = element('p', { class: 'problem', role: 'alert' });

  /** @param {Found} found @param {CatalogStart[]} starts */
  function fill(found, starts) {
    const { entry, shape, functional } = found;
    const id = entryName(entry);
    const column = columnWords(functional);
    const title = element('h2', { id: 'details-title' }, shapeTitle(shape.name));
    const about = element('p', { class: 'muted' }, `${column.name}: ${column.formula}`);
    const energy = element('p', { class: 'energy' }, ...energyNodes(entry));
    const { name, meaning } = statusWords[entry.status];
    const known = element(
      'p',
      {},
      element('strong', {}, capitalized(name)),
      `. ${entry.reason ? sentence(entry.reason) : meaning}`,
    );
    choose = element('input', { type: 'checkbox' });
    choose.addEventListener('change', () => dispatch({ type: 'entryChosen', entry: id, chosen: choose.checked }));
    buttons = downloads
      .filter(({ what }) => what === 'cage' || entry.minimizer)
      .map(({ what, name: text, title: hint }) => {
        const button = element('button', { type: 'button', name: what, title: hint }, text);
        button.addEventListener('click', () => dispatch({ type: 'downloadPressed', entry: id, what }));
        return button;
      });
    const actions = entry.minimizer
      ? [
          element('a', { class: 'button primary', href: studioLink(entry) }, 'Open in the studio'),
          element('label', { class: 'check' }, choose, 'Compare'),
        ]
      : [];
    content.replaceChildren(
      element(
        'div',
        { class: 'head' },
        picture(entry, '', 'eager'),
        element('div', {}, title, about, energy, known, element('div', { class: 'row' }, ...actions)),
      ),
      element('dl', { class: 'facts' }, ...facts(found, starts)),
      element(
        'div',
        { class: 'tables' },
        element('section', {}, element('h3', {}, 'Energies of this surface'), ...energyTable(entry, functional)),
        element('section', {}, element('h3', {}, 'Levels'), levelTable(entry)),
      ),
      element('section', {}, element('h3', {}, 'Download'), element('div', { class: 'buttons' }, ...buttons), problem),
      element(
        'section',
        {},
        element('h3', {}, 'Compute it again'),
        element('pre', {}, commands(shape, functional, entry)),
      ),
    );
    content.scrollTop = 0;
  }

  const show = whenChanged((/** @type {State['catalog']} */ catalog, /** @type {EntryId} */ id) => {
    const found = findEntry(catalog, id);
    if (found) {
      fill(found, catalog?.starts ?? []);
      if (!dialog.open) dialog.showModal();
    } else if (dialog.open) {
      dialog.close();
    }
  });

  return {
    /** @param {State} state */
    update(state) {
      const id = state.address.entry;
      show(state.catalog, id);
      choose.checked = state.chosen.includes(id);
      choose.disabled = !choose.checked && state.chosen.length >= MOST;
      for (const button of buttons) {
        const busy = state.exporting?.what === button.name;
        button.setAttribute('aria-busy', String(busy));
        button.setAttribute('aria-disabled', String(state.exporting !== null));
      }
      problem.textContent = state.exportProblem;
    },
    dispose: () => dialog.close(),
  };
}
