// SPDX-License-Identifier: MIT
/**
 * @file The types of the core's input and output, with the names of the text form of problems and reports
 * (core/problem/text.h); no code. Numbers that are not finite are null in the text and NaN here.
 */

// In one line, because tsc copies a union's line breaks, with their asterisks, into declarations.
/** @typedef {'bending'|'willmore'|'mvs'|'mvs_cross'|'mehlum_tarrou'|'second_form_variation'|'mean_curvature_variation'|'curvedness_variation'} FunctionalName */
/** Third-order integrals that are odd in II, and only evaluated. @typedef {'gradient_form'|'variation_form'|'triple_form'} InvariantName */
/** @typedef {'none'|'flat'|'smooth'} CapName */
/** @typedef {'auto'|'identity'|'sobolev'|'hessian'|'newton'} MetricName */
/** @typedef {'prepare'|'minimize'|'report'|'compare_caps'|'done'} Phase */
/** @typedef {'converged'|'max_iterations'|'line_search_stalled'|'round_off'|'not_finite'|'degenerate'|'cancelled'|'below_bound'|'not_resolved'} StopReason */

/* ---- problems ---- */

/**
 * A cage ignores parameters that it does not have.
 * @typedef {object} GeneratedCage
 * @property {string} generator
 * @property {'hub' | 'flag'} [family] for frames
 * @property {number} [thickness] of the arms or the tube, relative to the default
 * @property {number} [spread] for frames with two junctions: distance of the arms from the axis
 * @property {number} [ratio] for the torus: minor radius / major radius
 * @property {[number, number]} [segments] for the torus: number around the axis and around the tube; for open cages: around
 *   the boundary (n-sided: along a side) and across
 * @property {number} [radius] for disk, cylinder, spherical-cap and n-sided
 * @property {number} [half_angle] for spherical-cap: degrees from the pole to the boundary
 * @property {number} [height] for cylinder and catenoid
 * @property {number} [waist] for catenoid: the smallest radius
 * @property {number} [sides] for n-sided
 * @property {number} [rise] for n-sided: the height of the corners of a saddle; flat if 0
 */

/** The text of an OBJ, OFF or PLY file, or its bytes. @typedef {{name?: string, text: string | Uint8Array}} CageText */

/** @typedef {GeneratedCage | CageText} CageInput */

/** Weights of functionals, non-negative, not all zero. @typedef {Partial<Record<FunctionalName, number>>} Terms */

/**
 * @typedef {object} Options
 * @property {CapName} [cap] default 'smooth'
 * @property {[number, number]} [levels] first and last, in Catmull-Clark steps from the cage; default [0, 2]
 * @property {1|2|4|8|16} [cap_rings] the most rings of faces that a smooth cap takes; default 4. More are
 *   for coarse cages that are refined
 * @property {number} [max_iterations] per level; default 1000
 * @property {number} [tolerance] default 1e-6
 * @property {number} [accuracy] ends with the first level from which the limit is known within this part of it
 * @property {boolean} [second_opinion] whether the report also has the energies as another way of computing finds them,
 *   which takes seconds; default false
 * @property {boolean} [symmetry] whether the surface keeps the symmetry of the cage; default true
 * @property {MetricName} [metric] default 'auto'
 */

/**
 * A surface, given by the control points of the first vertex of each orbit of the symmetry that its run keeps.
 * @typedef {{level: number, points: Float64Array | number[]}} SurfaceState
 */

/**
 * Boundaries of the cage to be closed with quads.
 * @typedef {object} Fill
 * @property {number[]} [loops] numbers of boundaries, from 1; default all
 * @property {number[]} [corners] numbers of vertices that are to be corners of patches of quads
 */

