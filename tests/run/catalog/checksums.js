// SPDX-License-Identifier: MIT
/**
 * @file The checksums of the catalog's files, so that whoever cites its numbers can say which they were.
 */
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';

/** The file beside the data, in the form that `sha256sum --check` reads. */
export const checksumsFile = 'checksums.txt';

/** @param {string} folder the catalog's @returns {string} a line for each of its JSON files, sorted by name */
export function checksums(folder) {
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'));
  const line = (/** @type {string} */ name) => {
    const hash = createHash('sha256').update(readFileSync(path.join(folder, name)));
    return `${hash.digest('hex')}  ${name}\n`;
  };
  return names.sort().map(line).join('');
}

/** @param {string} folder the catalog's */
export const writeChecksums = (folder) => writeFileSync(path.join(folder, checksumsFile), checksums(folder));
