// SPDX-License-Identifier: MIT
/**
 * @file The glossary's terms: each once, in plain sentences, and all that pages and views link to.
 */
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@jest/globals';
import { glossary, termWords } from '../../web/words/glossary.js';

const web = fileURLToPath(new URL('../../web/', import.meta.url));

test('every term is explained once, in one or two sentences or three short ones, in alphabetical order', () => {
  expect(new Set(glossary.map(({ id }) => id)).size).toBe(glossary.length);
  const names = glossary.map(({ name }) => name.replace('τ (tau)', 'tau').toLowerCase());
  expect(names).toEqual([...names].sort());
  for (const { words } of glossary) {
    expect(words).toMatch(/^[^.].*\.$/);
    expect(words.split(/\.\s/).length).toBeLessThanOrEqual(3);
    expect(words.length).toBeLessThan(240);
  }
  expect(() => termWords('nothing')).toThrow('no nothing');
});

test('every term that a page or a view links to is in it', () => {
  const views = ['views', 'pages'].flatMap((folder) =>
    readdirSync(path.join(web, folder), { recursive: true, encoding: 'utf8' }).map((name) => path.join(folder, name)),
  );
  const files = [...readdirSync(web), ...views].filter((name) => /\.(html|js)$/.test(name));
  const linked = files.flatMap((name) =>
    [...readFileSync(path.join(web, name), 'utf8').matchAll(/data-term="([^"]+)"|termButton\('([^']+)'/g)].map(
      ([, inPage, inView]) => inPage ?? inView,
    ),
  );
  expect(linked.length).toBeGreaterThan(15);
  const known = new Set(glossary.map(({ id }) => id));
  expect(linked.filter((id) => !known.has(id))).toEqual([]);
});
