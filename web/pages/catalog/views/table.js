// SPDX-License-Identifier: MIT
/**
 * @file The table: a row for each shape and a column for each functional, as in the paper's Table 1. Column heads sort
 * the rows.
 */
import { counted } from '../../../words/numbers.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { groupSymbol } from '../../../views/group.js';
import { allRows, groupOf, visibleRows } from '../select.js';
import { boundaryWords, columnWords, junctionWords, shapeTitle } from '../../../words/entries.js';
import { createCell, emptyCell } from './cell.js';

/** @import {Catalog} from '../../../files/catalog.js' */
/** @import {Action, Row, State} from '../types.js' */

/**
 * @param {string} key what a press on the head sorts by
 * @param {string} name
 * @param {string} [formula]
 * @param {Record<string, string>} [attributes]
 */
function head(key, name, formula, attributes = {}) {
  const button = element('button', { type: 'button', 'data-key': key }, name);
  const cell = element('th', { scope: 'col', 'data-key': key, ...attributes }, button);
  if (formula) cell.append(element('span', { class: 'formula' }, formula));
  return cell;
}

/** @param {Row} row @param {Catalog} catalog @param {(action: Action) => void} dispatch */
function createRow(row, { functionals }, dispatch) {
  const { shape, entries } = row;
  const title = shapeTitle(shape.name);
  const group = groupOf(row);
  const facts = [
    element('span', { class: 'only-narrow' }, shape.sides ? 'open' : `genus ${shape.genus}`),
    element('span', {}, junctionWords(shape) || boundaryWords(shape)),
    element('span', {}, ...(group ? [...groupSymbol(group.name), `, order ${group.order}`] : [])),
  ];
  const name = element('th', { scope: 'row' }, element('strong', {}, title), ...facts);
  const columns = functionals.map((functional) => columnWords(functional).name);
  const cells = entries.map((entry, i) => entry && createCell(entry, title, columns[i], dispatch));
  return {
    name: shape.name,
    root: element(
      'tr',
      { 'data-shape': shape.name },
      name,
      element('td', { class: 'genus' }, String(shape.genus), ...(shape.sides ? [element('span', {}, 'open')] : [])),
      ...cells.map((cell) => cell?.root ?? emptyCell()),
    ),
    /** @param {State} state */
    update: (state) => cells.forEach((cell) => cell?.update(state)),
  };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createTableView(root, dispatch) {
  const heads = element('tr');
  const body = element('tbody');
  const caption = element('caption', { class: 'hidden' });
  const table = element('table', { class: 'minimizers' }, caption, element('thead', {}, heads), body);
  const note = element('p', { class: 'note', role: 'status' }, 'Loading …');
  root.append(table, note);
  table.hidden = true;
  heads.addEventListener('click', ({ target }) => {
    const key = target instanceof HTMLButtonElement ? target.dataset.key : undefined;
    if (key) dispatch({ type: 'sortPressed', key });
  });

  /** @type {ReturnType<typeof createRow>[]} */
  let rows = [];
  const fill = whenChanged((/** @type {Catalog} */ catalog) => {
    heads.replaceChildren(
      head('shape', 'Shape', undefined, { class: 'shape' }),
      head('genus', 'Genus', undefined, { class: 'genus' }),
      ...catalog.functionals.map((functional) => {
        const { name, formula } = columnWords(functional);
        return head(functional.name, name, formula);
      }),
    );
    rows = allRows(catalog).map((row) => createRow(row, catalog, dispatch));
    setText(
      caption,
      `Minimizers: ${counted(catalog.shapes.length, 'shape')} by ${counted(catalog.functionals.length, 'functional')}`,
    );
    table.hidden = false;
  });

  const order = whenChanged((/** @type {string} */ names) => {
    const byName = new Map(rows.map((row) => [row.name, row.root]));
    body.replaceChildren(...names.split(' ').flatMap((name) => byName.get(name) ?? []));
  });

  const mark = whenChanged((/** @type {string} */ key, /** @type {'asc' | 'desc'} */ direction) => {
    for (const cell of heads.children) cell.removeAttribute('aria-sort');
    heads
      .querySelector(`th[data-key="${CSS.escape(key)}"]`)
      ?.setAttribute('aria-sort', direction === 'asc' ? 'ascending' : 'descending');
  });

  return {
    /** @param {State} state */
    update(state) {
      if (!state.catalog) {
        if (state.problem) setText(note, state.problem);
        return;
      }
      fill(state.catalog);
      const visible = visibleRows(state);
      order(visible.map(({ shape }) => shape.name).join(' '));
      mark(state.address.sort, state.address.direction);
      for (const row of rows) row.update(state);
      setText(note, visible.length ? '' : 'No shape is like that.');
      find(root, 'thead').hidden = !visible.length;
    },
    dispose: () => root.replaceChildren(),
  };
}
