// SPDX-License-Identifier: MIT
/**
 * @file Whoever installs the native build can link it: from C++ and C with CMake's package, from C with pkg-config, and
 * from Python. All get the energies of the command line.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, symlinkSync } from 'node:fs';
import path from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { root, scratchFolder, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const prefix = scratch.path('prefix');
const consumer = path.join(root, 'tests/consumer');
const source = path.join(consumer, 'minimize.c');
/** @type {string} */
let libraries;

/**
 * @param {string} command
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} [environment]
 * @returns {string} its output; a failure fails the test
 */
function run(command, args, environment = {}) {
  const env = { ...process.env, ...environment };
  const { status, stdout, stderr } = spawnSync(command, args, { encoding: 'utf8', env });
  expect({ status, stdout, stderr }).toMatchObject({ status: 0 });
  return stdout;
}

/** @param {string} command @param {string[]} args @returns {boolean} */
const works = (command, args) => spawnSync(command, args).status === 0;

const testIf = (/** @type {boolean} */ there) => (there ? test : test.skip);
const { version } = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8'));

/** Of the problem that all programs minimize, by the command line. @type {any} */
let report;

beforeAll(() => {
  const options = { levels: [0, 1] };
  const problem = { umbilic: 'problem', version: 1, cage: { generator: 'two-3' }, terms: { bending: 1 }, options };
  report = JSON.parse(umbilic(['optimize', '-', '-q', '--report', '-'], { input: JSON.stringify(problem) }).out);
  run('cmake', ['--install', path.join(root, 'build/native'), '--prefix', prefix]);
  const found = readdirSync(prefix, { recursive: true, encoding: 'utf8' }).find((name) => name.endsWith('umbilic.pc'));
  libraries = path.join(prefix, found ?? '', '../..');
});

/** @param {string} output of minimize.c */
function expectTheRun(output) {
  const [versions, levels] = output.split('\n');
  expect(versions).toBe(`${version} ${version}`);
  // Only the seconds differ.
  const without = (/** @type {any[]} */ list) => list.map((level) => ({ ...level, seconds: 0 }));
  expect(without(JSON.parse(levels))).toEqual(without(report.levels));
}

describe("CMake's package", () => {
  const build = scratch.path('build');

  beforeAll(() => {
    const settings = ['-G', 'Ninja', `-DCMAKE_PREFIX_PATH=${prefix}`, '-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF'];
    run('cmake', ['-S', consumer, '-B', build, ...settings]);
    run('ninja', ['-C', build]);
  });

  test('gives C++ the core', () => {
    const [energy, points] = run(path.join(build, 'minimize_cpp'), []).split(' ').map(Number);
    expect(energy).toBe(report.levels[1].energy_reported);
    expect(points).toBe(94); // 22 vertices, 48 edges and 24 faces
  });

  test('gives C the contract, static', () => expectTheRun(run(path.join(build, 'minimize_c'), [])));
  test('gives C the contract, shared', () => expectTheRun(run(path.join(build, 'minimize_c_shared'), [])));

  testIf(process.arch === 'x64')('refuses to be compiled so that arrays could not be passed', () => {
    const { status, stdout } = spawnSync('ninja', ['-C', build, 'minimize_avx'], { encoding: 'utf8' });
    expect(status).not.toBe(0);
    expect(stdout).toContain('Compile with AVX exactly if umbilic was');
  });

  test('names no folder of the machine on which it was built', () => {
    const texts = readdirSync(prefix, { recursive: true, encoding: 'utf8' }).filter((n) => /\.(cmake|pc|h)$/.test(n));
    expect(texts.filter((name) => readFileSync(path.join(prefix, name), 'utf8').includes(root))).toEqual([]);
  });

  test('has the headers that its entry headers include, which name each other as users do', () => {
    const headers = readdirSync(prefix, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.h'));
    expect(headers).toContain(path.join('include', 'umbilic', 'driver', 'run.h'));
    expect(headers).not.toContain(path.join('include', 'umbilic', 'driver', 'surface.h')); // of use in the core only
    const quoted = headers.filter((name) => /#include "/.test(readFileSync(path.join(prefix, name), 'utf8')));
    expect(quoted).toEqual([]);
  });
});

describe('pkg-config', () => {
  const there = works('pkg-config', ['--version']) && works('cc', ['--version']);

  /** @param {string} name @param {string[]} flags for pkg-config @param {string[]} [more] for the compiler */
  function compiled(name, flags, more = []) {
    const folder = { PKG_CONFIG_PATH: path.join(libraries, 'pkgconfig') };
    const options = run('pkg-config', ['--cflags', '--libs', ...flags, 'umbilic'], folder)
      .trim()
      .split(/\s+/);
    const program = scratch.path(name);
    run('cc', ['-std=c11', '-Wall', '-Wextra', '-Wpedantic', '-Werror', source, '-o', program, ...options, ...more]);
    return program;
  }

  testIf(there)('links a C program to the shared library', () => {
    const program = compiled('with-shared', []);
    expectTheRun(run(program, [], { LD_LIBRARY_PATH: libraries }));
  });

  testIf(there)('tells what the static library needs', () => {
    const folder = scratch.path('static');
    mkdirSync(folder);
    for (const name of readdirSync(libraries).filter((file) => file.endsWith('.a')))
      symlinkSync(path.join(libraries, name), path.join(folder, name));
    expectTheRun(run(compiled('with-static', ['--static', `--define-variable=libdir=${folder}`]), []));
  });
});

describe('the shared library', () => {
  test('exports the contract and nothing else', () => {
    const listing = run('nm', ['-D', '--defined-only', path.join(libraries, 'libumbilic.so')]);
    const exported = [...listing.matchAll(/ [A-Z] (\S+)$/gm)].map(([, name]) => name.replace(/@.*/, ''));
    const contract = readFileSync(path.join(root, 'wasm/api.h'), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
    const declared = [...contract.matchAll(/\b(umbilic_\w+)\(/g)].map(([, name]) => name);
    expect(exported.sort()).toEqual(declared.sort());
  });

  // Where there is no python3, which the project does not require.
  testIf(works('python3', ['--version']))('does what the page on Python says', () => {
    const page = readFileSync(path.join(root, 'wasm/python.md'), 'utf8');
    const script = scratch.write('minimize.py', /```python\n([\s\S]*?)```/.exec(page)?.[1] ?? '');
    const output = run('python3', [script, path.join(libraries, 'libumbilic.so')]);
    const value = (/** @type {string} */ name) => Number(new RegExp(`^${name} (.*)$`, 'm').exec(output)?.[1]);
    expect(value('bending')).toBe(report.energies.bending);
    expect(value('willmore')).toBe(report.energies.willmore);
    // 96 patches with 4 x 4 quads on a surface of genus 2, whose Euler characteristic is -2.
    expect(output).toMatch(/^1534 vertices, the first at \[/m);
  });
});
