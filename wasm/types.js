// SPDX-License-Identifier: MIT
/**
 * @file The types of the core's JavaScript face, umbilic.js; nothing here runs.
 */

/** @typedef {'bending'|'willmore'|'mvs'|'mvs_cross'|'mehlum_tarrou'|'second_form_variation'} FunctionalName */
/** @typedef {'none'|'flat'|'smooth'} CapName */
/** @typedef {'prepare'|'minimize'|'report'|'done'} Phase */
/**
 * @typedef {'converged'|'max_iterations'|'line_search_stalled'|'round_off'|'not_finite'|'degenerate'|'cancelled'}
 * StopReason
 */

/**
 * @typedef {object} MinimizerOptions
 * @property {Partial<Record<FunctionalName, number>>} weights non-negative, not all zero
 * @property {CapName} [cap] default 'smooth'
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
 * @property {number} energy of the best surface of this level; NaN before the first evaluation
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
 */

/**
 * @typedef {Record<FunctionalName | 'area' | 'gaussian' | 'quadratureError', number>} Energies NaN where a quantity
 * diverges
 */

/** @typedef {{vertices: number, edges: number, faces: number, components: number, genus: number}} CageCounts */

/**
 * A mesh copied out of the core, fit to be transferred. `normals` and `curvatures` (κ1 ≥ κ2 per vertex, positive
 * where a sphere's are) are empty for control meshes.
 * @typedef {object} Mesh
 * @property {Float32Array} positions 3 per vertex
 * @property {Float32Array} normals 3 per vertex
 * @property {Float32Array} curvatures 2 per vertex
 * @property {Uint32Array} triangles 3 per triangle
 * @property {Uint32Array} edges 2 per edge, each edge once
 */

export {};
