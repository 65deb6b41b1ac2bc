// SPDX-License-Identifier: MIT
/**
 * @file A project that has installed the package, for tests: `npm pack`, unpacked into the node_modules of a folder of its own,
 * and the examples of the page on JavaScript.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/**
 * Runs a program to its end.
 * @param {string} command @param {string[]} args @param {string} folder to run it in
 * @returns {string} its output
 */
export function output(command, args, folder) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: folder, encoding: 'utf8' });
  if (status !== 0) throw new Error(`${command} ${args.join(' ')} ended with ${status}: ${stdout}${stderr}`);
  return stdout;
}

/** What is said of the libraries. */
export const guide = readFileSync(path.join(root, 'wasm/README.md'), 'utf8');

/**
 * The code block of `guide` that contains a text.
 * @param {string} language @param {string} text
 */
export function example(language, text) {
  const blocks = [...guide.matchAll(/^```(\w*)\n([\s\S]*?)^```$/gm)].filter(
    ([, name, code]) => name === language && code.includes(text),
  );
  if (blocks.length !== 1) throw new Error(`${blocks.length} examples in ${language} with ${text}, not one`);
  return blocks[0][2];
}

/** Packs what is built, without building it, and installs it as npm would: it has no dependencies. */
export function installedPackage() {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  const installed = path.join(folder, 'node_modules/umbilic');
  mkdirSync(installed, { recursive: true });
  output('npm', ['pack', '--ignore-scripts', '--silent', '--offline', '--pack-destination', folder], root);
  const tarball = readdirSync(folder).find((name) => name.endsWith('.tgz')) ?? '';
  output('tar', ['-xzf', tarball, '-C', installed, '--strip-components=1'], folder);
  const entries = readdirSync(installed, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return {
    folder,
    /** Of the package. */
    files: entries.map((entry) => path.relative(installed, path.join(entry.parentPath, entry.name))).sort(),
    /** Bytes of the tarball. */
    size: statSync(path.join(folder, tarball)).size,
    /** @param {string} name @param {string} text */
    write: (name, text) => writeFileSync(path.join(folder, name), text),
    /** Runs a module in Node. @param {string} name @param {string} text @returns {string} what it prints */
    node(name, text) {
      writeFileSync(path.join(folder, name), text);
      return output(process.execPath, [name], folder);
    },
    dispose: () => rmSync(folder, { recursive: true, force: true }),
  };
}
