// SPDX-License-Identifier: MIT
/**
 * @file Checks on the layers of the JavaScript: one file touches WebAssembly memory, and two load it; only the worker imports it; views
 * import neither; pages do not import each other; and the home page loads neither the core nor three.js. Every check
 * returns the problems that it finds, one line each.
 */
import path from 'node:path';
import { parseAst } from 'vite';
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

const memory = 'wasm/memory.js';
/** What loads the module, and joins its memory. */
const loaders = ['wasm/loading.js', 'wasm/thread.js'];
const gateway = 'wasm/umbilic.js';

/**
 * Calls `visit` for every node of a syntax tree.
 * @param {any} node
 * @param {(node: any) => void} visit
 */
function walk(node, visit) {
  if (Array.isArray(node)) {
    for (const child of node) walk(child, visit);
  } else if (node && typeof node === 'object') {
    if (typeof node.type === 'string') visit(node);
    for (const child of Object.values(node)) walk(child, visit);
  }
}

/**
 * The imports of a file, and what it names by `new URL(…, import.meta.url)`. Relative paths are resolved from the root;
 * packages keep their names.
 * @param {string} file
 * @param {string} text
 * @returns {string[]}
 */
export function imports(file, text) {
  /** @type {string[]} */
  const found = [];
  walk(parseAst(text), (node) => {
    if (/^(Import|Export(Named|All))Declaration$|^ImportExpression$/.test(node.type)) found.push(node.source?.value);
    if (node.type === 'NewExpression' && node.callee.name === 'URL' && node.arguments.length === 2) {
      found.push(node.arguments[0].value);
    }
  });
  return found
    .filter((name) => typeof name === 'string')
    .map((name) => (name.startsWith('.') ? path.posix.join(path.posix.dirname(file), name) : name));
}

/**
 * Only one file uses the module's memory, apart from those that load it.
 * @param {Files} files
 * @returns {string[]}
 */
export function memoryAccess(files) {
  return matching(files, /^(web|wasm|tests\/(core|wasm|web|browser|bench))\/.*\.m?js$/).flatMap(([file, text]) => {
    /** @type {string[]} */
    const problems = [];
    if (file === memory || loaders.includes(file)) return problems;
    walk(parseAst(text), (node) => {
      if (node.type === 'Identifier' && /^(HEAPU?(8|16|32|64)|HEAPF(32|64)|WebAssembly)$/.test(node.name)) {
        problems.push(`${file} uses ${node.name}`);
      }
      if (node.type === 'Literal' && /umbilic-core(-threads)?\.(mjs|wasm)$/.test(String(node.value)))
        problems.push(`${file} names ${node.value}`);
    });
    return problems;
  });
}

/**
 * On the page, only the worker imports from wasm/; and it must do so.
 * @param {Files} files
 * @returns {string[]}
 */
export function wasmImports(files) {
  const users = matching(files, /^web\/.*\.m?js$/).filter(([file, text]) =>
    imports(file, text).some((name) => /^(wasm|build)\//.test(name)),
  );
  const problems = users
    .filter(([file]) => !file.startsWith('web/worker/'))
    .map(([file]) => `${file} imports from wasm/`);
  const some = users.some(([file, text]) => file.startsWith('web/worker/') && imports(file, text).includes(gateway));
  return some ? problems : [...problems, `no file of web/worker/ imports ${gateway}`];
}

/**
 * Views show the state and dispatch actions; they import neither the worker nor the module.
 * @param {Files} files
 * @returns {string[]}
 */
export function viewImports(files) {
  return matching(files, /^web\/(pages\/\w+\/)?views\/.*\.m?js$/).flatMap(([file, text]) =>
    imports(file, text)
      .filter((name) => /^(web\/worker|wasm|build)\//.test(name))
      .map((name) => `${file} imports ${name}`),
  );
}

/**
 * The folders of web/, and what each may import besides itself: first those that work without a browser, last those
 * that show something.
 * @type {Record<string, string[]>}
 */
const layers = {
  words: [],
  colour: [],
  plot: [],
  cage: [],
  address: ['words', 'colour'],
  files: ['words', 'address'],
  scene: ['colour', 'address'],
  pages: [],
  views: ['words', 'colour', 'plot', 'address', 'scene'],
};

/** What the state of a page may import, which is pure. */
const pure = ['words', 'colour', 'cage', 'address', 'worker/protocol.js'];

/**
 * What a page's own folder, pages/<page>/, may import: the common folders, including the files in pages/ itself, and the
 * page's state. Its views may also import the page's own files. Pages do not import each other.
 * @param {string} folder below web/
 * @returns {string[] | undefined} what it may import
 */
function below(folder) {
  const page = /^pages\/[^/]+/.exec(folder)?.[0];
  if (!page) return layers[folder];
  const state = `${page}/state`;
  if (folder === state) return pure;
  const common = [...Object.keys(layers).filter((name) => name !== 'views'), state];
  return folder === page ? common : [...common, 'views', page];
}

/**
 * Every folder of web/ imports only what `layers` allows. The entry points beside the HTML files may import from all.
 * @param {Files} files
 * @returns {string[]}
 */
export function webLayers(files) {
  return matching(files, /^web\/.+\/.*\.m?js$/).flatMap(([file, text]) => {
    const folder = path.posix.dirname(file).replace(/^web\//, '');
    if (folder === 'worker') return [];
    const allowed = below(folder);
    if (!allowed) return [`${file} is in no layer`];
    return imports(file, text)
      .filter((name) => name.startsWith('web/'))
      .map((name) => name.replace(/^web\//, ''))
      .filter((name) => ![folder, ...allowed].some((known) => name === known || path.posix.dirname(name) === known))
      .map((name) => `${file} imports ${name}`);
  });
}

const home = 'web/index.js';

/**
 * The home page loads neither three.js nor the module at once: no chain of static imports leads to them.
 * @param {Files} files
 * @returns {string[]}
 */
export function homeImports(files) {
  /** @type {Map<string, string>} each loaded file, and the file that imports it */
  const loaded = new Map([[home, '']]);
  for (const file of loaded.keys()) {
    walk(parseAst(files.get(file) ?? ''), ({ type, source }) => {
      if (!/^(Import|Export(Named|All))Declaration$/.test(type) || !source) return;
      const relative = source.value.startsWith('.');
      const name = relative ? path.posix.join(path.posix.dirname(file), source.value) : source.value;
      if (!loaded.has(name)) loaded.set(name, file);
    });
  }
  const heavy = /^(three\b|web\/scene\/|web\/worker\/(?!requests\.js)|wasm\/|build\/)/;
  return [...loaded].filter(([name]) => heavy.test(name)).map(([name, file]) => `${file} imports ${name}`);
}
