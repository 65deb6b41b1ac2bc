// SPDX-License-Identifier: MIT
/**
 * @file A short sample of the faults of `npm run faults`: each ends as it should.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { SHORT, injectFaults } from '../run/faults.js';

/** @type {import('../run/faults/row.js').Row[]} */
const rows = [];

// The shim and the counted allocations are of glibc.
const possible = process.platform === 'linux';

beforeAll(async () => {
  if (possible) await injectFaults(SHORT, (row) => rows.push(row));
}, 120_000);

(possible ? test : test.skip)('memory, writes and clocks that fail do no harm', () => {
  expect(rows.flatMap(({ fault, wrong }) => wrong.map((what) => `${fault}: ${what}`))).toEqual([]);
  for (const { fault, positions } of rows) expect({ fault, some: positions > 0 }).toEqual({ fault, some: true });
  expect(rows).toHaveLength(2 + 12 + 6);
});
