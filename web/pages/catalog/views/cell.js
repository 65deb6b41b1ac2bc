// SPDX-License-Identifier: MIT
/**
 * @file One entry in the table: its picture, energy and status, a box to choose it for comparison, and a link to its
 * details.
 */
import { MOST, entryName } from '../../../address/compare.js';
import { studioLink } from '../../../address/links.js';
import { catalogAddress } from '../../../files/catalog.js';
import { element, setText } from '../../../views/dom.js';
import { besideWords, energyWords } from '../../../words/entries.js';

/** @import {CatalogEntry} from '../../../files/catalog.js' */
/** @import {Action, State} from '../types.js' */

/** Size of the pictures in CSS pixels; they have twice as many. */
const PICTURE = { width: '240', height: '180' };

/** An energy with its error bar. @param {CatalogEntry} entry @returns {Node[]} */
export function energyNodes(entry) {
  const { value, error } = energyWords(entry);
  const nodes = [element('span', { class: 'value' }, value)];
  if (error) nodes.push(element('span', { class: 'error' }, ` ± ${error}`));
  return nodes;
}

/** @param {CatalogEntry} entry @param {string} words a description of the picture @param {'lazy' | 'eager'} [loading] */
export function picture(entry, words, loading = 'lazy') {
  if (!entry.minimizer) return element('span', { class: 'no-picture' });
  const src = catalogAddress(`pictures/${entryName(entry)}.webp`);
  return element('img', { src, alt: words, loading, decoding: 'async', draggable: 'false', ...PICTURE });
}

/**
 * @param {CatalogEntry} entry
 * @param {string} shape
 * @param {string} functional
 * @param {(action: Action) => void} dispatch
 */
export function createCell(entry, shape, functional, dispatch) {
  const words = `${shape}, ${functional}`;
  const id = entryName(entry);
  const choose = element('input', { type: 'checkbox', 'aria-label': `Compare ${words}` });
  choose.addEventListener('change', () => dispatch({ type: 'entryChosen', entry: id, chosen: choose.checked }));
  const more = element('button', { type: 'button', class: 'quiet more', 'aria-label': `Details: ${words}` }, 'Details');
  more.addEventListener('click', () => dispatch({ type: 'entryOpened', entry: id }));

  const shown = [picture(entry, words), element('span', { class: 'energy' }, ...energyNodes(entry))];
  const open = entry.minimizer
    ? element('a', { class: 'open', href: studioLink(entry), title: 'Open in the studio' }, ...shown)
    : element('span', { class: 'open' }, ...shown);
  const { note } = energyWords(entry);
  const known = note ? [element('p', { class: 'known' }, note)] : [];
  const beside = besideWords(entry).map((part) => element('span', {}, part));
  const content = element('div', { class: `entry ${entry.status}` }, open, ...known);
  if (beside.length) content.append(element('p', { class: 'beside' }, ...beside));
  const label = element('label', { class: 'choose', title: 'Compare' }, choose, element('span', {}, 'Compare'));
  content.append(element('div', { class: 'tools' }, ...(entry.minimizer ? [label] : []), more));

  return {
    root: element('td', {}, element('p', { class: 'column only-narrow' }, functional), content),
    /** @param {State} state */
    update({ chosen, address }) {
      const isChosen = chosen.includes(id);
      choose.checked = isChosen;
      choose.disabled = !isChosen && chosen.length >= MOST;
      content.classList.toggle('chosen', isChosen);
      content.classList.toggle('beside-the-point', address.status !== '' && address.status !== entry.status);
    },
  };
}

/** A cell without an entry. */
export function emptyCell() {
  const root = element('td', { class: 'empty' });
  setText(root, '–');
  return root;
}
