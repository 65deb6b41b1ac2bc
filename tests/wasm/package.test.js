// SPDX-License-Identifier: MIT
/**
 * @file The package as others install it: what it contains, that it computes in Node what the native program does, where it
 * takes its module from, and that TypeScript knows its types. Pages that use it are in tests/browser/package.test.js.
 */
import { readFileSync, renameSync } from 'node:fs';
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { imports } from '../architecture/js_layers.js';
import { jsonOf } from '../cli/program.js';
import { example, installedPackage, output, root } from './packed.js';

/** @type {ReturnType<typeof installedPackage>} */
let project;
beforeAll(() => {
  project = installedPackage();
});
afterAll(() => project.dispose());

const { exports: entries, dependencies } = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8'));

/** All files that entries of the package lead to by imports and addresses. */
function reached() {
  /** @type {string[]} */
  const targets = Object.values(entries).map((entry) => path.posix.normalize(entry.default ?? entry));
  const found = new Set(targets);
  for (const file of found) {
    // Emscripten's loader names the binary beside it, which is known here already.
    if (!file.endsWith('.js')) continue;
    for (const name of imports(file, readFileSync(path.join(root, file), 'utf8'))) found.add(name);
  }
  return [...found];
}

describe('the package', () => {
  test('contains what its entries need, their types, and nothing else', () => {
    const code = reached();
    const types = code.filter((name) => name.endsWith('.js')).map((name) => `build/types/${name.slice(0, -3)}.d.ts`);
    expect(project.files).toEqual([...code, ...types, 'LICENSE', 'README.md', 'build/wasm/licences.txt'].sort());
    expect(code.filter((name) => /\.(mjs|wasm)$/.test(name))).toHaveLength(4);
    console.log(`The package: ${project.files.length} files, ${Math.round(project.size / 1000)} kB packed`);
  });

  test('depends on no other', () => expect(dependencies).toBeUndefined());
});

describe('in Node', () => {
  test('the example minimizes as the native program does', () => {
    const printed = Number(project.node('main.mjs', example('js', "from 'umbilic';")));
    const asked = { cage: { generator: 'two-3' }, terms: { bending: 1 }, options: { levels: [0, 1] } };
    const input = JSON.stringify({ umbilic: 'problem', version: 1, ...asked });
    const { energies } = jsonOf(['optimize', '-', '-q', '--report', '-'], { input });
    // Both stop within the tolerance of the gradient, on which the energy depends quadratically.
    expect(Math.abs(printed / energies.bending - 1)).toBeLessThan(1e-6);
  });

  describe('without the module in its place', () => {
    const own = () => path.join(project.folder, 'node_modules/umbilic/build/wasm', `umbilic-core.${'wasm'}`);
    const moved = () => path.join(project.folder, 'moved.bin');
    beforeAll(() => renameSync(own(), moved()));
    afterAll(() => renameSync(moved(), own()));

    /** @param {string} options of load @returns {string} the version, or why the module is not loaded */
    const loadedWith = (options) =>
      project.node(
        'load.mjs',
        `import { readFileSync } from 'node:fs';
         import { load, version } from 'umbilic';
         const bytes = readFileSync('moved.bin');
         console.log(await load(${options}).then(version, (error) => error.message));`,
      );

    test('load takes it from where it is told', () => {
      const known = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8')).version;
      expect(loadedWith("{ wasmUrl: new URL('moved.bin', import.meta.url) }").trim()).toBe(known);
      expect(loadedWith("{ wasmUrl: 'moved.bin' }").trim()).toBe(known);
      expect(loadedWith('{ wasmBinary: bytes }').trim()).toBe(known);
      expect(loadedWith('{ module: await WebAssembly.compile(bytes) }').trim()).toBe(known);
    });

    test('load says why there is none', () => {
      expect(loadedWith('')).toMatch(/^ENOENT.*umbilic-core\.wasm/);
      expect(loadedWith("{ wasmBinary: bytes, wasmUrl: 'moved.bin' }")).toMatch('wasmUrl and wasmBinary are given');
      // A valid module that is not this one.
      const empty = 'await WebAssembly.compile(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]))';
      expect(loadedWith(`{ module: ${empty} }`)).not.toMatch(/^\d+\.\d+\.\d+$/m);
    });
  });
});

describe('TypeScript', () => {
  const program = `
    import { InputError, Minimizer, load, type Problem } from 'umbilic';
    import { minimize, type Surface } from 'umbilic/client';
    import 'umbilic/worker';

    const problem: Problem = { cage: { generator: 'two-3' }, terms: { bending: 1 } };
    export async function energies(shown: (surface: Surface) => void): Promise<[number, number]> {
      await load({ wasmUrl: new URL('https://example.org/umbilic-core.wasm') });
      const minimizer = new Minimizer(problem);
      const done: boolean = minimizer.step(10);
      if (!done) throw new InputError(minimizer.progress.phase);
      const report = await minimize(problem, { onSurface: shown, signal: AbortSignal.timeout(1000) });
      return [minimizer.energies.bending, report.levels[0].energy];
    }
    // @ts-expect-error
    export const misspelt: Problem = { cage: { generator: 'two-3' }, terms: { bendig: 1 } };
    // @ts-expect-error
    void minimize(problem, { onProgress: ({ speed }) => speed });
  `;

  test.each([
    ['node16', 'node16'],
    ['bundler', 'esnext'],
  ])('knows its types with the resolution %s', (moduleResolution, module) => {
    project.write('consumer.ts', program);
    const flags = { moduleResolution, module, target: 'es2022', strict: 'true', types: '', noEmit: 'true' };
    const options = Object.entries(flags).flatMap(([name, value]) => [`--${name}`, value]);
    const tsc = path.join(root, 'node_modules/typescript/bin/tsc');
    project.write('package.json', '{ "type": "module" }');
    expect(output(process.execPath, [tsc, ...options, 'consumer.ts'], project.folder)).toBe('');
  });
});
