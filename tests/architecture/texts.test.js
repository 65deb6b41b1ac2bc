// SPDX-License-Identifier: MIT
/**
 * @file All texts of the project pass the checks, and each check fails on a small tree that breaks its rule.
 */
import { describe, expect, test } from '@jest/globals';
import { machines, openings } from './texts.js';
import { readTree } from './tree.js';

const tree = readTree();

describe('the project', () => {
  test('opens each source file with its licence and its sentence', () => expect(openings(tree)).toEqual([]));
  test('names no machine', () => expect(machines(tree)).toEqual([]));
});

describe('the checks fail on', () => {
  const licence = '// SPDX-License-Identifier: MIT\n';

  test.each([
    ['a.h', '#pragma once\n', 'a.h does not open with the SPDX line'],
    ['a.h', `${licence}#pragma once\n`, 'a.h does not say what it owns'],
    ['a.cpp', `${licence}/// \\file\n\nint x;\n`, 'a.cpp does not say what it owns'],
    ['a.js', `${licence}/** Adds. */\nfunction f() {}\n`, 'a.js does not say what it owns'],
    ['a/CMakeLists.txt', 'add_library(a)\n', 'a/CMakeLists.txt does not open with the SPDX line and what it owns'],
  ])('%s: %j', (file, text, problem) => expect(openings(new Map([[file, text]]))).toEqual([problem]));

  test.each([
    ['a.h', `${licence}/// \\file\n/// Owns a.\n`],
    ['a.h', '/* SPDX-License-Identifier: MIT */\n/**\n * \\file\n * Owns a.\n */\n'],
    ['a.js', `${licence}/**\n * @file Owns a.\n */\n`],
    ['a.js', `${licence}/** @file Owns a. */\n`],
    ['CMakeLists.txt', '# SPDX-License-Identifier: MIT\n# Owns a.\n'],
  ])('but not on %s: %j', (file, text) => expect(openings(new Map([[file, text]]))).toEqual([]));

  // Put together here, so that this file does not break the rule itself.
  test.each([
    ['/home', 'somebody'].join('/'),
    `see ${['', 'work', 'main'].join('/')}`,
    `https://${['registry', 'somewhere', 'org'].join('.')}/three`,
  ])('%s', (text) => expect(machines(new Map([['a.md', text]]))).toHaveLength(1));

  test('a lock file with addresses', () => {
    expect(machines(new Map([['package-lock.json', '{"resolved": "x"}']]))).toHaveLength(1);
  });
});
