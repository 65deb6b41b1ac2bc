// SPDX-License-Identifier: MIT
/**
 * @file Files that cannot be written: found out early, and never at the cost of what is there.
 */
import { afterAll, beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { chmodSync, lstatSync, mkdirSync, readdirSync, rmSync, statSync, symlinkSync } from 'node:fs';
import { outputOf, scratchFolder, shell, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const run = ['optimize', 'cube.obj', '--functional', 'bending', '--levels', '1'];

beforeAll(() => {
  outputOf(['cage', 'cube', '-o', 'cube.obj'], scratch);
  mkdirSync(scratch.path('folder'));
  scratch.write('file', 'not a folder');
});

describe.each(['-o', '--limit-mesh', '--report'])('%s', (option) => {
  /** @type {[string, string][]} */
  const impossible = [
    ['missing/out', 'No such file or directory'],
    ['file/out', 'Not a directory'],
    ['folder', 'Is a directory'],
    ['', 'No such file or directory'],
  ];
  test.each(impossible)('to %s ends with 4 before anything is minimized', (file, reason) => {
    const { code, out, err } = umbilic([...run, option, file], scratch);
    expect({ code, out, err }).toEqual({ code: 4, out: '', err: `umbilic: cannot write ${file || "''"}: ${reason}\n` });
  });

  test('to a full device ends with 4 after the run, and the table is still shown', () => {
    const { code, out, err } = umbilic([...run, '-q', option, '/dev/full'], scratch);
    expect(code).toBe(4);
    expect(err).toBe('umbilic: cannot write /dev/full: No space left on device\n');
    expect(out).toContain('minimized bending');
  });
});

describe('an existing file', () => {
  beforeEach(() => rmSync(scratch.path('kept.obj'), { force: true }));

  test('is replaced as a whole and keeps its permissions', () => {
    scratch.write('kept.obj', 'x'.repeat(100_000));
    chmodSync(scratch.path('kept.obj'), 0o640);
    outputOf(['cage', 'cube', '-o', 'kept.obj'], scratch);
    expect(scratch.read('kept.obj')).toBe(outputOf(['cage', 'cube']));
    expect(statSync(scratch.path('kept.obj')).mode & 0o777).toBe(0o640);
  });

  test('behind a symbolic link is replaced where it is', () => {
    scratch.write('folder/target.obj', 'old');
    symlinkSync('folder/target.obj', scratch.path('kept.obj'));
    outputOf(['cage', 'cube', '-o', 'kept.obj'], scratch);
    expect(lstatSync(scratch.path('kept.obj')).isSymbolicLink()).toBe(true);
    expect(scratch.read('folder/target.obj')).toMatch(/^v -1 -1 -1\n/);
  });

  test('survives a write that fails half way, and nothing else is left behind', () => {
    scratch.write('kept.obj', 'precious');
    const before = readdirSync(scratch.folder);
    const { code, err } = shell('ulimit -f 4; "$UMBILIC" cage torus --segments 100x100 -o kept.obj', scratch.folder);
    expect({ code, err }).toEqual({ code: 4, err: 'umbilic: cannot write kept.obj: File too large\n' });
    expect(scratch.read('kept.obj')).toBe('precious');
    expect(readdirSync(scratch.folder)).toEqual(before);
  });

  test('that may be the input itself is read before it is replaced', () => {
    outputOf(['cage', 'cube', '-o', 'kept.obj'], scratch);
    outputOf(['optimize', 'kept.obj', '--functional', 'bending', '--levels', '1', '-o', 'kept.obj'], scratch);
    expect(scratch.read('kept.obj').match(/^f /gm)).toHaveLength(24);
  });
});

describe('a new file', () => {
  test('has the permissions that the umask leaves', () => {
    shell('umask 027; "$UMBILIC" cage cube -o fresh.obj', scratch.folder);
    expect(statSync(scratch.path('fresh.obj')).mode & 0o777).toBe(0o640);
  });
});

describe('a device', () => {
  test('takes any number of results', () => {
    outputOf([...run, '-o', '/dev/null', '--report', '/dev/null'], scratch);
    expect(statSync('/dev/null').isCharacterDevice()).toBe(true);
  });
});

describe('standard output', () => {
  test.each([
    'cage cube',
    'cage --list',
    'info cube.obj',
    'evaluate cube.obj --json',
    'check-gradient cube.obj --functional bending',
  ])('of "%s" that is full ends with 4', (line) => {
    const { code, err } = shell(`"$UMBILIC" ${line} > /dev/full`, scratch.folder);
    expect(code).toBe(4);
    expect(err).toContain('umbilic: cannot write to standard output: No space left on device\n');
  });
});
