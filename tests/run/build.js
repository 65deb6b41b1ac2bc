// SPDX-License-Identifier: MIT
/**
 * @file Builds parts of the project into build/: `node tests/run/build.js native sanitize wasm types web fuzz
 * coverage`.
 */
import { existsSync, readdirSync, rmSync, statSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { installPackages, installTools } from './install.js';
import { noticesFile, writeNotices } from './licences.js';
import { output, root, run } from './process.js';

/** @typedef {'native' | 'sanitize' | 'wasm' | 'types' | 'web' | 'fuzz' | 'coverage'} Part */

/** The parts in the order in which they are built, and what must be installed for each. @type {Record<Part, import('./install.js').Need[]>} */
export const parts = {
  native: ['native'],
  wasm: ['wasm'],
  types: [],
  web: [],
  sanitize: ['native'],
  fuzz: ['native', 'fuzz'],
  coverage: ['native', 'coverage'],
};

/**
 * The folder of build/ for a part. The sanitized tests share the objects of the native ones.
 * @param {Exclude<Part, 'types' | 'web'>} part
 */
const folderOf = (part) => (part === 'sanitize' ? 'native' : part);

/**
 * Builds one part and continues after a target fails. The page and the types need the WebAssembly module.
 * @param {Part} part
 * @param {...string} targets by default all
 * @returns {Promise<boolean>} whether all of it was built
 */
export async function build(part, ...targets) {
  if (part === 'web') return buildPage();
  if (part === 'types') return buildTypes();
  const folder = folderOf(part);
  if (!existsSync(path.join(root, 'build', folder, 'build.ninja')) && !(await configure(folder))) return false;
  if (part === 'sanitize' && !targets.length) targets = ['umbilic_sanitized_tests'];
  if (part === 'fuzz' && !targets.length) targets = ['umbilic_fuzz'];
  const jobs = String(availableParallelism());
  const quiet = process.stdout.isTTY ? [] : ['--quiet'];
  const built = (await run('ninja', ['-C', `build/${folder}`, '-k', '0', '-j', jobs, ...quiet, ...targets])) === 0;
  if (part === 'wasm') writeNotices();
  return built;
}

/**
 * Runs CMake to write a part's build files. The build itself notices later changes of CMake's files.
 * @param {'native' | 'wasm' | 'fuzz' | 'coverage'} part
 * @returns {Promise<boolean>}
 */
export async function configure(part) {
  const settings = {
    native: [],
    fuzz: ['-DCMAKE_CXX_COMPILER=clang++', '-DUMBILIC_FUZZ=ON'],
    coverage: ['-DUMBILIC_COVERAGE=ON'],
    wasm: [`-DCMAKE_TOOLCHAIN_FILE=${emscriptenToolchain()}`],
  };
  const args = ['-S', '.', '-B', `build/${part}`, '-G', 'Ninja', '--log-level=WARNING', ...settings[part]];
  return (await run('cmake', args)) === 0;
}

/** CMake's toolchain file for em++. It is used without `emcmake`, which passes flags that Node no longer knows. */
function emscriptenToolchain() {
  const folder = output('em-config', ['EMSCRIPTEN_ROOT'])?.trim() ?? '/usr/share/emscripten';
  return path.join(folder, 'cmake/Modules/Platform/Emscripten.cmake');
}

/** Writes the type declarations of the package from the JSDoc of its modules. */
async function buildTypes() {
  rmSync(path.join(root, 'build/types'), { recursive: true, force: true });
  const tsc = ['node_modules/typescript/bin/tsc', '--project', 'wasm/tsconfig.types.json'];
  return (await run(process.execPath, tsc)) === 0;
}

/** Builds the page, unless it is newer than all its sources. */
async function buildPage() {
  const page = path.join(root, 'build/web/index.html');
  const modules = ['umbilic-core', 'umbilic-core-threads'].flatMap((name) => [`${name}.mjs`, `${name}.wasm`]);
  const built = [...modules.map((name) => `build/wasm/${name}`), path.relative(root, noticesFile)];
  const inputs = ['web', 'wasm', ...built, 'package-lock.json'];
  if (existsSync(page) && newest(inputs) < statSync(page).mtimeMs) return true;
  const vite = ['node_modules/vite/bin/vite.js', 'build', '--config', 'web/vite.config.js', '--logLevel', 'warn'];
  return (await run(process.execPath, vite)) === 0;
}

/** @param {string[]} names files and folders @returns {number} the time of the last change to any of them or their content */
function newest(names) {
  const paths = names.flatMap((name) => {
    const file = path.join(root, name);
    if (!existsSync(file)) return [];
    if (!statSync(file).isDirectory()) return [file];
    return [file, ...readdirSync(file, { recursive: true, encoding: 'utf8' }).map((inner) => path.join(file, inner))];
  });
  return Math.max(0, ...paths.map((file) => statSync(file).mtimeMs));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const wanted = process.argv.slice(2).filter(/** @returns {part is Part} */ (part) => part in parts);
  if (!wanted.length || wanted.length < process.argv.length - 2) {
    console.error(`Usage: node tests/run/build.js ${Object.keys(parts).join(' | ')} …`);
    process.exit(2);
  }
  if (!(await installTools(...wanted.flatMap((part) => parts[part]))) || !(await installPackages())) process.exit(1);
  for (const part of wanted) if (!(await build(part))) process.exitCode = 1;
}
