// SPDX-License-Identifier: MIT
/**
 * @file Lines that ran are summed by room, and every room of the core stands in the table.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { linesOf, percentage, rows } from './coverage.js';
import { root } from './process.js';

const summary = {
  files: [
    { filename: 'core/cage/read_obj.cpp', line_total: 90, line_covered: 81 },
    { filename: 'core/cage/count.cpp', line_total: 10, line_covered: 0 },
    { filename: 'wasm/api.cpp', line_total: 100, line_covered: 100 },
  ],
};

test('the lines of a room are those of its files', () => {
  expect(linesOf(summary, /^core\/cage\//)).toEqual({ lines: 100, ran: 81 });
  expect(percentage(linesOf(summary, /^core\/cage\//))).toBe(81);
  expect(percentage(linesOf(summary, /^nowhere\//))).toBe(0);
});

test('a file of the readers counts with them and with its room', () => {
  const found = rows.filter(({ files }) => files.test('core/cage/read_obj.cpp')).map(({ name }) => name);
  expect(found).toEqual(['core/cage', 'the readers of files', 'the core']);
});

test('every room of the core is in the table', () => {
  const rooms = readdirSync(path.join(root, 'core'), { withFileTypes: true }).filter((entry) => entry.isDirectory());
  for (const { name } of rooms) expect(rows.map((row) => row.name)).toContain(`core/${name}`);
});
