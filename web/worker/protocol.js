// SPDX-License-Identifier: MIT
/**
 * @file The messages between page and worker: commands are imperative, answers are in the past tense. All are plain
 * objects; buffers are transferred. `run` is the number of the run that a message is about. Each `open` begins a run
 * with a new number, and the worker keeps the old run until the new one has opened.
 */

/** @import {CageReport, CertificateReport, ConstraintsReport, Energies, Estimate, FaceGroup, Group, LevelReport} from '../../wasm/types.js' */
/** @import {Limit, Mesh, Problem, Progress, Report, StopReason, Targets} from '../../wasm/types.js' */
/** @import {Colouring} from './colouring.js' */
/** @import {ComputedValues, Wish} from './computed.js' */
/** @import {Crossings} from './crossings.js' */

/**
 * Begins the run of a problem (also given as the text of a problem or report file) and shows its surface. Answers
 * `opened`, `surfaced`, `saved`, `measured`, or `failed`. With `look`, for a minimizer that is only viewed and has many
 * faces: answers only `opened` and a coarse `surfaced`, so that it is on the screen soon. With `then`: works as if
 * `optimize` or `step` followed, and does not show the surface at rest first. `wish`: as of `compute`, for this run.
 * @typedef {{type: 'open', run: number, problem: Problem | string, look?: boolean, then?: 'run' | 'step', wish?: Wish}} Open
 *
 * The coarse surface has been drawn. Answers what `open` with `look` left out.
 * @typedef {{type: 'detail', run: number}} Detail
 *
 * A problem that the user may open next. The worker prepares it while the surface rests. No answer.
 * @typedef {{type: 'expect', run: number, problem: Problem}} Expect
 *
 * Minimizes until told otherwise. Answers `stepped`, `surfaced`, `saved`, `levelEnded` and finally `ended`. The first
 * surface that has moved is sent before anything that takes longer than a step.
 * @typedef {{type: 'optimize', run: number}} Optimize
 *
 * Does one energy evaluation. Answers `paused`.
 * @typedef {{type: 'step', run: number}} Step
 * Changes weights, pins' targets, the pull or the cage's points of a run that has taken steps. One that is paused stays so,
 * any other goes on. Of several that arrive between two steps the last of each kind counts. Answers `retargeted` and what follows from going on; or
 * `failed`, and the run goes on as it was.
 * @typedef {{type: 'retarget', run: number, targets: Targets}} Retarget
 * @typedef {{type: 'pause', run: number}} Pause
 * @typedef {{type: 'cancel', run: number}} Cancel
 *
 * Answers `exported` with a file, or `failed` if it would be too large.
 * @typedef {{type: 'export', run: number, what: Exportable, options?: ExportOptions}} Export
 *
 * Tests whether the surface of a run at rest is a minimum among all surfaces near it. Answers `certificateAdvanced` and
 * finally `certified`, or `failed`. Another run ends the test.
 * @typedef {{type: 'certify', run: number}} Certify
 *
 * Looks for a surface of lower energy near that of a run at rest, which has a certificate that counts directions down; computes
 * that first if need be. Answers as `certify`, and then `descended`, or `failed`.
 * @typedef {{type: 'descend', run: number}} Descend
 *
 * Answers `certificateAbandoned`, unless the certificate is ready.
 * @typedef {{type: 'abandonCertificate', run: number}} AbandonCertificate
 *
 * From now on, of whatever run, `surfaced` has values of this kind, or none. Answers `surfaced` if the surface is at rest.
 * @typedef {{type: 'compute', wish: Wish | null}} Compute
 *
 * Looks for curves in which the surface of a run at rest crosses itself. Answers `searched`.
 * @typedef {{type: 'search', run: number}} Search
 *
 * Asks for the surface and the cage that a run began from. Answers `recalled`.
 * @typedef {{type: 'recall', run: number}} Recall
 *
 * Asks for the cage as it was given, before its boundaries were filled. Answers `cageTold`.
 * @typedef {{type: 'tellCage', run: number}} TellCage
 *
 * `behind`: another document is on the screen, and what it computes comes first. No answer.
 * @typedef {{type: 'stand', behind: boolean}} Stand
 *
 * Asks for the answer `ponged`.
 * @typedef {{type: 'ping'}} Ping
 * @typedef {Open | Detail | Expect | Optimize | Step | Retarget | Pause | Cancel | Export | Certify | Descend | AbandonCertificate | Compute | Search | Recall | TellCage | Stand | Ping} Command
 */

