// SPDX-License-Identifier: MIT
/**
 * @file What keeps instructions that a processor lacks away from it: of the code compiled for an instruction set, nothing but what its namespace
 * holds may be merged by the linker. Every check returns the problems that it finds, one line each.
 */

/** As core/base/instruction_set.h names them; portable code runs everywhere. */
export const instructionSets = ['avx2', 'avx512'];

/**
 * Of equal weak functions (templates, inline functions) the linker keeps one for the whole program, whatever it was compiled for.
 * @param {string} set
 * @param {string} listing what `nm --demangle --defined-only` writes of the set's objects
 * @returns {string[]}
 */
export function sharedFunctions(set, listing) {
  const symbols = [...listing.matchAll(/^[0-9a-f]* *([A-Za-z]) (.+)$/gm)];
  const own = new RegExp(`\\bumbilic::${set}::`);
  return symbols.filter(([, kind, name]) => /[Wwi]/.test(kind) && !own.test(name)).map(([, , name]) => name);
}

/**
 * Kernels include the core's headers that include no library, themselves, and nothing that defines functions.
 * @param {import('./tree.js').Files} files
 * @returns {string[]}
 */
export function kernelIncludes(files) {
  /** @type {Set<string>} */
  const seen = new Set();
  /** @type {string[]} */
  const problems = [];
  /** @param {string} file */
  const visit = (file) => {
    if (seen.has(file)) return;
    seen.add(file);
    for (const [, mark, name] of (files.get(file) ?? '').matchAll(/^[ \t]*#[ \t]*include[ \t]*(<|")([^>"\n]+)[>"]/gm)) {
      if (mark === '"') visit(`core/${name}`);
      else if (!/^(cstddef|wasm_simd128\.h)$/.test(name))
        problems.push(`${file}, which kernels include, includes <${name}>`);
    }
  };
  for (const file of files.keys()) if (/^core\/\w+\/kernels\//.test(file)) visit(file);
  return problems;
}
