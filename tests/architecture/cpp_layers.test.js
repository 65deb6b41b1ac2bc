// SPDX-License-Identifier: MIT
/**
 * @file The C++ layers pass all checks, and each check fails on a small tree that breaks its rule.
 */
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import {
  apiIncludes,
  hostLibraries,
  layers,
  linked,
  linkOrder,
  localeDependence,
  target,
  threadLocals,
  upwardIncludes,
} from './cpp_layers.js';
import { readTree, root } from './tree.js';

const tree = readTree();

describe('the project', () => {
  test('has C++ files in every layer', () => {
    for (const layer of layers) {
      expect(
        [...tree.keys()].filter((file) => file.startsWith(`core/${layer}/`) && /\.(h|cpp)$/.test(file)),
      ).not.toEqual([]);
    }
  });

  test('includes no layer below', () => expect(upwardIncludes(tree)).toEqual([]));
  test('has a C API on top of the driver', () => expect(apiIncludes(tree)).toEqual([]));
  test('keeps streams and files in the command line, and the library of JSON in few places', () =>
    expect(hostLibraries(tree)).toEqual([]));
  test('does not depend on the locale', () => expect(localeDependence(tree)).toEqual([]));
  test('has no variable for each thread', () => expect(threadLocals(tree)).toEqual([]));

  test('links each layer to the one above it', () => {
    const graph = 'build/architecture/graph.dot';
    const args = ['-S', '.', '-B', 'build/architecture', '-G', 'Ninja', `--graphviz=${graph}`];
    expect(spawnSync('cmake', args, { cwd: root, encoding: 'utf8' })).toMatchObject({ status: 0 });
    expect(linkOrder(readFileSync(path.join(root, graph), 'utf8'))).toEqual([]);
  });
});

describe('the checks fail on', () => {
  test.each([
    [
      'core/mesh/a.h',
      '#include "driver/run.h"',
      'core/mesh/a.h includes driver/run.h from a layer that is not above it',
    ],
    [
      'core/mesh/a.cpp',
      '  #  include <energy/x.h>',
      'core/mesh/a.cpp includes energy/x.h from a layer that is not above it',
    ],
    ['core/mesh/a.h', '#include <cage/cage.h>', 'core/mesh/a.h includes cage/cage.h with angle brackets'],
    ['core/mesh/a.h', '#include "b.h"', 'core/mesh/a.h includes "b.h", which is no path from core/'],
    [
      'core/mesh/a.h',
      '#include "../energy/b.h"',
      'core/mesh/a.h includes "../energy/b.h", which is no path from core/',
    ],
    ['core/a.h', '', 'core/a.h is in no layer'],
    ['core/tools/a.h', '', 'core/tools/a.h: tools is not a layer'],
    [
      'tests/core/cage/a_test.cpp',
      '#include "cli/a.h"',
      'tests/core/cage/a_test.cpp includes cli/a.h from a layer that is not above it',
    ],
    ...['cage', 'mesh', 'surface', 'energy'].map((layer) => [
      'core/solve/a.h',
      `#include "${layer}/b.h"`,
      `core/solve/a.h includes ${layer}/b.h from a layer that is not above it`,
    ]),
    ['core/energy/a.h', '#include "solve/b.h"', 'core/energy/a.h includes solve/b.h from a layer that is not above it'],
  ])('%s with %s', (file, text, problem) => {
    expect(upwardIncludes(new Map([[file, text]]))).toEqual([problem]);
  });

  test('a C API that knows the command line', () => {
    expect(apiIncludes(new Map([['wasm/api.cpp', '#include "cli/main.h"']]))).toEqual([
      'wasm/api.cpp includes cli/main.h',
    ]);
  });

  test.each(['iostream', 'fstream', 'sstream', 'filesystem', 'nlohmann/json.hpp', 'CLI/CLI.hpp'])(
    '%s in the core',
    (name) => {
      const text = `#include <${name}>`;
      expect(hostLibraries(new Map([['core/cage/a.h', text]]))).toEqual([`core/cage/a.h includes ${name}`]);
      expect(hostLibraries(new Map([['core/cli/a.h', text]]))).toEqual([]);
    },
  );

  test('JSON above the catalog, and files in it', () => {
    const host = (/** @type {string} */ file, /** @type {string} */ name) =>
      hostLibraries(new Map([[file, `#include <${name}>`]]));
    expect(host('core/catalog/a.h', 'nlohmann/json.hpp')).toEqual([]);
    expect(host('core/problem/json_node.cpp', 'nlohmann/json.hpp')).toEqual([]);
    expect(host('core/problem/a.h', 'nlohmann/json.hpp')).toHaveLength(1);
    expect(host('core/driver/a.h', 'nlohmann/json.hpp')).toHaveLength(1);
    expect(host('core/catalog/a.h', 'filesystem')).toHaveLength(1);
  });

  test('a number parsed by the locale, not one in a comment', () => {
    expect(localeDependence(new Map([['core/cage/a.cpp', 'double x = std::stod(s);']]))).toHaveLength(1);
    expect(localeDependence(new Map([['core/cage/a.cpp', '/* not std::stod(s) */ // strtod(s)\n"atof(";']]))).toEqual(
      [],
    );
  });

  test('a variable of each thread, not one in a comment', () => {
    expect(threadLocals(new Map([['core/base/a.cpp', 'thread_local int a;']]))).toHaveLength(1);
    expect(threadLocals(new Map([['core/base/a.cpp', '// thread_local int a;']]))).toEqual([]);
  });

  test('a layer that links another than the one above it', () => {
    const chain = Object.entries(linked).flatMap(([layer, above]) =>
      above.map((other) => `"a" -> "b"  // ${target(layer)} -> ${target(other)}`),
    );
    chain.push('// umbilic_api -> umbilic_driver', '// umbilic_base -> umbilic_settings');
    expect(linkOrder(chain.join('\n'))).toEqual([]);
    expect(linkOrder([...chain, '// umbilic_mesh -> umbilic_driver'].join('\n'))).toEqual([
      'umbilic_mesh links umbilic_cage, umbilic_driver, not umbilic_cage',
    ]);
    expect(linkOrder(chain.slice(1).join('\n'))).toEqual(['umbilic_cage links nothing, not umbilic_base']);
    expect(linkOrder([...chain, '// umbilic_solve -> umbilic_energy'].join('\n'))).toEqual([
      'umbilic_solve links umbilic_base, umbilic_energy, not umbilic_base',
    ]);

    const kernels = ['// umbilic_mesh -> umbilic_mesh_avx2', '// umbilic_mesh_avx2 -> umbilic_settings'];
    expect(linkOrder([...chain, ...kernels].join('\n'))).toEqual([]);
    expect(linkOrder([...chain, '// umbilic_mesh_avx2 -> umbilic_base'].join('\n'))).toEqual([
      'umbilic_mesh_avx2 links umbilic_base',
    ]);
  });
});
