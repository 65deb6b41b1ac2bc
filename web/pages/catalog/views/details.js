// SPDX-License-Identifier: MIT
/**
 * @file A dialog with all that is known of one entry: its energy and source, its energies under all functionals, its
 * levels, and its downloads.
 */
import { MOST, entryName } from '../../../address/compare.js';
import { studioLink } from '../../../address/links.js';
import { element, find, whenChanged } from '../../../views/dom.js';
import { findEntry } from '../select.js';
import { capitalized, columnWords, commands, shapeTitle, statusWords, typeset } from '../../../words/entries.js';
import { energyNodes, picture } from './cell.js';
import { energyTable, facts, levelTable } from './known.js';

/** @import {CatalogStart} from '../../../files/catalog.js' */
/** @import {Action, Download, EntryId, State} from '../types.js' */

/** @import {Found} from './known.js' */

/** @type {Array<{what: Download, name: string, title: string}>} */
const downloads = [
  { what: 'cage', name: 'Cage', title: 'The generated control cage, OBJ' },
  { what: 'control', name: 'Control mesh', title: 'The final control mesh with all digits, OBJ' },
  { what: 'limit', name: 'Limit mesh', title: 'The limit surface as quads with normals, OBJ' },
  { what: 'stl', name: 'STL', title: 'The limit surface for printing, 100 mm across' },
  { what: 'glb', name: 'GLB', title: 'The limit surface as a glTF model' },
];

/** @param {string} words */
const sentence = (words) => capitalized(typeset(words)).replace(/\.?$/, '.');

/**
 * @param {HTMLDialogElement} dialog
 * @param {(action: Action) => void} dispatch
 */
export function createDetailsView(dialog, dispatch) {
  const content = find(dialog, '.content');
  // The event comes later, when another entry may be open already.
  dialog.addEventListener('close', () => !dialog.open && dispatch({ type: 'entryClosed' }));
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
