// SPDX-License-Identifier: MIT
/**
 * @file How the program ends where it is not left in peace: terminals and readers that go away, and memory that ends.
 */
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { outputOf, scratchFolder, shell, start, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

beforeAll(() => {
  outputOf(['cage', 'two-3', '-o', 'frame.obj'], scratch);
  outputOf(['cage', 'dodecahedron-frame', '-o', 'large.obj'], scratch);
});

describe('the end of the terminal', () => {
  test.each(/** @type {NodeJS.Signals[]} */ (['SIGHUP', 'SIGTERM']))(
    'ends a run by %s, which keeps its results',
    async (signal) => {
      const line = 'optimize large.obj --functional mvs_cross --levels 0..4 -o kept.obj --report kept.json';
      const running = start(line.split(' '), scratch.folder);
      await running.says(/^level 0: .*\n/);
      running.child.kill(signal);
      // The shell and the system both send one.
      if (signal === 'SIGHUP') running.child.kill(signal);
      expect(await running.ended).toEqual({ code: 130, signal: null });
      expect(JSON.parse(scratch.read('kept.json')).levels.at(-1).stop).toBe('cancelled');
      expect(scratch.read('kept.obj')).toMatch(/^v /m);
    },
  );

  test('does not end a run that nohup protects', () => {
    const line = 'optimize large.obj --functional mvs_cross --levels 0..2';
    const command = `trap '' HUP; : > said; "$UMBILIC" ${line} 2> said & until grep -q 'level 0' said; do :; done
      kill -HUP $!; wait $!`;
    const { code, out } = shell(command, scratch.folder);
    expect(code).toBe(0);
    expect(out).not.toContain('cancelled');
  });
});

describe('where nobody reads any more', () => {
  const line = 'optimize frame.obj --functional bending --levels 0..2 -o made.obj --report made.json';

  test.each([
    ['standard error', 0],
    ['standard output', 4],
  ])('%s, all is computed and written to its files; the code is %i', async (stream, code) => {
    scratch.write('made.json', '');
    const running = start(line.split(' '), scratch.folder);
    running.child[stream === 'standard error' ? 'stderr' : 'stdout'].destroy();
    expect(await running.ended).toEqual({ code, signal: null });
    expect(JSON.parse(scratch.read('made.json')).levels.at(-1)).toMatchObject({ level: 2, stop: 'converged' });
  });
});

describe('without memory', () => {
  test('the program says so, and has a code of its own', () => {
    const line = 'optimize large.obj --functional bending --no-symmetry --levels 4 --threads 1 -q -o never.obj';
    const { code, out, err } = shell(`ulimit -v 80000; "$UMBILIC" ${line}`, scratch.folder);
    expect({ code, out, err }).toEqual({ code: 6, out: '', err: 'umbilic: out of memory\n' });
    expect(outputOf(['--help'])).toContain('6 out of memory');
  });
});

describe('names', () => {
  const escape = '\x1b]0;title\x07';

  test('of files and arguments do nothing to the terminal, in errors and in tables', () => {
    const name = `a${escape}.obj`;
    scratch.write(name, 'v 1 1');
    const seen = 'a?]0;title?.obj';
    expect(umbilic(['info', name], scratch)).toMatchObject({
      code: 3,
      err: expect.stringContaining(`${seen}: line 1`),
    });
    scratch.write(name, scratch.read('frame.obj'));
    expect(outputOf(['info', name], scratch)).toMatch(`${seen}: 22 vertices`);
    expect(umbilic(['info', `no${name}`], scratch).err).toBe(
      `umbilic: cannot read no${seen}: No such file or directory\n`,
    );
    expect(umbilic([`x${escape}`]).err).toContain('not expected: x?]0;title?\n');
  });

  test('are shown as they are in other scripts', () => {
    expect(umbilic(['info', 'größe-面.obj']).err).toContain('cannot read größe-面.obj');
  });
});
