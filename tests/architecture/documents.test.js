// SPDX-License-Identifier: MIT
/**
 * @file The project's Markdown passes the checks, and each check fails on a small tree that breaks its rule.
 */
import { existsSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { anchorOf, links, namedFiles, quotedRows } from './documents.js';
import { readTree, root } from './tree.js';

const tree = readTree();
const exists = (/** @type {string} */ name) => existsSync(path.join(root, name));

describe('the project', () => {
  test('links to what is there', () => {
    const count = [...tree].filter(([name]) => name.endsWith('.md')).length;
    expect(count).toBeGreaterThanOrEqual(8);
    expect(links(tree, exists)).toEqual([]);
  });
  test('names files that are there', () => expect(namedFiles(tree, exists)).toEqual([]));
  test('has in its README the numbers of its tables', () => {
    expect(quotedRows(tree, [])).not.toEqual([]);
    expect(quotedRows(tree, ['web/catalog/README.md', 'tests/bench/README.md'])).toEqual([]);
  });
});

test('the worked example of a functional is what its test compiles', () => {
  const [, example] = /```cpp\n([\s\S]*?)```/.exec(tree.get('core/energy/README.md') ?? '') ?? [];
  expect(example).toContain('T deviation_density');
  expect(tree.get('tests/core/energy/added_functional_test.cpp')).toContain(example);
});

describe('the checks', () => {
  /** @param {Record<string, string>} texts */
  const small = (texts) => new Map(Object.entries(texts));
  /** @param {Record<string, string>} texts */
  const linksOf = (texts) => links(small(texts), (name) => name in texts);

  test('fail on links to nowhere', () => {
    const b = '# One `two`, three?\n\n```\n# code\n```\n';
    expect(
      linksOf({ 'a/a.md': '[b](../b.md#one-two-three) ![c](c.png) [d](#d)\n# D', 'b.md': b, 'a/c.png': '' }),
    ).toEqual([]);
    expect(linksOf({ 'a/a.md': '[b](b.md)', 'b.md': b })).toEqual(['a/a.md links to a/b.md, which is not there']);
    for (const anchor of ['one', 'code'])
      expect(linksOf({ 'a.md': `[b](b.md#${anchor})`, 'b.md': b })).toEqual([
        `a.md links to ${anchor} in b.md, which has no such heading`,
      ]);
    expect(linksOf({ 'a.md': '```\n[x](y)\n```\n[z](https://example.org/z)' })).toEqual([]);
    expect(linksOf({ 'a.md': '[p](p.html#part) [p](p.html#no)', 'p.html': '<h2 id="part">' })).toHaveLength(1);
  });

  test('know how headings become anchors', () => {
    expect(anchorOf('What "converged" means')).toBe('what-converged-means');
    expect(anchorOf('[`cage`](x), and κ₁ of_it')).toBe('cage-and-κ₁-of_it');
  });

  test('fail on names of files that are not there', () => {
    const files = small({ 'a.md': 'see `core/b.h`, `core/none.h` and `a/b`' });
    expect(namedFiles(files, (name) => name === 'core/b.h')).toEqual(['a.md names core/none.h, which is not there']);
  });

  test('fail on rows that are out of date', () => {
    const files = small({
      'README.md': '| a | b |\n| x | 1.25 |\n| y | 2.5 |\n',
      't.md': '| x | 1.25 |\n| y | 2.6 |\n',
    });
    expect(quotedRows(files, ['t.md'])).toEqual(['README.md has a row that no generated table has: | y | 2.5 |']);
  });
});
