// SPDX-License-Identifier: MIT
/**
 * @file The committed checksums are those of the committed catalog.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { root } from '../process.js';
import { checksums, checksumsFile } from './checksums.js';

test('the catalog is the one that its checksums tell', () => {
  const folder = path.join(root, 'web/catalog');
  expect(checksums(folder)).toBe(readFileSync(path.join(folder, checksumsFile), 'utf8'));
});

test('a file has the checksum that sha256sum prints', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  try {
    writeFileSync(path.join(folder, 'b.json'), 'abc');
    writeFileSync(path.join(folder, 'a.json'), '');
    writeFileSync(path.join(folder, 'README.md'), 'not data');
    expect(checksums(folder)).toBe(
      'e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  a.json\n' +
        'ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  b.json\n',
    );
  } finally {
    rmSync(folder, { recursive: true });
  }
});
