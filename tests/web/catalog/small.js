// SPDX-License-Identifier: MIT
/**
 * @file A small catalog that has every status, for the tests of the page.
 */

/** @import {Catalog, CatalogEntry, CatalogShape} from '../../../web/files/catalog.js' */

/**
 * @param {string} shape
 * @param {string} functional
 * @param {Partial<CatalogEntry>} [more]
 * @returns {CatalogEntry}
 */
export function entry(shape, functional, more = {}) {
  return {
    shape,
    functional,
    status: 'converged',
    energy: 112.76693,
    error: 0.0076,
    paper: null,
    exact: null,
    group: { name: 'D3h', order: 12 },
    settings: {
      cap: 'smooth',
      cap_rings: 4,
      levels: [0, 3],
      max_iterations: 1000,
      tolerance: 1e-6,
      symmetry: true,
      metric: 'auto',
    },
    energies: {
      bending: 112.76693,
      willmore: 21.9,
      mvs: 300,
      mvs_cross: 4000,
      mehlum_tarrou: 3000,
      second_form_variation: null,
      area: 12,
      gaussian: -4 * Math.PI,
      quadrature_error: 1e-5,
      resolved: true,
    },
    levels: [],
    limit: { status: 'converging', energy: 112.76693, order: 2, error: 0.0076 },
    certificate: null,
    second_family: null,
    minimizer: `${shape}.${functional}.json`,
    level: 3,
    faces: 1536,
    ...more,
  };
}

const cage = /** @type {const} */ ({ family: 'flag', thickness: 1 });

/** @type {Catalog} */
export const catalog = {
  version: '0.1.0',
  functionals: [
    { name: 'bending', weights: { bending: 1 } },
    { name: 'mvs', weights: { mvs: 1 } },
    { name: 'bending_mvs_cross', weights: { bending: 1, mvs_cross: 1 } },
  ],
  shapes: [
    { name: 'two-3', genus: 2, junctions: 2, arms: 3, cage: { generator: 'two-3', ...cage } },
    { name: 'tetrahedron-frame', genus: 3, junctions: 4, arms: 3, cage: { generator: 'tetrahedron-frame', ...cage } },
    { name: 'octahedron-frame', genus: 7, junctions: 6, arms: 4, cage: { generator: 'octahedron-frame', ...cage } },
    { name: 'torus', genus: 1, junctions: 0, arms: 0, cage: { generator: 'torus', ...cage } },
  ],
  starts: [{ shape: 'two-3', functional: 'bending', thickness: 0.5, energy: 112.7675, level: 3 }],
  entries: [
    entry('two-3', 'bending', { paper: 113, exact: 112.766848, exact_source: 'Lawson ξ₂,₁, "W = 21.9085"' }),
    entry('two-3', 'mvs', { status: 'upper_bound', energy: 263.41, error: null, paper: 343 }),
    entry('tetrahedron-frame', 'bending', { energy: 143.78, error: 0.011, group: { name: 'Td', order: 24 } }),
    entry('tetrahedron-frame', 'mvs', { status: 'none_found', energy: null, error: null, minimizer: null }),
    entry('octahedron-frame', 'bending', { energy: 250.35, error: 0.029, group: { name: 'Oh', order: 48 } }),
    entry('octahedron-frame', 'mvs', { status: 'upper_bound', energy: 12.5, error: null }),
    entry('torus', 'bending', { energy: 78.9568, error: 0.0034, group: { name: 'D6h', order: 24 } }),
    entry('torus', 'mvs', { status: 'zero_attained', energy: 0, error: null, exact: 0 }),
    entry('torus', 'bending_mvs_cross', { status: 'infimum_not_attained', energy: 779.2727, error: null }),
  ],
};

/** An open shape, which has an entry for one functional only. @type {CatalogShape} */
export const hole = {
  name: 'hole-5',
  genus: 0,
  junctions: 0,
  arms: 0,
  sides: 5,
  cage: { generator: 'n-sided', segments: [8, 4], radius: 1, sides: 5, rise: 0.25 },
  constraints: { boundary: { condition: 'curvature', loops: [] } },
};

/** @type {Catalog} */
export const catalogWithHole = {
  ...catalog,
  shapes: [...catalog.shapes, hole],
  entries: [
    ...catalog.entries,
    entry('hole-5', 'mvs', { energy: 178.01, error: 0.035, group: { name: 'C5v', order: 10 } }),
  ],
};
