// SPDX-License-Identifier: MIT
/**
 * @file The notices of what the WebAssembly module contains besides this project, from the copyright files of the
 * installed packages: build/wasm/licences.txt, which the npm package and the page pass on. The page's build adds those of
 * its JavaScript (web/vite.config.js).
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { root } from './process.js';

/**
 * @typedef {object} Library
 * @property {string} name
 * @property {string} licence under which it is passed on
 * @property {string} source where its source is
 * @property {RegExp} headers names of headers in angle brackets that are its own
 * @property {string} copyright its copyright file
 * @property {RegExp} [files] those of its files that are passed on; all, unless that is given
 * @property {string[]} [texts] licences to which that file only refers
 */

/** The folder in which Debian has a package's copyright file. @param {string} name */
const debian = (name) => `/usr/share/doc/${name}/copyright`;

/** @type {Library[]} */
export const libraries = [
  {
    name: 'Eigen',
    licence: 'MPL-2.0',
    source: 'https://gitlab.com/libeigen/eigen',
    headers: /^Eigen\//,
    copyright: debian('libeigen3-dev'),
    texts: ['/usr/share/common-licenses/MPL-2.0'],
  },
  {
    name: '{fmt}',
    licence: 'MIT',
    source: 'https://github.com/fmtlib/fmt',
    headers: /^fmt\//,
    copyright: debian('libfmt-dev'),
  },
  {
    name: 'fast_float',
    licence: 'MIT',
    source: 'https://github.com/fastfloat/fast_float',
    headers: /^fast_float\//,
    copyright: debian('libfast-float-dev'),
  },
  {
    name: 'nlohmann-json',
    licence: 'MIT',
    source: 'https://github.com/nlohmann/json',
    headers: /^nlohmann\//,
    copyright: debian('nlohmann-json3-dev'),
  },
  {
    name: 'Emscripten, with its C library (musl), C++ library and runtime (LLVM), and dlmalloc',
    licence: 'MIT, Apache-2.0 with LLVM exception',
    source: 'https://github.com/emscripten-core/emscripten',
    headers: /^(emscripten|[a-z0-9_]+(\.h)?$)/,
    copyright: debian('emscripten'),
    files: /^(\*|src\/.*|system\/lib\/(libc|libcxx|libcxxabi|compiler-rt|dlmalloc)\b.*)$/,
  },
];

/** @param {string} stanza @param {string} field @returns {string} */
const fieldOf = (stanza, field) => new RegExp(`^${field}:((?:.*\\n?)(?: .*\\n?)*)`, 'm').exec(stanza)?.[1].trim() ?? '';

/**
 * What a copyright file in Debian's format says of some of its files: their stanzas, and the licences these name.
 * @param {string} text
 * @param {RegExp} files
 * @returns {string}
 */
export function stanzasOf(text, files) {
  const stanzas = text.split(/\n\s*\n/);
  const kept = stanzas.filter((stanza) =>
    fieldOf(stanza, 'Files')
      .split(/\s+/)
      .some((name) => files.test(name)),
  );
  if (!kept.length) throw new Error(`no stanza about ${files}`);
  const named = new Set(
    kept.flatMap((stanza) =>
      fieldOf(stanza, 'License')
        .split('\n')[0]
        .split(/ or | and /),
    ),
  );
  const licences = stanzas.filter(
    (stanza) => /^License:/.test(stanza) && named.has(fieldOf(stanza, 'License').split('\n')[0]),
  );
  return [...kept, ...licences].join('\n\n');
}

/**
 * One notice.
 * @param {{ name: string, licence: string, source: string }} what
 * @param {string} text
 */
export const notice = ({ name, licence, source }, text) =>
  `${'='.repeat(80)}\n${name}\nLicence: ${licence}\nSource: ${source}\n${'='.repeat(80)}\n\n${text.trim()}\n`;

/** @param {string} file @param {string} name @returns {string} */
function read(file, name) {
  if (!existsSync(file)) throw new Error(`${file} does not exist, so that nothing can be said of ${name}`);
  return readFileSync(file, 'utf8');
}

/** The notices of the module. */
export function moduleNotices() {
  const own = read(path.join(root, 'LICENSE'), 'this project');
  const others = libraries.map((library) => {
    const text = read(library.copyright, library.name);
    const texts = (library.texts ?? []).map((file) => read(file, library.name));
    return notice(library, [library.files ? stanzasOf(text, library.files) : text, ...texts].join('\n\n'));
  });
  return `umbilic\n\n${own.trim()}\n\nIt contains what follows, with its own licences.\n\n${others.join('\n')}`;
}

/** Where the notices of the module are. */
export const noticesFile = path.join(root, 'build/wasm/licences.txt');

/** Writes them, unless they are there already. */
export function writeNotices() {
  const text = moduleNotices();
  if (!existsSync(noticesFile) || readFileSync(noticesFile, 'utf8') !== text) writeFileSync(noticesFile, text);
}

/**
 * A notice for each npm package that has a module in a bundle.
 * @param {Iterable<string>} modules files, as Vite names them
 * @returns {string}
 */
export function packageNotices(modules) {
  /** @type {Set<string>} */
  const folders = new Set();
  for (const id of modules) {
    const folder = /^\0?(.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1];
    if (folder) folders.add(folder);
  }
  return [...folders]
    .sort()
    .map((folder) => {
      const about = JSON.parse(read(path.join(folder, 'package.json'), folder));
      const url = typeof about.repository === 'string' ? about.repository : (about.repository?.url ?? about.homepage);
      const source = url.replace(/^git(\+https)?:/, 'https:');
      const text = read(path.join(folder, 'LICENSE'), about.name);
      return notice({ name: about.name, licence: about.license, source }, text);
    })
    .join('\n');
}
