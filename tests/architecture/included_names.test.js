// SPDX-License-Identifier: MIT
/**
 * @file Files include what they use, and the check fails on small trees whose files do not.
 */
import { describe, expect, test } from '@jest/globals';
import { missingIncludes } from './included_names.js';
import { readTree } from './tree.js';

test('the project includes what it uses', () => expect(missingIncludes(readTree())).toEqual([]));

/** @param {Record<string, string>} texts by file, relative to core/ */
const missing = (texts) =>
  missingIncludes(new Map(Object.entries(texts).map(([file, text]) => [`core/${file}`, text])));

describe('the check', () => {
  const header = '#include <vector>\nstruct Cage {\n};\nconstexpr int kLimit = 3;\nusing Faces = std::vector<int>;\n';

  test("finds a library's name without its header", () => {
    const uses = 'std::vector<int> faces;';
    expect(missing({ 'cage/a.cpp': uses })).toEqual(['core/cage/a.cpp uses std::vector without <vector>']);
    expect(missing({ 'cage/a.cpp': `#include <vector>\n${uses}` })).toEqual([]);
  });

  test('counts what headers of the project include, not what those of a library may', () => {
    const files = { 'cage/cage.h': header, 'cage/b.h': '#include "cage/cage.h"' };
    expect(missing({ ...files, 'cage/a.cpp': '#include "cage/b.h"\nstd::vector<int> faces;' })).toEqual([]);
    expect(missing({ 'cage/a.cpp': '#include <map>\nstd::vector<int> faces;' })).toHaveLength(1);
  });

  test.each(['Cage cage;', 'int limit = kLimit;', 'Faces faces;'])("finds the project's name in %s", (uses) => {
    const name = /Cage|kLimit|Faces/.exec(uses)?.[0];
    expect(missing({ 'cage/cage.h': header, 'mesh/a.cpp': uses })).toEqual([
      `core/mesh/a.cpp uses ${name} without "core/cage/cage.h"`,
    ]);
    expect(missing({ 'cage/cage.h': header, 'mesh/a.cpp': `#include "cage/cage.h"\n${uses}` })).toEqual([]);
  });

  test('leaves out comments, texts, members and what is only declared', () => {
    const file =
      'struct Cage;\nvoid show(const Cage&);\n// kLimit, std::map\nconst char* text = "Faces"; int x = a.kLimit;';
    expect(missing({ 'cage/cage.h': header, 'mesh/a.cpp': file })).toEqual([]);
  });
});
