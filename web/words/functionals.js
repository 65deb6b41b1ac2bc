// SPDX-License-Identifier: MIT
/**
 * @file Names and descriptions of functionals, caps, stop reasons and phases on the page.
 */

/** @import {CapName, FunctionalName, StopReason, Terms} from '../../wasm/types.js' */

/**
 * @typedef {object} FunctionalWords
 * @property {FunctionalName} id
 * @property {string} name
 * @property {string} short used in sums of several functionals
 * @property {string} formula
 * @property {string} prefers a sentence for everyone: what its minimizers look like
 * @property {string} taste a line for those who know curvature: what costs nothing
 * @property {string | null} pictured the catalog’s functional with the same minimizers; null if it has none
 * @property {0 | 1 | 2} areaPower the power of the area A that is its factor; above 0 it integrates curvature derivatives
 */

/** @type {FunctionalWords[]} */
export const functionals = [
  {
    id: 'bending',
    name: 'Bending energy',
    short: 'Bending',
    formula: '∫ κ₁² + κ₂² dA',
    prefers: 'Bends as little as it can: round bodies with small holes.',
    pictured: 'bending',
    taste: 'Penalizes curvature itself: round and economical.',
    areaPower: 0,
  },
  {
    id: 'willmore',
    name: 'Willmore energy',
    short: 'Willmore',
    formula: '∫ H² dA',
    prefers: 'Prefers the same shapes as bending: round bodies with small holes.',
    pictured: 'bending',
    taste: 'A quarter of bending, up to a constant of the topology: the same minimizers.',
    areaPower: 0,
  },
  {
    id: 'mvs',
    name: 'Minimum variation (MVS)',
    short: 'MVS',
    formula: 'A ∫ (dκ₁/de₁)² + (dκ₂/de₂)² dA',
    prefers: 'Keeps curvature even along its own lines: rings, tubes and spheres cost nothing, so arms may thin out.',
    pictured: 'mvs',
    taste: 'Each principal curvature constant along its own line: spheres, tori and Dupin cyclides are free.',
    areaPower: 1,
  },
  {
    id: 'mvs_cross',
    name: 'MVS with cross terms',
    short: 'MVS cross',
    formula: 'A ∫ |∇κ₁|² + |∇κ₂|² dA',
    prefers: 'Keeps curvature even in all directions: wide holes and even arms.',
    pictured: 'mvs_cross',
    taste: 'Both principal curvatures constant in every direction: only spheres are free.',
    areaPower: 1,
  },
  {
    id: 'mehlum_tarrou',
    name: 'Mehlum–Tarrou',
    short: 'Mehlum–Tarrou',
    formula: 'A ∫ mean over directions of (dκₙ/ds)² dA',
    prefers: 'Keeps curvature even on average over all directions: wide holes between fuller corners.',
    pictured: 'mehlum_tarrou',
    taste: 'The variation of normal curvature, averaged over all directions.',
    areaPower: 1,
  },
  {
    id: 'second_form_variation',
    name: 'Variation of the second form',
    short: 'Second form',
    formula: 'A ∫ |∇II|² dA',
    prefers: 'Keeps the way the surface bends even as a whole: wide holes and even arms.',
    pictured: 'second_form_variation',
    taste: 'The covariant derivative of the second fundamental form: smooth even at umbilics.',
    areaPower: 1,
  },
  {
    id: 'mean_curvature_variation',
    name: 'Variation of mean curvature',
    short: 'Mean curvature',
    formula: 'A ∫ 4 |∇H|² dA',
    prefers: 'Keeps the mean of both curvatures even: rounded parts, which thin necks may join.',
    pictured: null,
    taste: 'Mean curvature constant everywhere: only spheres are free, and spheres joined by thin necks come close.',
    areaPower: 1,
  },
  {
    id: 'curvedness_variation',
    name: 'Variation of curvedness',
    short: 'Curvedness',
    formula: 'A² ∫ |∇ ½(κ₁² + κ₂²)|² dA',
    prefers: 'Bends about as much everywhere, whether outward or like a saddle.',
    pictured: null,
    taste: 'As much bending everywhere, whether round or saddle: only spheres are free, and thin tori come close.',
    areaPower: 2,
  },
];

/** What a blend of several prefers. @type {Pick<FunctionalWords, 'prefers' | 'taste' | 'pictured'>} */
export const blendWords = {
  prefers: 'A weighted sum: shapes between those that its parts prefer.',
  taste: 'Functionals that integrate the change of curvature carry the area A as a factor.',
  pictured: 'bending_mvs_cross',
};

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

/** What the numbers of an energy's density are. @param {Terms} terms @returns {string} */
export function densityUnit(terms) {
  const words = /** @type {FunctionalName[]} */ (Object.keys(terms)).map(functionalWords);
  const factors = words.some(({ areaPower }) => areaPower > 0) ? ' with the factor A' : '';
  return `energy per area: ${words.map(({ short }) => short).join(' + ')}${factors}, in 1/length²`;
}

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
