// SPDX-License-Identifier: MIT
/**
 * @file The catalog's tables as HTML, which the build puts into the page of methods.
 */
import { catalogTables } from '../../words/catalog_tables.js';

/** @import {Catalog, Table} from '../../words/catalog_tables.js' */

/** @param {string} text */
const escaped = (text) => text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`);

/** Names in backquotes are set as code. @param {string} text */
const worded = (text) => escaped(text).replace(/`([^`]*)`/g, '<code>$1</code>');

/** Whether a cell is a number, which stands at the right. @param {string | number} cell */
const isNumber = (cell) => /^[≤→+−\d][\s\d.]*|^$/.test(String(cell)) && !/[a-z]{2}/.test(String(cell));

/** @param {Table} table */
function tableHtml({ title, head, rows }) {
  const numbers = head.map((_, i) => rows.every((row) => isNumber(row[i])));
  const aligned = (/** @type {number} */ i) => (numbers[i] ? ' class="number"' : '');
  const heads = head.map((cell, i) => `<th scope="col"${aligned(i)}>${worded(cell)}</th>`).join('');
  const line = (/** @type {(string | number)[]} */ row) =>
    `<tr>${row.map((cell, i) => `<td${aligned(i)}>${worded(String(cell))}</td>`).join('')}</tr>`;
  const label = escaped(title.replace(/[`:]/g, ''));
  return (
    `<p>${worded(title)}</p>\n<div class="scroll" role="region" tabindex="0" aria-label="${label}">` +
    `<table><thead><tr>${heads}</tr></thead><tbody>${rows.map(line).join('\n')}</tbody></table></div>`
  );
}

/** @param {Catalog} catalog @returns {string} HTML */
export function tablesHtml(catalog) {
  return catalogTables(catalog)
    .map((part) => (typeof part === 'string' ? `<p>${worded(part)}</p>` : tableHtml(part)))
    .join('\n');
}
