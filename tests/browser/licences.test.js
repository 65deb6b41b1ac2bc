// SPDX-License-Identifier: MIT
/**
 * @file The notices of others' code that the built page and the package pass on. No browser is needed, but the built page.
 */
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { includes } from '../architecture/cpp_layers.js';
import { imports } from '../architecture/js_layers.js';
import { matching, readTree, root } from '../architecture/tree.js';
import { libraries, moduleNotices, packageNotices, stanzasOf } from '../run/licences.js';

const files = readTree();
const site = path.join(root, 'build/web');
const served = readFileSync(path.join(site, 'licences.txt'), 'utf8');

/** The names that head the notices. @param {string} text */
const named = (text) =>
  [...text.matchAll(/^={80}\n(.*)\nLicence: .+\nSource: \S*https:\S+\n={80}$/gm)].map(([, name]) => name);

describe('the notices', () => {
  test('are about every library that the core includes, and no other', () => {
    const sources = matching(files, /^(core\/(?!cli\/)|wasm\/).*\.(cpp|h)$/);
    const foreign = [
      ...new Set(sources.flatMap(([, text]) => includes(text).flatMap((one) => (one.quoted ? [] : one.name)))),
    ];
    expect(foreign.filter((header) => !libraries.some(({ headers }) => headers.test(header)))).toEqual([]);
    for (const { name, headers } of libraries) {
      expect({ name, used: foreign.some((header) => headers.test(header)) }).toEqual({ name, used: true });
    }
    expect(named(moduleNotices())).toEqual(libraries.map(({ name }) => name));
  });

  test('of the page are also about every package that its modules import', () => {
    const modules = matching(files, /^web\/(?!\w+\.config).*\.js$/);
    const names = modules
      .flatMap(([file, text]) => imports(file, text))
      .filter((name) => /^(@|[a-z])[^:]*$/.test(name));
    const packages = new Set(
      names
        .filter((name) => !files.has(name) && !/^(web|wasm|build|tests)\//.test(name))
        .map((name) => name.split('/')[name.startsWith('@') ? 1 : 0]),
    );
    expect([...packages]).toContain('three');
    expect(named(served).sort()).toEqual([...libraries.map(({ name }) => name), ...packages].sort());
  });

  test('of the page begin with those of the module, which the package contains', () => {
    expect(served.startsWith(readFileSync(path.join(root, 'build/wasm/licences.txt'), 'utf8'))).toBe(true);
    expect(readFileSync(path.join(root, 'build/wasm/licences.txt'), 'utf8')).toBe(moduleNotices());
  });

  test('hold what the licences ask to be passed on', () => {
    for (const words of [
      'Mozilla Public License Version 2.0',
      'Victor Zverovich',
      'Niels Lohmann',
      'fast_float',
      'Rich Felker',
      'LLVM',
      'three.js authors',
      'Jake Archibald',
    ]) {
      expect(served).toContain(words);
    }
    expect(served.match(/Permission is hereby granted, free of charge/g)?.length).toBeGreaterThanOrEqual(4);
    expect(served).toMatch(/Permission to use, copy, modify, and\/or distribute this software/); // idb
  });

  test('are linked from the studio, to a file that is there', () => {
    expect(readFileSync(path.join(site, 'studio.html'), 'utf8')).toContain('href="./licences.txt"');
    expect(readdirSync(site)).toContain('licences.txt');
  });
});

describe('a copyright file', () => {
  const text =
    'Format: x\n\nFiles: a/*\n b/*\nLicense: L or M\n\nFiles: c/*\nLicense: N\n\nLicense: L\n l\n\nLicense: M\n m\n\nLicense: N\n n\n';

  test('is cut to what it says of some files', () => {
    expect(stanzasOf(text, /^b\//)).toBe('Files: a/*\n b/*\nLicense: L or M\n\nLicense: L\n l\n\nLicense: M\n m');
    expect(() => stanzasOf(text, /^d\//)).toThrow('no stanza about');
  });

  test('that a package does not have stops the build', () => {
    expect(() => packageNotices([path.join(root, 'node_modules/missing/index.js')])).toThrow('does not exist');
    expect(packageNotices([path.join(root, 'web/index.js')])).toBe('');
  });
});
