// SPDX-License-Identifier: MIT
/**
 * @file Every row of the tables of hostile inputs ends in the program as it says, within its time and memory.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { scratchFolder } from '../cli/program.js';
import { runNatively } from './native.js';
import { families } from './rows.js';
import { faults } from './verdict.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

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

describe.each(families)('%s', (_, rows) => {
  test.each(rows)('$name', (row) => expect(faults(row, runNatively(row, scratch.folder))).toEqual([]));
});
