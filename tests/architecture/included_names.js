// SPDX-License-Identifier: MIT
/**
 * @file Every C++ file includes what it uses, itself or through headers of the project. The compiler does not check
 * this, because it compiles the files of a target as one: each file sees what the files before it include.
 */
import path from 'node:path';
import { codeOf, includes } from './cpp_layers.js';
import { matching } from './tree.js';

/** @typedef {import('./tree.js').Files} Files */

/** Names that are declared in exactly one header of a library. */
const declaredBy = {
  algorithm:
    'std:: all_of any_of binary_search clamp copy_if count_if equal fill find find_if for_each is_sorted lexicographical_compare ' +
    'lower_bound max max_element min min_element minmax minmax_element none_of nth_element partition remove_if reverse rotate ' +
    'set_difference set_intersection shuffle sort stable_partition stable_sort transform unique upper_bound',
  array: 'std:: array',
  atomic: 'std:: atomic',
  charconv: 'std:: to_chars',
  chrono: 'std:: chrono',
  cmath:
    'std:: acos asin atan atan2 cbrt ceil copysign cos cosh exp floor fmod frexp hypot ilogb isfinite isinf isnan ldexp llround log ' +
    'log10 log2 lround nextafter pow remainder round scalbn signbit sin sinh sqrt tan tanh trunc',
  complex: 'std:: complex',
  cstring: 'std:: memcmp memcpy memmove memset strlen',
  deque: 'std:: deque',
  filesystem: 'std:: filesystem',
  fstream: 'std:: ifstream ofstream',
  functional: 'std:: function',
  iostream: 'std:: cerr cin cout',
  limits: 'std:: numeric_limits',
  map: 'std:: map multimap',
  memory: 'std:: make_shared make_unique shared_ptr unique_ptr weak_ptr',
  mutex: 'std:: lock_guard mutex scoped_lock unique_lock',
  numbers: 'std:: numbers',
  numeric: 'std:: accumulate gcd inner_product iota lcm',
  optional: 'std:: nullopt optional',
  queue: 'std:: priority_queue queue',
  random: 'std:: mt19937 mt19937_64 normal_distribution uniform_int_distribution uniform_real_distribution',
  set: 'std:: multiset set',
  span: 'std:: span',
  sstream: 'std:: istringstream ostringstream stringstream',
  string: 'std:: string to_string',
  string_view: 'std:: string_view',
  thread: 'std:: thread this_thread',
  tuple: 'std:: tie tuple',
  unordered_map: 'std:: unordered_map',
  unordered_set: 'std:: unordered_set',
  variant: 'std:: variant',
  vector: 'std:: vector',
  'fmt/format.h': 'fmt:: format format_to',
  'Eigen/Cholesky': 'Eigen:: LDLT LLT',
  'Eigen/Eigenvalues': 'Eigen:: EigenSolver GeneralizedSelfAdjointEigenSolver SelfAdjointEigenSolver',
  'Eigen/Geometry': 'Eigen:: AngleAxisd Quaterniond',
  'Eigen/QR': 'Eigen:: ColPivHouseholderQR HouseholderQR',
  'Eigen/SVD': 'Eigen:: BDCSVD JacobiSVD',
  'Eigen/SparseCore': 'Eigen:: SparseMatrix Triplet',
};

/** @type {Map<string, string>} from a name with its namespace to its header */
const headerOf = new Map(
  Object.entries(declaredBy).flatMap(([header, list]) => {
    const [namespace, ...names] = list.split(' ');
    return names.map((name) => /** @type {[string, string]} */ ([namespace + name, header]));
  }),
);

/**
 * The types and constants that a file of the project declares outside of functions and types. Functions are left out,
 * because members and variables often have the same names.
 * @param {string} code
 * @returns {string[]}
 */
const declarations = (code) =>
  [
    ...code.matchAll(
      /^(?:template <[^\n]*>\s*)?(?:struct|class|union|enum class|enum) (?:\[\[\w+\]\] )?(\w+)(?=[^;\n]*[{\n])/gm,
    ),
    ...code.matchAll(/^(?:template <[^\n]*>\s*)?using (\w+) =/gm),
    ...code.matchAll(/^(?:inline )?(?:constexpr|const) [^=;{}()\n]*?\b(k[A-Z]\w*)/gm),
    ...code.matchAll(/^(?:TEST|TEST_F|TEST_P|TYPED_TEST|INSTANTIATE_TEST_SUITE_P)\((\w+)/gm),
  ].map(([, name]) => name);

/**
 * @param {Files} files
 * @returns {string[]} the problems, one line each
 */
export function missingIncludes(files) {
  const sources = new Map(matching(files, /^(core|wasm|tests)\/.*\.(h|cpp)$/));
  const codes = new Map([...sources].map(([file, text]) => [file, codeOf(text)]));
  /** @type {Map<string, Set<string>>} from a type's or a constant's name to the headers that declare it */
  const owners = new Map();
  for (const [file, code] of codes) {
    if (!file.endsWith('.h')) continue;
    for (const name of declarations(code)) owners.set(name, (owners.get(name) ?? new Set()).add(file));
  }

  /** @param {string} name as included @param {string} from @returns {string} the file, or the name itself if no file of the project has it */
  const find = (name, from) =>
    [`core/${name}`, `tests/core/${name}`, name, path.posix.join(path.posix.dirname(from), name)].find((candidate) =>
      sources.has(candidate),
    ) ?? name;
  /** @param {string} file @param {Set<string>} seen @returns {Set<string>} all that it includes, directly or through the project's headers */
  const reach = (file, seen = new Set()) => {
    for (const { name } of includes(sources.get(file) ?? '')) {
      const found = find(name, file);
      if (seen.has(found)) continue;
      seen.add(found);
      reach(found, seen);
    }
    return seen;
  };

  return [...codes].flatMap(([file, code]) => {
    const reached = reach(file);
    const own = new Set(declarations(code));
    const problems = new Set();
    for (const [name] of code.matchAll(/\b(std|fmt|Eigen)::\w+/g)) {
      const header = headerOf.get(name);
      if (header && !reached.has(header)) problems.add(`${file} uses ${name} without <${header}>`);
    }
    for (const [, name] of code.matchAll(/(?<![\w.]|->|::)([A-Z]\w+|k[A-Z]\w*)\b/g)) {
      const headers = [...(owners.get(name) ?? [])];
      if (!headers.length || own.has(name)) continue;
      // The name is only declared here: forward, as a template parameter, or inside something else.
      if (new RegExp(`\\b(class|struct|typename|using|int|double) ${name}\\b`).test(code)) continue;
      if (!headers.some((header) => header === file || reached.has(header))) {
        problems.add(`${file} uses ${name} without "${headers[0]}"`);
      }
    }
    return [...problems];
  });
}
