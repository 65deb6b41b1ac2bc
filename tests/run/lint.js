// SPDX-License-Identifier: MIT
/**
 * @file The checks of `npm run lint`: formatting of C++, formatting of JavaScript, ESLint, and the types in JSDoc.
 */
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { configure } from './build.js';
import { installPackages, installTools } from './install.js';
import { capture, root, run } from './process.js';

/** @typedef {{ name: string, check: () => Promise<boolean> }} Gate */

/** @type {Gate[]} */
export const gates = [
  { name: 'clang-format', check: checkCppLayout },
  { name: 'prettier', check: () => node('prettier/bin/prettier.cjs', '--check', '--log-level', 'warn', '.') },
  {
    name: 'eslint',
    check: () => node('eslint/bin/eslint.js', '--config', 'web/eslint.config.js', '--max-warnings', '0', '.'),
  },
  { name: 'types', check: checkTypes },
];

/** @returns {string[]} all C++ files of the project, relative to its root */
export function cppFiles() {
  return ['core', 'wasm', 'tests'].flatMap((folder) =>
    readdirSync(path.join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(h|cpp)$/.test(name))
      .map((name) => path.join(folder, name)),
  );
}

/**
 * Runs the program of a node package.
 * @param {string} program its path in node_modules
 * @param {...string} args
 * @returns {Promise<boolean>} whether it succeeded
 */
export async function node(program, ...args) {
  return (await run(process.execPath, [path.join('node_modules', program), ...args])) === 0;
}

/** Prints only file names, because `npm run format` can fix them. */
async function checkCppLayout() {
  const { code, text } = await capture('clang-format', ['--dry-run', '-Werror', ...cppFiles()]);
  const files = new Set([...text.matchAll(/^(\S+?):\d+:\d+: error/gm)].map(([, file]) => file));
  if (code !== 0) console.log(files.size ? `Not laid out (npm run format): ${[...files].join(' ')}` : text);
  return code === 0;
}

/** Configures the WebAssembly build if necessary, since that writes the module's type declarations. */
async function checkTypes() {
  if (!existsSync(path.join(root, 'build/wasm/umbilic-core.d.mts')) && !(await configure('wasm'))) return false;
  return node('typescript/bin/tsc', '--project', 'web/tsconfig.json');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  if (!(await installTools('wasm', 'lint')) || !(await installPackages())) process.exit(1);
  for (const { name, check } of gates) {
    const ok = await check();
    console.log(`${ok ? 'ok    ' : 'FAILED'} ${name}`);
    if (!ok) process.exitCode = 1;
  }
}
