// SPDX-License-Identifier: MIT
/**
 * @file Files that cannot be written: found out early, and never at the cost of what is there.
 */
import { afterAll, beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import { spawnSync } from 'node:child_process';
import { chmodSync, chownSync, lstatSync, mkdirSync, readdirSync, rmSync, statSync, symlinkSync } from 'node:fs';
import { outputOf, program, scratchFolder, shell, umbilic } from './program.js';

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

describe('a name', () => {
  const longest = 255; // of Linux's file systems

  test('may be as long as the system allows', () => {
    const name = `${'n'.repeat(longest - 4)}.obj`;
    outputOf(['cage', 'cube', '-o', name], scratch);
    expect(scratch.read(name)).toBe(outputOf(['cage', 'cube']));
  });

  test('may stand at the end of the longest path', () => {
    const most = 4095; // of Linux
    const folder = 'f'.repeat(120);
    mkdirSync(scratch.path(folder));
    const relative = `${`${folder}/../`.repeat(32).padEnd(most - 5, '/')}a.obj`;
    expect(relative).toHaveLength(most);
    outputOf(['cage', 'cube', '-o', relative], scratch);
    expect(umbilic(['cage', 'cube', '-o', `/${relative}`], scratch).err).toContain('File name too long');
  });

  test.each(['-o', '--limit-mesh', '--report'])(
    'that is longer is refused before anything is minimized, for %s',
    (option) => {
      const { code, out, err } = umbilic([...run, option, 'n'.repeat(longest + 1)], scratch);
      expect({ code, out }).toEqual({ code: 4, out: '' });
      expect(err).toMatch(/: File name too long\n$/);
    },
  );
});

describe('several results', () => {
  const all = ['-o', 'c.obj', '--limit-mesh', 'l.obj', '--report', 'r.json'];

  test.each([
    ['-o', 'c.obj'],
    ['--limit-mesh', 'l.obj'],
    ['--report', 'r.json'],
  ])('are written, but for the one that fails: %s', (option, name) => {
    for (const file of ['c.obj', 'l.obj', 'r.json']) rmSync(scratch.path(file), { force: true });
    const { code, out, err } = umbilic(
      [...run, '-q', ...all.map((one) => (one === name ? '/dev/full' : one))],
      scratch,
    );
    expect({ code, err }).toEqual({ code: 4, err: 'umbilic: cannot write /dev/full: No space left on device\n' });
    expect(out).toContain('minimized bending');
    const written = readdirSync(scratch.folder).filter((file) => all.includes(file));
    expect(written.sort()).toEqual(['c.obj', 'l.obj', 'r.json'].filter((file) => file !== name));
  });

  test('that fail are all said', () => {
    const { code, err } = umbilic([...run, '-q', ...all.map((one) => (/\./.test(one) ? '/dev/full' : one))], scratch);
    expect({ code, err }).toEqual({
      code: 4,
      err: 'umbilic: cannot write /dev/full: No space left on device\n'.repeat(3),
    });
  });

  test('are kept when the limit mesh needs more memory than there is, with an exit code of its own', () => {
    for (const file of ['c.obj', 'l.obj', 'r.json']) rmSync(scratch.path(file), { force: true });
    const command = `ulimit -v 400000; "$UMBILIC" optimize cube.obj --functional bending --levels 4 --max-iterations 0 --threads 1 -q --density 64 ${all.join(' ')}`;
    const { code, out, err } = shell(command, scratch.folder);
    expect({ code, err }).toEqual({ code: 6, err: 'umbilic: cannot write l.obj: out of memory\n' });
    expect(out).toContain('minimized bending');
    expect(
      readdirSync(scratch.folder)
        .filter((file) => all.includes(file))
        .sort(),
    ).toEqual(['c.obj', 'r.json']);
    expect(JSON.parse(scratch.read('r.json')).levels).toHaveLength(1);
  });
});

describe('a folder that cannot be written', () => {
  const NOBODY = 65534;
  const isRoot = process.getuid?.() === 0;
  /** Runs the program without root's rights. @param {string[]} args */
  const plainly = (args) => {
    const user = isRoot ? { uid: NOBODY, gid: NOBODY } : {};
    const { status, stderr } = spawnSync(program, args, { cwd: scratch.folder, encoding: 'utf8', ...user });
    return { code: status, err: stderr };
  };

  beforeEach(() => {
    chmodSync(scratch.folder, 0o755);
    rmSync(scratch.path('closed'), { recursive: true, force: true });
    mkdirSync(scratch.path('closed'));
    scratch.write('closed/kept.obj', 'x'.repeat(100_000));
    if (isRoot) chownSync(scratch.path('closed/kept.obj'), NOBODY, NOBODY);
    chmodSync(scratch.path('closed'), 0o555);
  });

  test('has its files written in place, where they may be', () => {
    expect(plainly(['cage', 'cube', '-o', 'closed/kept.obj'])).toEqual({ code: 0, err: '' });
    expect(scratch.read('closed/kept.obj')).toBe(outputOf(['cage', 'cube']));
    expect(readdirSync(scratch.path('closed'))).toEqual(['kept.obj']);
  });

  test('gets no new file', () => {
    const err = 'umbilic: cannot write closed/new.obj: Permission denied\n';
    expect(plainly(['cage', 'cube', '-o', 'closed/new.obj'])).toEqual({ code: 4, err });
  });

  test('keeps a file that may not be written either', () => {
    chmodSync(scratch.path('closed/kept.obj'), 0o444);
    const err = 'umbilic: cannot write closed/kept.obj: Permission denied\n';
    expect(plainly(['cage', 'cube', '-o', 'closed/kept.obj'])).toEqual({ code: 4, err });
    expect(scratch.read('closed/kept.obj')).toBe('x'.repeat(100_000));
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
