// SPDX-License-Identifier: MIT
/**
 * @file The types of the core's JavaScript face, umbilic.js; nothing here runs.
 */

/** @typedef {'bending'|'willmore'|'mvs'|'mvs_cross'|'mehlum_tarrou'|'second_form_variation'} FunctionalName */
/** @typedef {'none'|'flat'|'smooth'} CapName */
/** @typedef {'auto'|'identity'|'sobolev'|'hessian'} MetricName */
/** @typedef {'prepare'|'minimize'|'report'|'done'} Phase */
/**
 * @typedef {'converged'|'max_iterations'|'line_search_stalled'|'round_off'|'not_finite'|'degenerate'|'cancelled'|
 *   'below_bound'|'not_whole'} StopReason
 */

/**
 * @typedef {object} MinimizerOptions
 * @property {Partial<Record<FunctionalName, number>>} weights non-negative, not all zero
 * @property {CapName} [cap] default 'smooth'
 * @property {boolean} [symmetry] whether the surface keeps the cage's; default true
 * @property {MetricName} [metric] default 'auto'
 * @property {[number, number]} [levels] first and last, in Catmull-Clark steps from the cage; default [0, 2]
 * @property {number} [maxIterations] per level; default 1000
 * @property {number} [tolerance] default 1e-6
 */

/**
 * @typedef {object} Progress
 * @property {Phase} phase
 * @property {number} level
 * @property {number} iterations in this level
 * @property {number} evaluations in this level
 * @property {number} totalEvaluations over all levels
 * @property {number} energy of the best surface of this level; NaN before the first evaluation. It rises only where the
 *   level goes on with a finer quadrature rule
 * @property {number} gradientNorm of the best surface
 * @property {number} predictedDecrease what the level can still gain; NaN before the first iteration
 */

/**
 * @typedef {object} LevelReport
 * @property {number} level
 * @property {number} patches
 * @property {number} unknowns
 * @property {number} energy by the minimizing rule
 * @property {number} energyReported by the reporting rule
 * @property {number} iterations
 * @property {number} evaluations
 * @property {number} seconds
 * @property {StopReason} stop
 * @property {Exclude<MetricName, 'auto'>} metric
 * @property {number} metrics how often the metric was built
 * @property {boolean} evaluable whether the mesh that was moved is the one that the surface was evaluated on; coarser
 *   ones only prepare the first of these
 * @property {number} quadrature steps by which its quadrature rules became finer than usual, because the surface made
 *   use of their error
 */

/**
 * The symmetry that a run keeps: its Schoenflies symbol, C1 where there is none, and its order.
 * @typedef {{name: string, order: number}} Group
 */

/** @typedef {'converging'|'too_few_levels'|'not_minimized'|'not_converging'|'not_whole'} LimitStatus */

/**
 * What the levels say about the limit of their energies. Unless they converge, `energy` is the least level's and `error`
 * NaN.
 * @typedef {object} Limit
 * @property {LimitStatus} status
 * @property {number} energy
 * @property {number} order observed; NaN where it cannot be told
 * @property {number} error the limit is within energy ± error
 */

/**
 * @typedef {object} CertificateReport
 * @property {number} level
 * @property {number} unknowns of the full Hessian, whatever symmetry the surface has
 * @property {number} gauge directions along which the energy cannot change, removed
 * @property {number} tau eigenvalues below -tau, relative to the Sobolev product, count as negative
 * @property {number} negative directions along which the energy decreases to second order
 */

/**
 * @typedef {Record<FunctionalName | 'area' | 'gaussian' | 'quadratureError', number>} Energies NaN where a quantity
 * diverges
 */

/**
 * The torus of revolution of least energy. `ratio` is NaN where all have the same, and 0 where the energy is an infimum
 * that thinner and thinner tori approach but none attains.
 * @typedef {{ratio: number, energy: number, attained: boolean}} TorusMinimizer
 */

/** @typedef {{vertices: number, edges: number, faces: number, components: number, genus: number}} CageCounts */

/**
 * A mesh copied out of the core, fit to be transferred. `normals` and `curvatures` (κ1 ≥ κ2 per vertex, positive
 * where a sphere's are) are empty for control meshes, `edges` for limit meshes.
 * @typedef {object} Mesh
 * @property {Float32Array} positions 3 per vertex
 * @property {Float32Array} normals 3 per vertex
 * @property {Float32Array} curvatures 2 per vertex
 * @property {Uint32Array} triangles 3 per triangle
 * @property {Uint32Array} edges 2 per edge, each edge once
 */

export {};
