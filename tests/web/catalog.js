// SPDX-License-Identifier: MIT
/**
 * @file A small catalog for the tests of the pages that show it; its numbers are made up.
 */
import { parseReport } from '../../web/files/catalog.js';

/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */
/** @typedef {import('../../web/files/catalog.js').CatalogEntry} CatalogEntry */
/** @typedef {import('../../wasm/types.js').Report} Report */

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
    energy: 112.767,
    error: 0.0076,
    paper: 113,
    exact: 112.766848,
    group: { name: 'D3h', order: 12 },
    settings: options(),
    energies: {
      bending: 112.7675,
      willmore: 21.9,
      mvs: 3148,
      mvs_cross: 8937,
      mehlum_tarrou: 3330,
      second_form_variation: null,
      area: 0.295,
      gaussian: -12.566,
      quadrature_error: 1e-5,
      resolved: true,
    },
    levels: [3, 4].map((level) => ({
      level,
      patches: 24 * 4 ** level,
      unknowns: 407,
      energy: 112.767,
      energy_reported: 112.7675,
      iterations: 50,
      evaluations: 57,
      seconds: null,
      stop: 'converged',
      metric: 'hessian',
      metrics: 3,
      factorizations: 3,
      quadrature: 0,
      evaluable: true,
      cap_rings: 4,
      credible: true,
      thickened: false,
      predicted_decrease: 1e-5,
    })),
    limit: { status: 'converging', energy: 112.767, order: 5.7, error: 0.0076 },
    certificate: { level: 3, unknowns: 4602, gauge: 10, tau: 0.001, negative: 0 },
    second_family: null,
    minimizer: `${shape}.${functional}.json`,
    level: 4,
    faces: 6144,
    ...more,
  };
}

/** @returns {Catalog} */
export function catalog() {
  return {
    version: '1.2.3',
    functionals: [
      { name: 'bending', weights: { bending: 1 } },
      { name: 'mvs', weights: { mvs: 1 } },
      { name: 'bending_mvs_cross', weights: { bending: 1, mvs_cross: 1 } },
    ],
    shapes: [
      { name: 'two-3', genus: 2, junctions: 2, arms: 3, cage: { generator: 'two-3', family: 'flag', thickness: 1 } },
      { name: 'sphere', genus: 0, junctions: 0, arms: 0, cage: { generator: 'cube', family: 'flag', thickness: 1 } },
    ],
    starts: [],
    entries: [
      entry('two-3', 'bending'),
      entry('two-3', 'mvs', {
        minimizer: null,
        status: 'none_found',
        energy: null,
        error: null,
        reason: 'All collapsed.',
      }),
      entry('two-3', 'bending_mvs_cross', { energies: { ...entry('a', 'b').energies, bending: 150, mvs_cross: 4000 } }),
      entry('sphere', 'bending'),
    ],
  };
}

/** @returns {Required<Omit<import('../../wasm/types.js').Options, 'accuracy' | 'second_opinion'>>} */
const options = () => ({
  cap: 'smooth',
  cap_rings: 4,
  levels: [0, 4],
  max_iterations: 500,
  tolerance: 1e-7,
  symmetry: true,
  metric: 'auto',
});

/** @param {string} [shape] @param {string} [functional] @returns {Report} of an entry, whose surface has four points */
export function report(shape = 'two-3', functional = 'bending') {
  const { functionals, shapes } = catalog();
  const { energies, levels, limit, certificate, group } = entry(shape, functional);
  const found = shapes.find(({ name }) => name === shape) ?? shapes[0];
  return parseReport(
    JSON.stringify({
      umbilic: 'report',
      version: 1,
      program: '1.2.3',
      instruction_set: '',
      problem: {
        cage: found.cage,
        terms: functionals.find(({ name }) => name === functional)?.weights,
        constraints: {},
        options: options(),
      },
      ...{ group, levels, limit, energies, certificate },
      surface: { level: 4, points: Array.from({ length: 12 }, (_, i) => i / 7) },
    }),
  );
}
