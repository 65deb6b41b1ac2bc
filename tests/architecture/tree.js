// SPDX-License-Identifier: MIT
/**
 * @file The project's text files as a map from path to text, without built and installed files.
 */
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** @typedef {Map<string, string>} Files paths relative to the root, with forward slashes, and their texts */

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

const leftOut = new Set(['.git', 'build', 'node_modules']);
const binary = /\.(png|jpe?g|gif|webp|ico|woff2?)$/;

/** @returns {Files} */
export function readTree() {
  /** @type {Files} */
  const files = new Map();
  /** @param {string} folder */
  const visit = (folder) => {
    for (const entry of readdirSync(path.join(root, folder), { withFileTypes: true })) {
      const name = path.posix.join(folder, entry.name);
      if (leftOut.has(name)) continue;
      if (entry.isDirectory()) visit(name);
      else if (!binary.test(name)) files.set(name, readFileSync(path.join(root, name), 'utf8'));
    }
  };
  visit('');
  return files;
}

/**
 * The files whose path matches.
 * @param {Files} files
 * @param {RegExp} pattern
 * @returns {[path: string, text: string][]}
 */
export function matching(files, pattern) {
  return [...files].filter(([name]) => pattern.test(name));
}
