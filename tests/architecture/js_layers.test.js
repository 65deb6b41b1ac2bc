// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript layers pass all checks, and each check fails on a small tree that breaks its rule.
 */
import { describe, expect, test } from '@jest/globals';
import { homeImports, memoryAccess, viewImports, wasmImports, webLayers } from './js_layers.js';
import { readTree } from './tree.js';

const tree = readTree();

describe('the project', () => {
  test('has views', () => expect([...tree.keys()].filter((file) => /^web\/views\/.*\.js$/.test(file))).not.toEqual([]));
  test('touches WebAssembly memory in one file', () => expect(memoryAccess(tree)).toEqual([]));
  test('loads the module in the worker only', () => expect(wasmImports(tree)).toEqual([]));
  test('keeps the worker out of the views', () => expect(viewImports(tree)).toEqual([]));
  test('imports from the layers above only', () => expect(webLayers(tree)).toEqual([]));
  test('has a home page that neither computes nor draws', () => expect(homeImports(tree)).toEqual([]));
});

describe('the checks fail on', () => {
  test.each([
    ['core.HEAPF64[0];', 'web/a.js uses HEAPF64'],
    ['new WebAssembly.Memory({ initial: 1 });', 'web/a.js uses WebAssembly'],
    ["import core from '../build/wasm/umbilic-core.mjs';", 'web/a.js names ../build/wasm/umbilic-core.mjs'],
    ["new URL('../build/wasm/umbilic-core.wasm', import.meta.url);", 'web/a.js names ../build/wasm/umbilic-core.wasm'],
    ["import('../build/wasm/umbilic-core-threads.mjs');", 'web/a.js names ../build/wasm/umbilic-core-threads.mjs'],
  ])('%s outside the file that owns the memory', (text, problem) => {
    expect(memoryAccess(new Map([['web/a.js', text]]))).toEqual([problem]);
    expect(memoryAccess(new Map([['wasm/memory.js', text]]))).toEqual([]);
    expect(memoryAccess(new Map([['web/a.js', `// ${text}`]]))).toEqual([]);
  });

  const worker = /** @type {[string, string]} */ (['web/worker/w.js', "import { load } from '../../wasm/umbilic.js';"]);

  test.each([
    "import { load } from '../wasm/umbilic.js';",
    "export * from '../wasm/umbilic.js';",
    "import('../wasm/umbilic.js');",
    "new URL('../wasm/umbilic.js', import.meta.url);",
  ])('%s outside the worker', (text) => {
    expect(wasmImports(new Map([worker, ['web/a.js', text]]))).toEqual(['web/a.js imports from wasm/']);
    expect(wasmImports(new Map([worker]))).toEqual([]);
  });

  test('a worker that goes around the gateway', () => {
    expect(wasmImports(new Map([['web/worker/w.js', '']]))).toEqual(['no file of web/worker/ imports wasm/umbilic.js']);
  });

  test.each(['../worker/client.js', '../../wasm/types.js'])('a view that imports %s', (name) => {
    expect(viewImports(new Map([['web/views/a.js', `import { x } from '${name}';`]]))).toHaveLength(1);
    expect(viewImports(new Map([['web/studio.js', `import { x } from '${name}';`]]))).toEqual([]);
  });

  test('a view of a page that imports the worker', () => {
    const file = 'web/pages/catalog/views/a.js';
    expect(viewImports(new Map([[file, "import { x } from '../../../worker/client.js';"]]))).toHaveLength(1);
  });

  test.each([
    ['web/pages/one/state/a.js', '../../../views/dom.js', 'views/dom.js'],
    ['web/address/a.js', '../pages/one/state/reduce.js', 'pages/one/state/reduce.js'],
    ['web/words/a.js', '../files/save.js', 'files/save.js'],
    ['web/pages/one/state/a.js', '../../../worker/client.js', 'worker/client.js'],
    ['web/pages/one/state/a.js', '../effects.js', 'pages/one/effects.js'],
    ['web/views/a.js', '../pages/one/reduce.js', 'pages/one/reduce.js'],
    ['web/pages/one/a.js', '../two/reduce.js', 'pages/two/reduce.js'],
    ['web/pages/one/a.js', './views/plot.js', 'pages/one/views/plot.js'],
    ['web/pages/one/views/a.js', '../../two/state/reduce.js', 'pages/two/state/reduce.js'],
  ])('%s that imports %s', (file, name, found) => {
    const text = `import { x } from '${name}';`;
    expect(webLayers(new Map([[file, text]]))).toEqual([`${file} imports ${found}`]);
    expect(webLayers(new Map([['web/a.js', text]]))).toEqual([]);
  });

  test('a folder that is in no layer', () => {
    expect(webLayers(new Map([['web/misc/a.js', '']]))).toEqual(['web/misc/a.js is in no layer']);
  });

  test('a home page that loads three.js through another file, unless it waits until it is asked', () => {
    const between = /** @type {[string, string]} */ (['web/files/b.js', "import { Mesh } from 'three';"]);
    expect(homeImports(new Map([['web/index.js', "import { x } from './files/b.js';"], between]))).toEqual([
      'web/files/b.js imports three',
    ]);
    expect(homeImports(new Map([['web/index.js', "import('./files/b.js');"], between]))).toEqual([]);
  });
});
