// SPDX-License-Identifier: MIT
/**
 * @file Installs what a command needs and the machine lacks: Debian packages and the node packages of
 * package-lock.json. Fast if nothing is missing. Uses only modules of Node itself, because it runs before anything is
 * installed.
 */
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { output, root, run } from './process.js';

/** @typedef {'native' | 'wasm' | 'lint' | 'browser' | 'fuzz' | 'coverage' | 'factorization'} Need */

/** Whether clang has libFuzzer, whose folder is named by clang's version. */
const hasFuzzer = () => {
  const folder = output('clang++', ['-print-runtime-dir'])?.trim();
  const names = folder && existsSync(folder) ? readdirSync(folder) : [];
  return names.some((name) => /^libclang_rt\.fuzzer(-.*)?\.a$/.test(name));
};

/** Whether a folder of /usr/lib, which is named by the processor, has the library to link. */
const hasOpenBlas = () =>
  existsSync('/usr/lib') && readdirSync('/usr/lib').some((folder) => existsSync(`/usr/lib/${folder}/libopenblas.so`));

/**
 * Debian packages. Each is recognized by a program on the PATH, a header in an include folder, or otherwise.
 * @type {{ package: string, program?: string, header?: string, found?: () => boolean, needs: Need[] }[]}
 */
export const tools = [
  { package: 'g++', program: 'g++', needs: ['native'] },
  { package: 'emscripten', program: 'em++', needs: ['wasm'] },
  { package: 'cmake', program: 'cmake', needs: ['native', 'wasm'] },
  { package: 'ninja-build', program: 'ninja', needs: ['native', 'wasm'] },
  { package: 'libeigen3-dev', header: 'eigen3/Eigen/Core', needs: ['native', 'wasm'] },
  { package: 'libfmt-dev', header: 'fmt/format.h', needs: ['native', 'wasm'] },
  { package: 'libfast-float-dev', header: 'fast_float/fast_float.h', needs: ['native', 'wasm'] },
  { package: 'nlohmann-json3-dev', header: 'nlohmann/json.hpp', needs: ['native', 'wasm'] },
  { package: 'libcli11-dev', header: 'CLI/CLI.hpp', needs: ['native'] },
  { package: 'libgtest-dev', header: 'gtest/gtest.h', needs: ['native'] },
  { package: 'clang-format', program: 'clang-format', needs: ['lint'] },
  { package: 'clang', program: 'clang++', needs: ['fuzz'] },
  { package: 'libclang-rt-dev', found: hasFuzzer, needs: ['fuzz'] },
  { package: 'gcovr', program: 'gcovr', needs: ['coverage'] },
  { package: 'libsuitesparse-dev', header: 'suitesparse/cholmod.h', needs: ['factorization'] },
  { package: 'libopenblas-dev', found: hasOpenBlas, needs: ['factorization'] },
  { package: 'chromium-headless-shell', program: 'chromium-headless-shell', needs: ['browser'] },
];

const includeFolders = ['/usr/include', '/usr/local/include'];

/** @param {string} program @returns {boolean} */
function onPath(program) {
  return (process.env.PATH ?? '').split(path.delimiter).some((folder) => existsSync(path.join(folder, program)));
}

/** @param {Need[]} needs @returns {string[]} the packages that are missing */
function missingTools(needs) {
  return tools
    .filter((tool) => tool.needs.some((need) => needs.includes(need)))
    .filter(({ program, header, found }) => {
      if (found) return !found();
      if (program) return !onPath(program);
      return !includeFolders.some((folder) => existsSync(path.join(folder, header ?? '')));
    })
    .map((tool) => tool.package);
}

/**
 * Installs missing compilers, libraries and the browser with apt-get. If it cannot, it says what to install.
 * @param {...Need} needs
 * @returns {Promise<boolean>} whether everything is there
 */
export async function installTools(...needs) {
  const missing = missingTools(needs);
  if (!missing.length) return true;
  const list = missing.join(' ');
  if (!onPath('apt-get')) {
    console.error(
      `Missing, by the names of Debian's packages: ${list}\nInstall them with this system's package manager.`,
    );
    return false;
  }
  const isRoot = process.getuid?.() === 0;
  const maySudo = onPath('sudo') && (process.stdin.isTTY || output('sudo', ['-n', 'true']) !== undefined);
  if (!isRoot && !maySudo) {
    console.error(`Missing: ${list}\nAs root: apt-get update && apt-get install --no-install-recommends ${list}`);
    return false;
  }
  console.log(`Installing ${list}`);
  /** @param {...string} args */
  const aptGet = (...args) => {
    const command = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-qq', ...args];
    return isRoot ? run(command[0], command.slice(1)) : run('sudo', command);
  };
  await aptGet('update'); // failures are ignored; the next check shows whether something is missing
  await aptGet('install', '--yes', '--no-install-recommends', ...missing);
  const absent = missingTools(needs);
  if (absent.length) console.error(`Could not install ${absent.join(' ')}`);
  return !absent.length;
}

/**
 * Installs the node packages if node_modules does not match package-lock.json.
 * @returns {Promise<boolean>} whether they are there
 */
export async function installPackages() {
  if (packagesAreInstalled()) return true;
  return (await run('npm', ['ci'])) === 0;
}

/**
 * Whether node_modules contains the packages of package-lock.json. Optional ones, for other machines, may be missing.
 */
function packagesAreInstalled() {
  const installedFile = path.join(root, 'node_modules/.package-lock.json');
  if (!existsSync(installedFile)) return false;
  const installed = JSON.parse(readFileSync(installedFile, 'utf8')).packages;
  const wanted = JSON.parse(readFileSync(path.join(root, 'package-lock.json'), 'utf8')).packages;
  return Object.entries(wanted).every(([folder, { version, integrity, optional }]) => {
    if (folder === '' || (optional && !installed[folder])) return true;
    return installed[folder]?.version === version && installed[folder]?.integrity === integrity;
  });
}