/**
 * Faces of the cage: those of some groups of its file, and some by their numbers, from 1.
 * @typedef {{groups?: string[], faces?: number[]}} FaceSelection
 *
 * A point of the surface that is held, at a vertex of the cage or in a face; see core/problem/pin.h.
 * @typedef {object} Pin
 * @property {number} [vertex] its number, from 1
 * @property {number} [face] its number, from 1
 * @property {number} [corner] of a face that is no quad, from 1
 * @property {[number, number]} [uv] where in the face
 * @property {[number, number, number]} [at] where the point lies; NaN leaves a coordinate free
 * @property {boolean} [position] whether the point is held; default true
 * @property {boolean | [number, number, number]} [normal] the surface's normal there
 */

/**
 * What is held at boundaries.
 * @typedef {'free' | 'position' | 'tangent' | 'curvature'} BoundaryCondition
 * @typedef {{condition?: BoundaryCondition, loops?: {loop: number, from?: number, to?: number, condition: BoundaryCondition}[]}} BoundaryConditions
 */

/**
 * What the surface must keep. At most one of `hold` and `free` is given.
 * @typedef {object} Constraints
 * @property {FaceSelection} [hold] faces whose surface stays that of the cage
 * @property {FaceSelection} [free] the only faces whose surface may move
 * @property {Pin[]} [pins]
 * @property {boolean} [symmetric] whether pins, `hold` or `free`, and listed boundaries are copied to all places to which the
 *   cage's symmetry maps theirs, so that the symmetry is kept; default false
 * @property {{weight: number} | {within: number}} [closeness] how near the surface stays to the cage's own
 * @property {BoundaryConditions} [boundary] of open surfaces; by default tangents are held everywhere
 */

/**
 * @typedef {object} Problem
 * @property {CageInput} cage
 * @property {Terms} terms
 * @property {Fill} [fill] unless the constraints say what is held, everything is that neither fills nor touches
 *   a boundary
 * @property {Constraints} [constraints] by default nothing is held
 * @property {Options} [options]
 * @property {SurfaceState} [start] the surface from which the run starts; by default that of the cage
 */

/**
 * New values for a run that goes on; what is not given stays. See core/problem/targets.h.
 * @typedef {object} Targets
 * @property {Terms} [terms]
 * @property {{at?: [number, number, number], normal?: [number, number, number]}[]} [pins] one for each of the problem's, in
 *   their order; NaN where the pin leaves a coordinate free
 * @property {number} [closeness] its weight, where the problem has one
 * @property {Float64Array | number[]} [points] x, y, z of each point of the problem's cage, before it is filled: what is held
 *   follows it. The problem's cage becomes a text.
 */

/* ---- reports ---- */

/**
 * @typedef {object} Progress
 * @property {Phase} phase
 * @property {number} level
 * @property {number} ended_levels
 * @property {number} iterations in this level
 * @property {number} evaluations in this level
 * @property {number} total_evaluations over all levels
 * @property {number} energy of the best surface of this level; NaN before the first evaluation. It increases only if
 *   the level continues with a finer quadrature rule
 * @property {number} gradient_norm of the best surface
 * @property {number} predicted_decrease how much the level can still decrease the energy; NaN before the first
 *   iteration
 * @property {number} share_done of the time that the run will probably take, from 0 to 1; never falls
 * @property {number} seconds_left until the run will probably end
 */

/**
 * One level of a run that has not begun.
 * @typedef {object} LevelEstimate
 * @property {number} level
 * @property {number} patches
 * @property {number} unknowns about so many
 * @property {number} evaluations that such levels usually take
 * @property {number} seconds on this machine
 * @property {number} bytes of memory
 */

/**
 * What a run will probably take; half or twice as long is usual.
 * @typedef {object} Estimate
 * @property {LevelEstimate[]} levels those that it will probably take
 * @property {number} seconds of all levels
 * @property {number} bytes of the largest one
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
 * @property {number} metrics how many times the metric was built
 * @property {number} factorizations how many matrices were factored for it, also where one was not positive definite
 * @property {number} parametrization_stages in which a term that keeps the parametrization even fell to 0; 0 without it
 * @property {number} quadrature by how many steps the quadrature rules were refined because the surface exploited their
 *   error
 * @property {boolean} evaluable whether the surface was evaluated on the mesh whose points were moved; a coarser mesh
 *   only prepares the first such level
 * @property {boolean} credible whether its energies can be those of a surface
 * @property {number} cap_rings rings of faces of its narrowest cap that may move; 0 without caps
 * @property {number} narrower_caps_energy energy_reported after it was minimized once more with caps half as wide, from
 *   which the limit's error knows that of the caps; NaN where it was not
 * @property {number} narrower_caps_evaluations evaluations which that took
 * @property {boolean} thickened whether its start was made thicker because its samples missed curvature
 * @property {number} predicted_decrease how much the level could still decrease the energy when it ended; NaN before the
 *   first iteration
 */

