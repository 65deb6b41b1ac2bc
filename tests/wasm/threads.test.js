// SPDX-License-Identifier: MIT
/**
 * @file The module that has threads: it gives the bytes of the one that has none, on any number of threads.
 */
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from '@jest/globals';

const umbilic = new URL('../../wasm/umbilic.js', import.meta.url).href;

/**
 * Runs a module in a process of its own, since each loads the core only once.
 * @param {string} text what the core is imported for
 * @returns {string} what it prints
 */
function node(text) {
  const program = `import { createHash } from 'node:crypto';
    import { Cage, Minimizer, load, useThreads } from '${umbilic}';
    ${text}`;
  const folder = fileURLToPath(new URL('../..', import.meta.url));
  return execFileSync(process.execPath, ['--input-type=module', '-e', program], { cwd: folder, encoding: 'utf8' });
}

/** Large enough for all loops to be shared, and for memory to grow while they run. What tells times is left out. */
const printRun = `
  function printRun() {
    const minimizer = new Minimizer({
      cage: { generator: 'two-3' },
      terms: { mvs_cross: 1 },
      options: { levels: [3, 3], max_iterations: 1, symmetry: false, metric: 'hessian' },
    });
    while (!minimizer.step(1));
    const times = new Set(['seconds', 'estimate']);
    const report = JSON.parse(minimizer.report(), (name, value) => (times.has(name) ? undefined : value));
    const { positions, normals } = minimizer.limitMesh(4);
    const { points } = minimizer.state;
    const hash = createHash('sha256').update(JSON.stringify({ report, positions, normals, points })).digest('hex');
    console.log(report.levels[0].evaluations, report.energies.mvs_cross, hash);
    minimizer.dispose();
  }`;

describe('the module that has threads', () => {
  test('gives the same bytes as the one that has none, on 1, 2 and 3 threads', () => {
    const alone = node(`${printRun}\nawait load();\nprintRun();`);
    expect(alone).toMatch(/^\d+ \d+\.\d+ [0-9a-f]{64}\n$/);
    const shared = node(`${printRun}
      await load({ threads: 3 });
      printRun();
      for (const threads of [1, 2]) {
        if ((await useThreads(threads)) !== threads) throw new Error('not so many');
        printRun();
      }`);
    expect(shared).toBe(alone.repeat(3));
  });

  test('has a message for each failure, and keeps its memory when it grows', () =>
    expect(
      node(`
        await load({ threads: 2 });
        try {
          Cage.read('v 1 2 3\\nf 1 2\\n');
        } catch (error) {
          console.log(error.message);
        }
        const cage = Cage.read('#'.repeat(3e7) + '\\n' + Cage.generate('cube').obj());
        console.log(cage.counts.faces);`),
    ).toMatch(/^line 2: .*\n6\n$/));
});

describe('useThreads', () => {
  test.each([
    ['for the module without threads is always 1', '', 4, '1'],
    ['makes as many as are wanted', "{ threads: 'later' }", 4, '4'],
  ])('%s', (_, options, count, threads) =>
    expect(node(`await load(${options});\nconsole.log(await useThreads(${count}));`)).toBe(`${threads}\n`),
  );

  test('says how many there may be', () =>
    expect(
      node(`await load({ threads: 'later' });
        for (const count of [0, 257, 1.5]) await useThreads(count).catch((error) => console.log(error.message));`),
    ).toBe([0, 257, 1.5].map((count) => `${count} threads: from 1 to 256 can compute, in whole numbers\n`).join('')));
});
