// SPDX-License-Identifier: MIT
/**
 * @file Code for an instruction set stays in its namespace, and the checks fail on code that does not.
 */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { instructionSets, kernelIncludes, sharedFunctions } from './instruction_sets.js';
import { readTree, root } from './tree.js';

const build = path.join(root, 'build/native');
const cache = path.join(build, 'CMakeCache.txt');
const built = existsSync(cache) && /^UMBILIC_X86_KERNELS:INTERNAL=1$/m.test(readFileSync(cache, 'utf8'));

/** @param {string} set @returns {string[]} the objects compiled for it */
const objects = (set) =>
  ['core', 'tests'].flatMap((folder) =>
    readdirSync(path.join(build, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => name.includes(`_${set}.dir/`) && name.endsWith('.o') && !name.includes('sanitized'))
      .map((name) => path.join(build, folder, name)),
  );

/** @param {string} set */
const listing = (set) => execFileSync('nm', ['--demangle', '--defined-only', ...objects(set)], { encoding: 'utf8' });

describe('the project', () => {
  (built ? test.each(instructionSets) : test.skip.each(instructionSets))(
    'shares no function compiled for %s',
    (set) => {
      const kernels = readdirSync(path.join(root, 'core'), { recursive: true, encoding: 'utf8' }).filter((name) =>
        /\/kernels\/\w+\.cpp$/.test(name),
      );
      expect(objects(set).length).toBeGreaterThanOrEqual(kernels.length);
      expect(listing(set)).toMatch(`umbilic::${set}::`);
      expect(sharedFunctions(set, listing(set))).toEqual([]);
    },
  );

  test('has kernels without libraries', () => expect(kernelIncludes(readTree())).toEqual([]));
});

describe('the checks fail on', () => {
  test('a weak function of another namespace, not on one of its own, a local or a strong one', () => {
    const weak = '0000000000000000 W double const& std::max<double>(double const&, double const&)';
    const own = '0000000000000000 W umbilic::avx2::Vec3<double> umbilic::avx2::cross<double>()';
    const others = '0000000000000010 t helper\n0000000000000020 T umbilic::avx512::integrate()\n';
    expect(sharedFunctions('avx2', `${own}\n${weak}\n${others}`)).toEqual([weak.slice(19)]);
    expect(sharedFunctions('avx512', own)).toEqual([own.slice(19)]);
  });

  test('a library behind a header that kernels include', () => {
    const files = new Map([
      ['core/mesh/kernels/a.cpp', '#include "mesh/a.h"\n#include <cstddef>'],
      ['core/mesh/a.h', '#include <algorithm>'],
      ['core/mesh/b.h', '#include <vector>'],
    ]);
    expect(kernelIncludes(files)).toEqual(['core/mesh/a.h, which kernels include, includes <algorithm>']);
  });
});