/**
 * The control mesh, the same after Catmull-Clark steps and the limit mesh as OBJ; the limit mesh as PLY, STL and GLB; the report
 * and the problem.
 * @typedef {'control' | 'quads' | 'limit' | 'ply' | 'stl' | 'glb' | 'report' | 'problem'} Exportable
 *
 * What a file is to be like; options that its format does not have are ignored.
 * @typedef {object} ExportOptions
 * @property {number} [density] of a limit mesh: quads along each edge of a patch; by default as for a large file
 * @property {number} [steps] of refinement; default 1
 * @property {number | null} [extent] of PLY, STL and GLB: what the longest side becomes, with the middle at the origin; null
 *   and by default size and place are the cage's
 * @property {'y' | 'z'} [up] of GLB: the axis that points upwards; default z
 * @property {Colouring | null} [colouring] of GLB: the colours of its vertices
 * @property {string} [name] of GLB: that of its model
 */

/**
 * Which vertices the triangles and edges of a mesh have, and the faces of the cage that they descend from. A mesh comes
 * without if they are those of the last one that had them.
 * @typedef {Pick<Mesh, 'triangles' | 'faces' | 'edges'>} Topology
 * @typedef {Omit<Mesh, keyof Topology> & Partial<Topology>} MeshUpdate
 */

