// SPDX-License-Identifier: MIT
/**
 * @file The catalog's tables as HTML: the page of methods has each table and sentence of the Markdown.
 */
import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { tablesHtml } from '../../../web/pages/methods/tables.js';
import { catalogTables } from '../../../web/words/catalog_tables.js';

const text = readFileSync(new URL('../../../web/catalog/catalog.json', import.meta.url), 'utf8');
const catalog = JSON.parse(text);
const html = tablesHtml(catalog);

/** What is between tags, as a reader sees it. @param {string} part */
const read = (part) =>
  part.replace(/<[^>]*>/g, '').replace(/&#(\d+);/g, (_, code) => String.fromCharCode(Number(code)));

describe('the tables', () => {
  const parts = catalogTables(catalog);
  const tables = parts.filter((part) => typeof part !== 'string');

  test('are all there, with every cell in its place', () => {
    const found = [...html.matchAll(/<table>(.*?)<\/table>/gs)].map(([, inner]) =>
      [...inner.matchAll(/<tr>(.*?)<\/tr>/gs)].map(([, row]) =>
        [...row.matchAll(/<t[hd][^>]*>(.*?)<\/t[hd]>/gs)].map(([, cell]) => read(cell)),
      ),
    );
    const plain = (/** @type {string | number} */ cell) => String(cell).replaceAll('`', '');
    expect(found).toEqual(tables.map(({ head, rows }) => [head, ...rows].map((row) => row.map(plain))));
    expect(found.length).toBeGreaterThanOrEqual(10);
  });

  test('stand between the sentences', () => {
    const sentences = parts.filter((part) => typeof part === 'string');
    expect(sentences.length).toBeGreaterThan(0);
    for (const sentence of sentences) expect(read(html)).toContain(sentence.replaceAll('`', ''));
  });

  test('have names for readers who do not see them, no two the same', () => {
    const names = [...html.matchAll(/aria-label="([^"]*)"/g)].map(([, name]) => name);
    expect(new Set(names).size).toBe(tables.length);
  });

  test('set energies at the right and names at the left', () => {
    expect(html).toContain('<td class="number">112.7655 ± 0.0019</td>');
    expect(html).toContain('<td>two-3</td>');
    expect(html).toContain('<td>D3h</td>');
  });
});

test('what a name could do to the page is escaped', () => {
  const shapes = [{ name: 'a<b>&"c', genus: 2, junctions: 2, arms: 3 }];
  const start = { shape: shapes[0].name, functional: 'bending', thickness: 1, energy: 1, level: 3, stop: 'converged' };
  const small = tablesHtml({ shapes, functionals: [], entries: [], starts: [start] });
  expect(small).not.toContain('a<b>');
  expect(read(small)).toContain('a<b>&"c');
});