/**
 * The symmetry that a run keeps: its order, and its Schoenflies symbol, which is C1 if there is none.
 * `incomplete` says why the cage may have more symmetry than this.
 * @typedef {{name: string, order: number, incomplete?: string}} Group
 */

/** @typedef {'converging'|'too_few_levels'|'not_minimized'|'not_converging'|'not_resolved'|'not_comparable'} LimitStatus */

/**
 * The estimated limit of the levels' energies. Unless they converge, `energy` is the least of them and `error` is
 * NaN.
 * @typedef {object} Limit
 * @property {LimitStatus} status
 * @property {number} energy
 * @property {number} order observed order of convergence; NaN if it cannot be determined
 * @property {number} error the limit is within energy ± error
 * @property {number} lower the limit is not below this: energy − error, or the least that a closed surface has
 * @property {boolean} caps_included whether the error knows that of the caps: not where there is no limit, nor for
 *   functionals of third order whose caps did not widen with the last level, unless that before was minimized with
 *   narrower caps, too
 */

/**
 * @typedef {object} CertificateReport
 * @property {number} level
 * @property {number} unknowns of the full Hessian, which ignores the surface's symmetry
 * @property {number} gauge directions along which no energy changes; they are removed
 * @property {number} tau eigenvalues below -tau, relative to the Sobolev product, are counted as negative
 * @property {number} negative directions along which the energy decreases to second order
 */

/**
 * A quantity is NaN if it diverges. `resolved` is false if the samples miss some curvature, so that Gauss-Bonnet fails.
 * `below_bound` is true if an energy is below what any closed surface of the genus has. `embedded` is true if the Willmore
 * energy proves that the surface does not touch itself. `input_rounding`, only for a cage far from the origin, is the largest
 * relative change of each functional that the rounding of the coordinates can cause. `free`, only where faces are held, is what
 * is minimized: the energies of the free faces, where third-order functionals have powers of the constant `area_factor`.
 * `boundary_turning`, only of an open surface, is how much its boundary turns, with its corners. `invariants` are the
 * integrals of core/energy/invariants.h, with II positive where the surface bends away from the outward normal. A stored report
 * has neither functionals nor invariants that are newer than it.
 * @typedef {Record<FunctionalName | 'area' | 'area_factor', number>} FreeEnergies
 * @typedef {Record<FunctionalName | 'area' | 'gaussian' | 'quadrature_error', number> & {resolved: boolean, below_bound: boolean,
 *   embedded: boolean, input_rounding?: Record<FunctionalName, number>, free?: FreeEnergies, boundary_turning?: number,
 *   invariants?: Record<InvariantName, number>}} Energies
 */

/**
 * How strongly something held is pulled, in energy per length: the derivative of the minimal energy by its position. Moved
 * against `pull`, the energy falls.
 * @typedef {{pull: [number, number, number], strength: number}} Pull
 * A pin by its number from 1, or a copy of it by its number from 1, where the cage's symmetry maps the pin to. `off_surface` is the distance of its point from the surface, whose caps let go of it a little;
 * `turned_over` is true if the surface has its inside where the held normal points.
 * @typedef {Pull & {pin: number, copy?: number, position: [number, number, number], off_surface: number, turned_over: boolean}} PinReport
 * Held faces that hang together; `first_face` counts from 1.
 * @typedef {Pull & {faces: number, first_face: number}} HeldRegionReport
 * A boundary by its number from 1. `total` sums the lengths of the pulls at its vertices; `moment` is the derivative of the
 * minimal energy by turning it about its `center`, per radian.
 * @typedef {Pull & {boundary: number, center: [number, number, number], total: number, moment: [number, number, number]}}
 *   HeldBoundaryReport
 */

