// SPDX-License-Identifier: MIT
/**
 * @file Formats all sources as `npm run lint` requires.
 */
import { installPackages, installTools } from './install.js';
import { cppFiles, node } from './lint.js';
import { run } from './process.js';

if (!(await installTools('lint')) || !(await installPackages())) process.exit(1);
const done = [
  (await run('clang-format', ['-i', ...cppFiles()])) === 0,
  await node('eslint/bin/eslint.js', '--config', 'web/eslint.config.js', '--fix', '.'),
  await node('prettier/bin/prettier.cjs', '--write', '--log-level', 'warn', '.'),
];
process.exitCode = done.every(Boolean) ? 0 : 1;
