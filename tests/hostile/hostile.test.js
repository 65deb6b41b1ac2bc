// SPDX-License-Identifier: MIT
/**
 * @file Every row of the tables of hostile inputs ends as it says, natively and in WebAssembly, within its time and memory.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { load } from '../../wasm/umbilic.js';
import { scratchFolder } from '../cli/program.js';
import { runNatively } from './native.js';
import { limits } from './row.js';
import { families } from './rows.js';
import { faults } from './verdict.js';
import { runInWebAssembly } from './web_assembly.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

/** @typedef {import('./web_assembly.js').FileRow} FileRow */

const all = families.flatMap(([, rows]) => rows);

describe('the tables', () => {
  test('are long, and name each row once', () => {
    expect(all.length).toBeGreaterThanOrEqual(250);
    const names = all.map(({ kind, name }) => `${kind} ${name}`);
    expect(names.filter((name, i) => names.indexOf(name) < i)).toEqual([]);
  });

  test('expect words of every row', () => {
    expect(all.filter(({ says }) => says.length < 4)).toEqual([]);
  });

  test('are judged: a row that ends otherwise, says something else, or takes too long is found', () => {
    const row = all[0];
    const right = { outcome: row.outcome, said: row.says, seconds: 0 };
    expect(faults(row, right)).toEqual([]);
    const wrong = [{ outcome: 'minimized' }, { said: 'nothing' }, { said: `${row.says}\u001b[2J` }, { seconds: 11 }];
    for (const change of wrong) expect(faults(row, { ...right, ...change })).toHaveLength(1);
  });
});

describe.each(families)('%s, natively', (_, rows) => {
  test.each(rows)('$name', (row) => expect(faults(row, runNatively(row, scratch.folder))).toEqual([]));
});

describe('in WebAssembly', () => {
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
});
