// SPDX-License-Identifier: MIT
/**
 * @file A trap of the module reaches JavaScript as an error with words, and so does every call after it.
 */
import { expect, test } from '@jest/globals';
import { call, plainCall } from '../../wasm/memory.js';
import { Cage, Minimizer, cageNames, load } from '../../wasm/umbilic.js';

test('before the module is loaded every call says so', () => {
  expect(() => cageNames()).toThrow('umbilic is not loaded: await load() first');
  expect(() => new Cage({ generator: 'cube' })).toThrow('umbilic is not loaded');
});

test('a handle that is none traps; the module says why, takes no more calls, and lets go without a word', async () => {
  await load();
  const cage = new Cage({ generator: 'cube' });
  const minimizer = new Minimizer({ cage: cage.input, terms: { bending: 1 } });
  const nowhere = 0x7ffffff0; // beyond the memory
  const words = /^the core has broken off and takes no more calls: .*out of bounds/;
  expect(() => call('run_step', nowhere, 1, 8)).toThrow(words);
  for (const use of [
    () => minimizer.step(1),
    () => minimizer.progress,
    () => cage.obj(),
    () => new Cage({ generator: 'cube' }),
    () => plainCall('version'),
  ]) {
    expect(use).toThrow(words);
    expect(use).toThrow(Error);
  }
  minimizer.dispose();
  cage.dispose();
});
