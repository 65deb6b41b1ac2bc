// SPDX-License-Identifier: MIT
/**
 * @file Names and descriptions of functionals, caps, stop reasons and phases on the page.
 */

/** @import {CapName, FunctionalName, StopReason} from '../../wasm/types.js' */

/**
 * @typedef {object} FunctionalWords
 * @property {FunctionalName} id
 * @property {string} name
 * @property {string} short used in sums of several functionals
 * @property {string} formula
 * @property {string} taste one line: what its minimizers look like
 * @property {0 | 1 | 2} areaPower the power of the area A that is its factor; above 0 it integrates curvature derivatives
 */

/** @type {FunctionalWords[]} */
export const functionals = [
  {
    id: 'bending',
    name: 'Bending energy',
    short: 'Bending',
    formula: '∫ κ₁² + κ₂² dA',
    taste: 'Penalizes curvature itself: round and economical.',
    areaPower: 0,
  },
  {
    id: 'willmore',
    name: 'Willmore energy',
    short: 'Willmore',
    formula: '∫ H² dA',
    taste: 'A quarter of bending, up to a constant of the topology: the same minimizers.',
    areaPower: 0,
  },
  {
    id: 'mvs',
    name: 'Minimum variation (MVS)',
    short: 'MVS',
    formula: 'A ∫ (dκ₁/de₁)² + (dκ₂/de₂)² dA',
    taste: 'Each principal curvature constant along its own line: spheres, tori and Dupin cyclides are free.',
    areaPower: 1,
  },
  {
    id: 'mvs_cross',
    name: 'MVS with cross terms',
    short: 'MVS cross',
    formula: 'A ∫ |∇κ₁|² + |∇κ₂|² dA',
    taste: 'Both principal curvatures constant in every direction: only spheres are free.',
    areaPower: 1,
  },
  {
    id: 'mehlum_tarrou',
    name: 'Mehlum–Tarrou',
    short: 'Mehlum–Tarrou',
    formula: 'A ∫ mean over directions of (dκₙ/ds)² dA',
    taste: 'The variation of normal curvature, averaged over all directions.',
    areaPower: 1,
  },
  {
    id: 'second_form_variation',
    name: 'Variation of the second form',
    short: 'Second form',
    formula: 'A ∫ |∇II|² dA',
    taste: 'The covariant derivative of the second fundamental form: smooth even at umbilics.',
    areaPower: 1,
  },
  {
    id: 'mean_curvature_variation',
    name: 'Variation of mean curvature',
    short: 'Mean curvature',
    formula: 'A ∫ 4 |∇H|² dA',
    taste: 'Mean curvature constant everywhere: only spheres are free, and spheres joined by thin necks come close.',
    areaPower: 1,
  },
  {
    id: 'curvedness_variation',
    name: 'Variation of curvedness',
    short: 'Curvedness',
    formula: 'A² ∫ |∇ ½(κ₁² + κ₂²)|² dA',
    taste: 'As much bending everywhere, whether round or saddle: only spheres are free, and thin tori come close.',
    areaPower: 2,
  },
];

/** @param {FunctionalName} id @returns {FunctionalWords} */
export function functionalWords(id) {
  const found = functionals.find((functional) => functional.id === id);
  if (!found) throw new Error(`no functional is called ${id}`);
  return found;
}

/** @type {Array<{id: CapName, name: string, meaning: string}>} */
export const caps = [
  {
    id: 'smooth',
    name: 'Smooth',
    meaning: 'Blends in a polynomial over up to four rings around each extraordinary vertex. Energies converge.',
  },
  {
    id: 'flat',
    name: 'Flat',
    meaning: 'The method of the paper: blends in the tangent plane over one ring. Energies depend on the cage.',
  },
  {
    id: 'none',
    name: 'None',
    meaning: 'The bare limit surface. Right for bending and Willmore only; curvature variation diverges.',
  },
];

/** @type {Record<StopReason | 'interrupted', string>} */
export const stopWords = {
  converged: 'converged',
  max_iterations: 'iteration limit',
  line_search_stalled: 'no better step found',
  round_off: 'round-off reached',
  not_finite: 'not finite',
  degenerate: 'surface collapsed',
  cancelled: 'cancelled',
  below_bound: 'below the bound',
  not_resolved: 'unresolved',
  interrupted: 'interrupted',
};