/**
 * The worker has loaded the core.
 * @typedef {{type: 'started', version: string, cages: string[]}} Started
 *
 * `level` is that of the surface that the run starts from, and `group` the symmetry that it keeps; `groups` are those of the cage's faces. For a file, `asked` is its problem, complete, and
 * `report` its results, with which `asked` has no start. Where the problem fills boundaries, `cage` and `groups` are those of the filled cage, and `unfilled` is
 * the one before, with the number of corners of each of its faces. `held`: the numbers of all held faces, where constraints are
 * copied over the symmetry. `text`: that of a cage whose file was bytes, as the page is to keep it. `estimate`: what the run will probably take;
 * of a minimizer that is only viewed it is not told.
 * @typedef {{counts: CageReport, corners: Uint32Array}} Unfilled
 * @typedef {{type: 'opened', run: number, level: number, cage: CageReport, group: Group, groups: FaceGroup[], asked?: Problem, report?:
 *   Pick<Report, 'levels' | 'limit' | 'energies' | 'certificate' | 'constraints'>, unfilled?: Unfilled, held?: number[], text?: string,
 *   estimate?: Estimate}} Opened
 *
 * The current surface. `evaluations` counts all levels so far. `patches` has its evaluated mesh, and `density` counts the quads
 * along each edge of one in the limit mesh, in which the quads of a patch follow each other. `coarse`: `detail` will bring a finer
 * one. `computed`: values of the limit mesh's vertices; missing if none are wished for, or the energy is infinite.
 * @typedef {{type: 'surfaced', run: number, evaluations: number, patches: number, limit: MeshUpdate, density: number, control: MeshUpdate,
 *   computed?: ComputedValues, coarse?: boolean}} Surfaced
 *
 * The limit mesh of the cage's own surface at the run's level, and the cage as it was given.
 * @typedef {{type: 'recalled', run: number, limit: Mesh, density: number, cage: Mesh}} Recalled
 *
 * Where the surface at rest crosses itself, in the coordinates of its limit mesh.
 * @typedef {{type: 'searched', run: number, evaluations: number, crossings: Crossings}} Searched
 *
 * The cage as OBJ text with all digits, its vertices and faces numbered as in the answer `opened`.
 * @typedef {{type: 'cageTold', run: number, obj: string}} CageTold
 *
 * Energies of the surface by the reporting rule. Its level is not always the last one.
 * @typedef {{type: 'measured', run: number, evaluations: number, level: number, energies: Energies}} Measured
 *
 * What the constraints do to a surface at rest that has been minimized.
 * @typedef {{type: 'constrained', run: number, evaluations: number, report: ConstraintsReport}} Constrained
 *
 * Samples since the last message, SAMPLE_SIZE numbers each: evaluations over all levels, energy, gradient norm,
 * level.
 * @typedef {{type: 'stepped', run: number, progress: Progress, samples: Float64Array}} Stepped
 *
 * `limit` is the limit of the levels so far.
 * @typedef {{type: 'levelEnded', run: number, report: LevelReport, limit: Limit}} LevelEnded
 *
 * From here on everything is about the new targets; evaluations and levels count anew. `runs`: whether the run goes on. `group`:
 * the symmetry that is left.
 * @typedef {{type: 'retargeted', run: number, runs: boolean, group: Group}} Retargeted
 * @typedef {{type: 'paused', run: number, progress: Progress}} Paused
 * @typedef {{type: 'ended', run: number, stop: StopReason, progress: Progress}} Ended
 *
 * A copy of the best surface, so that it survives the loss of the worker.
 * @typedef {{type: 'saved', run: number, evaluations: number, state: {level: number, points: Float64Array}}} Saved
 *
 * @typedef {{type: 'exported', run: number, what: Exportable, options: ExportOptions, content: string | ArrayBuffer}} Exported
 *
 * `progress` is in [0, 1].
 * @typedef {{type: 'certificateAdvanced', run: number, progress: number}} CertificateAdvanced
 * @typedef {{type: 'certified', run: number, report: CertificateReport}} Certified
 * @typedef {{type: 'certificateAbandoned', run: number}} CertificateAbandoned
 *
 * The lower surface, to begin a run with.
 * @typedef {{type: 'descended', run: number, state: {level: number, points: Float64Array}}} Descended
 * @typedef {{type: 'ponged'}} Ponged
 *
 * `input`: something is wrong with the user's file or options. `internal`: the worker can no longer be used.
 * @typedef {{type: 'failed', run: number, kind: 'input' | 'internal', message: string}} Failed
 * @typedef {Started | Opened | Surfaced | Searched | Recalled | CageTold | Measured | Constrained | Stepped | LevelEnded | Retargeted | Paused | Ended | Saved |
 *   Exported | CertificateAdvanced | Certified | CertificateAbandoned | Descended | Ponged | Failed} Message
 */

/** How many numbers a sample in `stepped` has. */
export const SAMPLE_SIZE = 4;

/**
 * The mesh that an update stands for.
 * @param {MeshUpdate} update
 * @param {Mesh | undefined} last the mesh before it
 * @returns {Mesh}
 */
export function withTopology({ triangles, faces, edges, ...moved }, last) {
  if (triangles && faces && edges) return { ...moved, triangles, faces, edges };
  if (!last) throw new Error('the first mesh of a run has no triangles');
  return { ...moved, triangles: last.triangles, faces: last.faces, edges: last.edges };
}

/**
 * The buffers of a message that are transferred instead of copied.
 * @param {Message} message
 * @returns {ArrayBuffer[]}
 */
export function transferables(message) {
  if (message.type === 'exported') return message.content instanceof ArrayBuffer ? [message.content] : [];
  /** @type {ArrayBufferView[]} */
  let views = [];
  if (message.type === 'surfaced') {
    views = [message.limit, message.control].flatMap((mesh) => Object.values(mesh));
    if (message.computed) views.push(message.computed.values);
  } else if (message.type === 'recalled') {
    views = [message.limit, message.cage].flatMap((mesh) => Object.values(mesh));
  } else if (message.type === 'searched') {
    views = [message.crossings.segments];
  } else if (message.type === 'stepped') {
    views = [message.samples];
  } else if (message.type === 'saved' || message.type === 'descended') {
    views = [message.state.points];
  }
  return views.map((view) => /** @type {ArrayBuffer} */ (view.buffer)).filter((buffer) => buffer.byteLength > 0);
}
