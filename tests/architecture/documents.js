// SPDX-License-Identifier: MIT
/**
 * @file Checks on the project's Markdown: links lead somewhere, files that are named exist, and the overview's numbers are
 * those of the generated tables. Every check returns the problems that it finds, one line each.
 */
import path from 'node:path';
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/** Without blocks of code, whose brackets are no links. @param {string} text */
const prose = (text) => text.replace(/^```[\s\S]*?^```$/gm, '');

/** The name by which GitHub links to a heading. @param {string} heading */
export const anchorOf = (heading) =>
  heading
    .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replaceAll(' ', '-');

/** The anchors of a Markdown or HTML file. @param {string} name @param {string} text */
function anchors(name, text) {
  if (name.endsWith('.html')) return [...text.matchAll(/\sid="([^"]+)"/g)].map(([, id]) => id);
  return [...prose(text).matchAll(/^#+ (.*)$/gm)].map(([, heading]) => anchorOf(heading));
}

/**
 * Every relative link and picture leads to a file, and to a heading of it if it names one.
 * @param {Files} files
 * @param {(name: string) => boolean} exists whether a path from the root is a file or a folder
 * @returns {string[]}
 */
export function links(files, exists) {
  return matching(files, /\.md$/).flatMap(([file, text]) =>
    [...prose(text).matchAll(/\]\(([^)\s]+)\)/g)].flatMap(([, link]) => {
      if (/^[a-z]+:/.test(link)) return [];
      const [target, anchor] = link.split('#');
      const name = target ? path.posix.join(path.posix.dirname(file), target) : file;
      if (!exists(name)) return [`${file} links to ${name}, which is not there`];
      if (anchor && !anchors(name, files.get(name) ?? '').includes(anchor))
        return [`${file} links to ${anchor} in ${name}, which has no such heading`];
      return [];
    }),
  );
}

/**
 * Every path in backquotes that begins with a folder of the project leads to a file or a folder.
 * @param {Files} files
 * @param {(name: string) => boolean} exists
 * @returns {string[]}
 */
export function namedFiles(files, exists) {
  return matching(files, /\.md$/).flatMap(([file, text]) =>
    [...prose(text).matchAll(/`((?:core|wasm|web|tests)\/[\w./-]+)`/g)]
      .filter(([, name]) => !exists(name))
      .map(([, name]) => `${file} names ${name}, which is not there`),
  );
}

/** The rows of a text's tables that have a decimal number. @param {string} text */
const numberRows = (text) => text.split('\n').filter((line) => /^\|.*\d\.\d/.test(line));

/**
 * Every row of numbers in the README stands in a generated table.
 * @param {Files} files
 * @param {string[]} tables the files with the tables
 * @returns {string[]}
 */
export function quotedRows(files, tables) {
  const known = new Set(tables.flatMap((name) => numberRows(files.get(name) ?? '')));
  return numberRows(files.get('README.md') ?? '')
    .filter((row) => !known.has(row))
    .map((row) => `README.md has a row that no generated table has: ${row}`);
}
