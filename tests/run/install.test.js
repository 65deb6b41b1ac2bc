// SPDX-License-Identifier: MIT
/**
 * @file What a build needs is installed for it: `npm start` builds for WebAssembly alone, on a machine that may have
 * nothing else.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { tools } from './install.js';
import { root } from './process.js';

test('the headers that the WebAssembly build takes from the system are installed for it', () => {
  const text = readFileSync(path.join(root, 'core/CMakeLists.txt'), 'utf8');
  const headers = [...text.matchAll(/^\s*umbilic_find_headers\((\w+) ([\w.]+)\)/gm)].map(
    ([, name, file]) => `${name}/${file}`,
  );
  expect(headers).toEqual(expect.arrayContaining(['fmt/format.h', 'nlohmann/json.hpp']));
  for (const header of headers) {
    expect(tools).toContainEqual(expect.objectContaining({ header, needs: expect.arrayContaining(['wasm']) }));
  }
});
