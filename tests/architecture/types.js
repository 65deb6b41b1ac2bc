// SPDX-License-Identifier: MIT
/**
 * @file Two types must not have the same name in a namespace. The linker would treat them as one type and use the
 * functions of one for both, even if they are in different programs.
 */
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/** @param {string} text C++ @returns {string} without comments, strings, characters and preprocessor lines */
function codeOf(text) {
  return text
    .replace(/R"(\w*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|\/\/.*|\/\*[\s\S]*?\*\//g, ' ')
    .replace(/(?<![\w])'(?:\\[^'\n]+|[^'\\\n])'/g, ' ')
    .replace(/^[ \t]*#(?:.*\\\n)*.*$/gm, '');
}

/**
 * The types that a file defines in named namespaces, outside other types and functions.
 * @param {string} text C++
 * @returns {string[]} "umbilic::cli::Arguments"
 */
export function typesOf(text) {
  const code = codeOf(text);
  /** For each open brace, the name of the namespace that it opened, or null. @type {(string | null)[]} */
  const open = [];
  const found = [];
  let begin = 0;
  for (let i = 0; i < code.length; i++) {
    if (code[i] === ';') begin = i + 1;
    if (code[i] === '}') {
      open.pop();
      begin = i + 1;
    }
    if (code[i] !== '{') continue;
    const head = code.slice(begin, i);
    const space = /\bnamespace\s*([\w:]*)\s*$/.exec(head);
    // A template's parameters may themselves say class or struct.
    const type =
      /(?:^|[\s>])(?:class|struct|union|enum(?:\s+(?:class|struct))?)\s+(?:\[\[[^\]]*\]\]\s*)?(\w+)(?:\s+final)?\s*(?::[^:(][^(;]*)?$/.exec(
        head,
      );
    if (type && open.every((name) => name)) found.push([...open, type[1]].join('::'));
    open.push(space ? space[1] || null : null);
    begin = i + 1;
  }
  return found;
}

/**
 * @param {Files} files
 * @returns {string[]} the names that several files, or one file twice, give to types
 */
export function repeatedTypes(files) {
  /** @type {Map<string, string[]>} */
  const places = new Map();
  for (const [file, text] of matching(files, /^(core|wasm|tests)\/.*\.(h|cpp)$/)) {
    for (const type of typesOf(text)) places.set(type, [...(places.get(type) ?? []), file]);
  }
  return [...places]
    .filter(([, where]) => where.length > 1)
    .map(([type, where]) => `${type} is in ${where.join(', ')}`);
}
