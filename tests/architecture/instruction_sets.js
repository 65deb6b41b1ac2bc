// SPDX-License-Identifier: MIT
/**
 * @file Checks that no processor gets instructions that it lacks: the linker may merge code compiled for an instruction
 * set only within the namespace of that set. Every check returns the problems that it finds, one line each.
 */

/** The names in core/base/instruction_set.h, without the portable one, whose code runs everywhere. */
export const instructionSets = ['avx2', 'avx512'];

/**
 * The linker keeps only one of several equal weak functions (templates, inline functions), for whatever instruction set
 * it was compiled.
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
 * Kernels include only headers of the core, and these include no library: its inline functions would be compiled for
 * the instruction set too.
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
