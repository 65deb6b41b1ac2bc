// SPDX-License-Identifier: MIT
/**
 * @file `npm run catalog`: builds the program and computes the missing parts of web/catalog (`-- --anew`: all parts).
 * `-- --check` computes everything again and compares. All options of `umbilic catalog` may follow. `npm run catalog --
 * readme` writes its tables to the README beside it. What changes the data writes their checksums.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { replaceBetween } from './bench/tables.js';
import { build } from './build.js';
import { writeChecksums } from './catalog/checksums.js';
import { catalogSection } from './catalog/section.js';
import { installPackages, installTools } from './install.js';
import { root, run } from './process.js';

const folder = 'web/catalog';
const args = process.argv.slice(2);

if (args.join() === 'readme') {
  const readme = path.join(root, folder, 'README.md');
  const catalog = JSON.parse(readFileSync(path.join(root, folder, 'catalog.json'), 'utf8'));
  const text = replaceBetween(
    readFileSync(readme, 'utf8'),
    '<!-- catalog: begin -->',
    '<!-- catalog: end -->',
    `\n${catalogSection(catalog)}`,
  );
  writeFileSync(readme, text);
} else {
  if (!(await installTools('native')) || !(await installPackages())) process.exit(1);
  if (!(await build('native', 'umbilic'))) process.exit(1);
  process.exitCode = await run('build/native/umbilic', ['catalog', '--out', folder, ...args]);
  if (!args.includes('--check')) writeChecksums(path.join(root, folder));
}
