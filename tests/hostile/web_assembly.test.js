// SPDX-License-Identifier: MIT
/**
 * @file Every file in the tables of hostile inputs ends in WebAssembly as it says, within its time and memory.
 */
import { beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../wasm/umbilic.js';
import { limits } from './row.js';
import { families } from './rows.js';
import { faults } from './verdict.js';
import { runInWebAssembly } from './web_assembly.js';

/** @typedef {import('./web_assembly.js').FileRow} FileRow */

let before = 0;
beforeAll(async () => {
  await load();
  before = process.memoryUsage.rss();
});

describe.each(families)('%s', (_, rows) => {
  const files = /** @type {FileRow[]} */ (rows.filter(({ kind }) => kind !== 'command'));
  if (files.length) test.each(files)('$name', (row) => expect(faults(row, runInWebAssembly(row))).toEqual([]));
});

// The module's memory never shrinks: what one row took, the process still has.
test('all together take less memory than one may', () => {
  expect((process.memoryUsage.rss() - before) / 2 ** 20).toBeLessThan(limits.megabytes);
});