/**
 * What the constraints of a run do to its best surface.
 * @typedef {object} ConstraintsReport
 * @property {number} held_faces of the cage
 * @property {number} free_faces
 * @property {number} deviation largest distance from the cage's own surface, between points with the same parameters
 * @property {number} [closeness] the weight w of w ∫ |X − X₀|² dA, where the surface is kept near the cage's own
 * @property {HeldRegionReport[]} regions
 * @property {HeldBoundaryReport[]} boundaries at which something is held
 * @property {PinReport[]} pins
 * @property {string[]} notes what else a user should know, a sentence each
 */

/**
 * @typedef {{vertices: number, edges: number, faces: number, genus: number}} CageCounts
 * `boundaries` is the number of its boundary loops.
 * @typedef {CageCounts & {boundaries: number}} CageComponent
 * A boundary loop. `number` and `component` count from 1; `first_vertex` is the first of its vertices in the file, numbered as
 * there.
 * @typedef {{number: number, vertices: number, first_vertex: number, component: number}} CageBoundary
 * `repairs` has a sentence for all that was changed when the cage was read, `notes` for what was ignored or is likely to be
 * a mistake.
 * Counts are those of the surface. Faces that are holes are counted in `holes` alone, which is left out where there are none.
 * @typedef {CageCounts & {holes?: number, components: CageComponent[], boundaries: CageBoundary[], groups: {name: string, faces: number}[],
 *   repairs: string[], notes: string[]}} CageReport
 *
 * A group of faces of a cage's file, with their numbers from 1. A face may be in several groups.
 * @typedef {{name: string, faces: number[]}} FaceGroup
 */

/**
 * The integrals of the surface, computed in another way: `errors` is by how much they differ by a coarser rule of the same
 * kind, `differences` the report's energies minus these. NaN where they diverge.
 * @typedef {Record<FunctionalName | InvariantName | 'area' | 'gaussian', number>} OpinionValues
 * @typedef {{values: OpinionValues, errors: OpinionValues, differences: OpinionValues, samples: number}} OpinionReport
 */

/**
 * @typedef {object} Report
 * @property {'report'} umbilic
 * @property {number} version of the text form
 * @property {string} program version of the program
 * @property {string} instruction_set used by the kernels
 * @property {Problem} problem
 * @property {CageReport} cage
 * @property {Group} group
 * @property {Estimate} [estimate] what the run was expected to take before it began
 * @property {LevelReport[]} levels
 * @property {Limit} limit
 * @property {Energies} energies
 * @property {OpinionReport} [second_opinion] where the options ask for it
 * @property {ConstraintsReport} [constraints] where something is held, or the surface is open
 * @property {CertificateReport} [certificate]
 * @property {SurfaceState} surface
 */

/**
 * The torus of revolution of least energy. `ratio` is NaN if all tori have the same energy. It is 0 if the energy is an
 * infimum that ever thinner tori approach but none attains.
 * @typedef {{ratio: number, energy: number, attained: boolean}} TorusMinimizer
 */

/**
 * A mesh copied out of the core, so its arrays can be transferred. `normals` and `curvatures` (κ1 ≥ κ2 per vertex,
 * positive on a sphere) are empty for control meshes; `edges` is empty for limit meshes.
 * @typedef {object} Mesh
 * @property {Float64Array} centre 3: the middle of the bounding box, in the cage's coordinates
 * @property {Float32Array} positions 3 per vertex, relative to the centre, so that a small mesh far away keeps its
 *   digits
 * @property {Float32Array} normals 3 per vertex
 * @property {Float32Array} curvatures 2 per vertex
 * @property {Uint32Array} triangles 3 per triangle
 * @property {Uint32Array} faces of each triangle: the face of the cage that it descends from, from 0
 * @property {Uint32Array} edges 2 per edge, each edge once
 */

export {};
