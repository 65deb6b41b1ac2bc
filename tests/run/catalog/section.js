// SPDX-License-Identifier: MIT
/**
 * @file The catalog's tables and sentences as Markdown.
 */
import { catalogTables } from '../../../web/words/catalog_tables.js';
import { markdownTable } from '../bench/tables.js';

/** @param {import('../../../web/words/catalog_tables.js').Catalog} catalog @returns {string} Markdown */
export function catalogSection(catalog) {
  const parts = catalogTables(catalog).map((part) => (typeof part === 'string' ? `${part}\n` : markdownTable(part)));
  return parts.join('\n');
}
