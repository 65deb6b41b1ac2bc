// SPDX-License-Identifier: MIT
/**
 * @file The JavaScript layers hold, and each of their checks fails on a small tree that breaks it.
 */
import { describe, expect, test } from '@jest/globals';
import { homeImports, memoryAccess, pageImports, viewImports, wasmImports } from './js_layers.js';
import { readTree } from './tree.js';

const tree = readTree();

describe('the project', () => {
  test('has views', () => expect([...tree.keys()].filter((file) => /^web\/views\/.*\.js$/.test(file))).not.toEqual([]));
  test('touches WebAssembly memory in one file', () => expect(memoryAccess(tree)).toEqual([]));
  test('loads the module in the worker only', () => expect(wasmImports(tree)).toEqual([]));
  test('keeps the worker out of the views', () => expect(viewImports(tree)).toEqual([]));
  test('keeps its pages apart', () => expect(pageImports(tree)).toEqual([]));
  test('has a home page that neither computes nor draws', () => expect(homeImports(tree)).toEqual([]));
});

describe('the checks fail on', () => {
  test.each([
    ['core.HEAPF64[0];', 'web/a.js uses HEAPF64'],
    ['new WebAssembly.Memory({ initial: 1 });', 'web/a.js uses WebAssembly'],
    ["import core from '../build/wasm/umbilic-core.mjs';", 'web/a.js names ../build/wasm/umbilic-core.mjs'],
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

  test('a page that imports another, and what is shared that imports a page', () => {
    const text = "import { x } from '../torus/reduce.js';";
    expect(pageImports(new Map([['web/pages/catalog/a.js', text]]))).toEqual([
      'web/pages/catalog/a.js imports web/pages/torus/reduce.js',
    ]);
    expect(pageImports(new Map([['web/pages/torus/a.js', text]]))).toEqual([]);
    expect(pageImports(new Map([['web/views/a.js', "import { x } from '../pages/torus/a.js';"]]))).toHaveLength(1);
    expect(pageImports(new Map([['web/torus.js', "import { x } from './pages/torus/a.js';"]]))).toEqual([]);
  });

  test('a home page that loads three.js through another file, unless it waits until it is asked', () => {
    const between = /** @type {[string, string]} */ (['web/files/b.js', "import { Mesh } from 'three';"]);
    expect(homeImports(new Map([['web/index.js', "import { x } from './files/b.js';"], between]))).toEqual([
      'web/files/b.js imports three',
    ]);
    expect(homeImports(new Map([['web/index.js', "import('./files/b.js');"], between]))).toEqual([]);
  });
});
