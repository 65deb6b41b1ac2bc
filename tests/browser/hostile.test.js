// SPDX-License-Identifier: MIT
/**
 * @file What the tables of hostile inputs say of a file, the studio says to whoever drops it, and goes on working.
 */
import { describe, expect, test } from '@jest/globals';
import { families } from '../hostile/rows.js';
import { measured, openPage, status } from './page.js';
import { servedPage } from './served.js';

const served = servedPage();
const rows = families.flatMap(([, all]) => all);

/** @param {string} name @returns {import('../hostile/row.js').CageRow | import('../hostile/row.js').ProblemRow} */
function rowCalled(name) {
  const row = rows.find((candidate) => candidate.name === name);
  if (!row || row.kind === 'command') throw new Error(`no file "${name}"`);
  return row;
}

const refused = [
  'coordinate NaN',
  'index 2^32 + 3, which is 3 where it wraps',
  'nothing',
  'UTF-16, little-endian',
  '64 KB of junk',
  'binary OFF',
  'binary PLY with a list of 2^32 - 1',
  'a Klein bottle',
  'all vertices in one place',
  'valence 25',
  'a million arrays in each other',
  'a cage text with an error, and a name with an escape',
];

/** @type {[name: string, facts: RegExp][]} */
const shown = [
  ['group with an escape sequence', /Faces\s*4\b/],
  ['16 cubes in one place', /Faces\s*96\b/],
  ['binary PLY, big-endian', /Faces\s*4\b/],
];

describe('the studio', () => {
  test('says of files that it refuses what the tables say, and shows what they accept', async () => {
    const { page, errors } = await openPage(served.browser, served.url);
    /** @param {string} name */
    async function choose(name) {
      const { kind, content } = rowCalled(name);
      const buffer = Buffer.from(/** @type {Uint8Array} */ (content()));
      await page.locator('#file').setInputFiles({
        name: kind === 'cage' ? 'hostile.obj' : 'hostile.json',
        mimeType: 'application/octet-stream',
        buffer,
      });
    }
    for (const name of refused) {
      await choose(name);
      await page
        .locator('#alert')
        .filter({ hasText: rowCalled(name).says })
        .waitFor();
    }
    for (const [name, facts] of shown) {
      await choose(name);
      await page.locator('#alert').waitFor({ state: 'hidden' });
      await status(page, /^Ready/);
      await measured(page);
      expect(await page.locator('.facts').innerText()).toMatch(facts);
    }
    expect(errors).toEqual([]);
    await page.context().close();
  });
});
