// SPDX-License-Identifier: MIT
/**
 * @file The types of what goes into the core and comes out of it, with the names of the text form of problems and
 * reports (core/problem/text.h); nothing here runs. Numbers that are not finite are null in the text and NaN here.
 */

/** @typedef {'bending'|'willmore'|'mvs'|'mvs_cross'|'mehlum_tarrou'|'second_form_variation'} FunctionalName */
/** @typedef {'none'|'flat'|'smooth'} CapName */
/** @typedef {'auto'|'identity'|'sobolev'|'hessian'} MetricName */
/** @typedef {'prepare'|'minimize'|'report'|'done'} Phase */
/**
 * @typedef {'converged'|'max_iterations'|'line_search_stalled'|'round_off'|'not_finite'|'degenerate'|'cancelled'|
 *   'below_bound'|'not_whole'} StopReason
 */

/* ---- what is asked ---- */

/**
 * Parameters that a cage does not have are ignored by it.
 * @typedef {object} GeneratedCage
 * @property {string} generator
 * @property {'hub' | 'flag'} [family] of frames
 * @property {number} [thickness] of the arms or the tube, relative to the default
 * @property {number} [spread] of frames with two junctions: distance of the arms from the axis
 * @property {number} [ratio] of the torus: minor radius / major radius
 * @property {[number, number]} [segments] of the torus: around the axis and around the tube
 */

/** The text of an OBJ or OFF file. @typedef {{name?: string, text: string | Uint8Array}} CageText */

/** @typedef {GeneratedCage | CageText} CageInput */

/** Weights of functionals, non-negative, not all zero. @typedef {Partial<Record<FunctionalName, number>>} Terms */

/**
 * @typedef {object} Options
 * @property {CapName} [cap] default 'smooth'
 * @property {[number, number]} [levels] first and last, in Catmull-Clark steps from the cage; default [0, 2]
 * @property {number} [max_iterations] per level; default 1000
 * @property {number} [tolerance] default 1e-6
 * @property {boolean} [symmetry] whether the surface keeps the cage's; default true
 * @property {MetricName} [metric] default 'auto'
 */

/**
 * A surface, as the control points of the first vertex of each orbit of the symmetry that its run keeps.
 * @typedef {{level: number, points: Float64Array | number[]}} SurfaceState
 */

/**
 * @typedef {object} Problem
 * @property {CageInput} cage
 * @property {Terms} terms
 * @property {{}} [constraints] there are none yet
 * @property {Options} [options]
 * @property {SurfaceState} [start] where the run goes on, instead of beginning with the cage
 */

/* ---- what comes out ---- */

/**
 * @typedef {object} Progress
 * @property {Phase} phase
 * @property {number} level
 * @property {number} ended_levels
 * @property {number} iterations in this level
 * @property {number} evaluations in this level
 * @property {number} total_evaluations over all levels
 * @property {number} energy of the best surface of this level; NaN before the first evaluation. It rises only where the
 *   level goes on with a finer quadrature rule
 * @property {number} gradient_norm of the best surface
 * @property {number} predicted_decrease what the level can still gain; NaN before the first iteration
 */

/**
 * @typedef {object} LevelReport
 * @property {number} level
 * @property {number} patches
 * @property {number} unknowns
 * @property {number} energy by the minimizing rule
 * @property {number} energy_reported by the reporting rule
 * @property {number} iterations
 * @property {number} evaluations
 * @property {number} seconds
 * @property {StopReason} stop
 * @property {Exclude<MetricName, 'auto'>} metric
 * @property {number} metrics how often the metric was built
 * @property {number} quadrature steps by which its quadrature rules became finer than usual, because the surface made
 *   use of their error
 * @property {boolean} evaluable whether the mesh that was moved is the one that the surface was evaluated on; coarser
 *   ones only prepare the first of these
 * @property {boolean} credible whether its energies can be those of a surface
 * @property {boolean} thickened whether its start was made thicker, because its curvature hid between the samples
 * @property {number} predicted_decrease what the level could still gain when it ended; NaN before the first iteration
 */

/**
 * The symmetry that a run keeps: its Schoenflies symbol, C1 where there is none, and its order.
 * `incomplete` says why there may be more symmetry than this.
 * @typedef {{name: string, order: number, incomplete?: string}} Group
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
 * @property {number} lower the limit is not below this: energy − error, or the least that a closed surface has
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
 * NaN where a quantity diverges. `whole` is false where curvature hides between the samples; `below_bound` is true where an energy
 * is below what any closed surface of the genus has; `embedded` is true where the Willmore energy proves that the surface does not
 * touch itself. `input_rounding`, of a cage far from the origin, is by how much, relatively, the rounding of its coordinates may
 * change each functional.
 * @typedef {Record<FunctionalName | 'area' | 'gaussian' | 'quadrature_error', number> & {whole: boolean, below_bound: boolean,
 *   embedded: boolean, input_rounding?: Record<FunctionalName, number>}} Energies
 */

/**
 * @typedef {{vertices: number, edges: number, faces: number, genus: number}} CageComponent
 * `repairs` has a sentence for all that was changed when the cage was read.
 * @typedef {CageComponent & {components: CageComponent[], repairs: string[]}} CageReport
 */

/**
 * @typedef {object} Report
 * @property {'report'} umbilic
 * @property {number} version of the text form
 * @property {string} program its version
 * @property {string} instruction_set that its kernels used
 * @property {Problem} problem
 * @property {CageReport} cage
 * @property {Group} group
 * @property {LevelReport[]} levels
 * @property {Limit} limit
 * @property {Energies} energies
 * @property {CertificateReport} [certificate]
 * @property {SurfaceState} surface
 */

/**
 * The torus of revolution of least energy. `ratio` is NaN where all have the same, and 0 where the energy is an infimum
 * that thinner and thinner tori approach but none attains.
 * @typedef {{ratio: number, energy: number, attained: boolean}} TorusMinimizer
 */

/**
 * A mesh copied out of the core, fit to be transferred. `normals` and `curvatures` (κ1 ≥ κ2 per vertex, positive
 * where a sphere's are) are empty for control meshes, `edges` for limit meshes.
 * @typedef {object} Mesh
 * @property {Float64Array} centre 3: the middle of the bounding box, in the cage's coordinates
 * @property {Float32Array} positions 3 per vertex, from the centre, so that they keep the digits of a small mesh far away
 * @property {Float32Array} normals 3 per vertex
 * @property {Float32Array} curvatures 2 per vertex
 * @property {Uint32Array} triangles 3 per triangle
 * @property {Uint32Array} edges 2 per edge, each edge once
 */

export {};
