// SPDX-License-Identifier: MIT
/**
 * @file Checks on the layers of the C++ core: who may include what, what only the command line may use, and CMake's
 * link graph. Every check returns the problems that it finds, one line each.
 */
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/**
 * The layers, from the top (base) to the bottom (cli) as in the README, and the layers to which each is linked. A layer
 * may include itself, these layers, and what they may include. So solve, which is linked only to base, knows no surfaces.
 * @type {Record<string, string[]>}
 */
export const linked = {
  base: [],
  cage: ['base'],
  mesh: ['cage'],
  surface: ['mesh'],
  energy: ['surface'],
  solve: ['base'],
  optimize: ['energy', 'solve'],
  problem: ['optimize'],
  opinion: ['mesh'],
  driver: ['problem', 'opinion'],
  catalog: ['driver'],
  cli: ['catalog'],
};

export const layers = Object.keys(linked);

/** The layer of second implementations, with which the tests of every layer may compare. */
const forComparison = 'opinion';

/** @param {string} layer @returns {Set<string>} what it may include */
function visibleFrom(layer) {
  return new Set([layer, ...linked[layer].flatMap((above) => [...visibleFrom(above)])]);
}

/**
 * @param {string} text C++
 * @returns {{ name: string, quoted: boolean }[]} what it includes
 */
export function includes(text) {
  return [...text.matchAll(/^[ \t]*#[ \t]*include[ \t]*(<|")([^>"\n]+)[>"]/gm)].map(([, mark, name]) => ({
    name,
    quoted: mark === '"',
  }));
}

/** @param {string} text C++ @returns {string} without comments, strings and characters */
export function codeOf(text) {
  return text.replace(/"(?:\\.|[^"\\\n])*"|'(?:\\[^'\n]+|[^'\\\n])'|\/\/.*|\/\*[\s\S]*?\*\//g, '""');
}

/**
 * A layer's files and its tests include from the core only their own layer and those that it may include, by paths from
 * core/.
 * @param {Files} files
 * @returns {string[]}
 */
export function upwardIncludes(files) {
  const problems = [];
  for (const [file, text] of matching(files, /^(tests\/)?core\/.*\.(h|cpp)$/)) {
    const isTest = file.startsWith('tests/');
    const [layer, rest] = file.replace(/^(tests\/)?core\//, '').split('/');
    if (rest === undefined) {
      if (!isTest) problems.push(`${file} is in no layer`);
      continue;
    }
    if (!layers.includes(layer)) {
      if (!isTest) problems.push(`${file}: ${layer} is not a layer`);
      continue;
    }
    const visible = visibleFrom(layer);
    if (isTest) visible.add(forComparison);
    for (const { name, quoted } of includes(text)) {
      const other = name.split('/')[0];
      const isLayer = layers.includes(other);
      if (isLayer && !visible.has(other)) problems.push(`${file} includes ${name} from a layer that is not above it`);
      else if (isLayer && !quoted) problems.push(`${file} includes ${name} with angle brackets`);
      else if (quoted && !isTest && !isLayer) problems.push(`${file} includes "${name}", which is no path from core/`);
    }
  }
  return problems;
}

/**
 * The C API includes the driver and the layers that it may include, not the command line.
 * @param {Files} files
 * @returns {string[]}
 */
export function apiIncludes(files) {
  const allowed = [...layers.slice(0, layers.indexOf('driver') + 1), 'wasm'];
  return matching(files, /^wasm\/.*\.(h|cpp)$/).flatMap(([file, text]) =>
    includes(text)
      .filter(({ name, quoted }) =>
        quoted && name.includes('/') ? !allowed.includes(name.split('/')[0]) : name === 'cli',
      )
      .map(({ name }) => `${file} includes ${name}`),
  );
}

/**
 * Streams and files are for the command line only. The JSON library, which takes seconds to compile, is for the one
 * file that parses JSON, for the command line and for the catalog.
 * @param {Files} files
 * @returns {string[]}
 */
export function hostLibraries(files) {
  const forbidden =
    /^((io|i|o|f|s)stream|iomanip|filesystem|locale|clocale|fmt\/(ostream|std)\.h|(nlohmann|CLI|emscripten)\/.*)$/;
  const mayKnowJson = /^core\/(catalog\/|problem\/json_node\.cpp$)/;
  return matching(files, /^(core\/(?!cli\/)|wasm\/).*\.(h|cpp)$/).flatMap(([file, text]) =>
    includes(text)
      .filter(({ name }) => forbidden.test(name) && !(mayKnowJson.test(file) && /^nlohmann\//.test(name)))
      .map(({ name }) => `${file} includes ${name}`),
  );
}

/**
 * Numbers are parsed and printed independently of the locale.
 * @param {Files} files
 * @returns {string[]}
 */
export function localeDependence(files) {
  const forbidden = /\b(strto(?:d|f|ld)|sto(?:d|f|ld)|atof|[sf]?scanf|v?s?n?printf|setlocale)\s*\(/;
  return matching(files, /^(core|wasm)\/.*\.(h|cpp)$/).flatMap(([file, text]) => {
    const found = forbidden.exec(codeOf(text));
    return found ? [`${file} calls ${found[1]}, which depends on the locale`] : [];
  });
}

/**
 * The linker gives a WebAssembly module without shared memory no place for what each thread has of its own.
 * @param {Files} files
 * @returns {string[]}
 */
export function threadLocals(files) {
  return matching(files, /^(core|wasm)\/.*\.(h|cpp)$/).flatMap(([file, text]) =>
    /\b(thread_local|__thread)\b/.test(codeOf(text)) ? [`${file} has a thread_local variable`] : [],
  );
}

/** @param {string} layer @returns {string} its CMake target; that of the command line is the program itself */
export function target(layer) {
  return layer === 'cli' ? 'umbilic' : `umbilic_${layer}`;
}

/**
 * CMake links the target of each layer to those named in `linked`, to its own kernels and the settings, and to nothing
 * else of the project. The C API is linked to the driver, and kernels only to the settings.
 * @param {string} graph what `cmake --graphviz` writes
 * @returns {string[]}
 */
export function linkOrder(graph) {
  const links = [...graph.matchAll(/\/\/ (umbilic\w*) -> (umbilic\w*)$/gm)]
    .map(([, from, to]) => ({ from, to }))
    .filter(({ to }) => to !== 'umbilic_settings');
  /** @type {Record<string, string[]>} */
  const expected = { umbilic_api: ['umbilic_driver'] };
  for (const [layer, above] of Object.entries(linked)) expected[target(layer)] = above.map(target);
  const kernels = /^(umbilic_\w+)_(portable|avx2|avx512)$/;
  const problems = links
    .filter(({ from, to }) => kernels.test(from) && !/^umbilic_(sanitizers|for_\w+)$/.test(to))
    .map(({ from, to }) => `${from} links ${to}`);
  for (const [name, above] of Object.entries(expected)) {
    const found = links.filter(({ from, to }) => from === name && kernels.exec(to)?.[1] !== name).map(({ to }) => to);
    if (found.sort().join() !== above.sort().join()) {
      problems.push(`${name} links ${found.join(', ') || 'nothing'}, not ${above.join(', ')}`);
    }
  }
  return problems;
}
