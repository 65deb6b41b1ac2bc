// SPDX-License-Identifier: MIT
/**
 * @file Symbols and formulas of the third-order invariants that are evaluated and never minimized.
 */

/** @import {InvariantName} from '../../wasm/types.js' */

/**
 * `formula` has subscripts and superscripts as `_{ij}` and `^{3/2}`. Its power of the area A makes it independent of size; C
 * is ∇II, and II is positive where a surface bends away from its outward normal.
 * @typedef {{id: InvariantName, symbol: string, formula: string}} InvariantWords
 */

/** @type {InvariantWords[]} */
export const invariants = [
  { id: 'gradient_form', symbol: 'J₃', formula: 'A^{3/2} ∫ II(2∇H, 2∇H) dA' },
  { id: 'variation_form', symbol: 'J₄', formula: 'A^{3/2} ∫ II_{ij}C_{ikl}C_{jkl} dA' },
  { id: 'triple_form', symbol: 'J₆', formula: 'A^{5/2} ∫ II_{ia}II_{jb}II_{kc}C_{ijk}C_{abc} dA' },
];

/** What they are, and why they stand apart from the functionals. */
export const invariantsNote =
  'With C = ∇II. They change sign when the normal flips, so they are evaluated and never minimized; the powers of the area A make them independent of size.';
