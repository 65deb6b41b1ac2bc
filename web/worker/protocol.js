// SPDX-License-Identifier: MIT
/**
 * @file The messages between page and worker: imperative in, past tense out. Plain objects; buffers are transferred.
 * `run` numbers what a message is about: each `open` begins a run under a new number, and the worker keeps the old one
 * until the new one has opened.
 */

/** @import {CageReport, CertificateReport, Energies, Group, LevelReport, Limit} from '../../wasm/types.js' */
/** @import {Mesh, Problem, Progress, Report, StopReason} from '../../wasm/types.js' */

/**
 * Begins the run that a problem asks for, or the text of a problem's or a report's file, and shows its surface. Answers
 * `opened`, `surfaced`, `saved`, `measured`, or `failed`. With `look`, for a minimizer, which has many faces and is but
 * looked at: `opened` and a coarse `surfaced` alone, so that nothing else takes the machine's time before it is on the
 * screen. With `then`, as if `optimize` or `step` followed: the surface at rest is not shown first.
 * @typedef {{type: 'open', run: number, problem: Problem | string, look?: boolean, then?: 'run' | 'step'}} Open
 *
 * The coarse surface is on the screen. Answers what `open` has left out.
 * @typedef {{type: 'detail', run: number}} Detail
 *
 * What the user may open next: while the surface rests the worker prepares it, if it can be opened. No answer.
 * @typedef {{type: 'expect', run: number, problem: Problem}} Expect
 *
 * Minimizes until told otherwise. Answers `stepped`, `surfaced`, `saved`, `levelEnded`, at last `ended`. The first surface
 * that has moved comes before everything that takes longer than a step.
 * @typedef {{type: 'optimize', run: number}} Optimize
 *
 * One energy evaluation, then `paused`.
 * @typedef {{type: 'step', run: number}} Step
 * @typedef {{type: 'pause', run: number}} Pause
 * @typedef {{type: 'cancel', run: number}} Cancel
 *
 * Answers `exported` with the control mesh or the limit mesh as OBJ, or with the report.
 * @typedef {{type: 'export', run: number, what: Exportable}} Export
 *
 * Whether the surface of a run that rests is a minimum among all surfaces near it. Answers `certificateAdvanced`, at
 * last `certified`, or `failed`; another run drops it.
 * @typedef {{type: 'certify', run: number}} Certify
 *
 * Answers `certificateAbandoned`, unless it is ready.
 * @typedef {{type: 'abandonCertificate', run: number}} AbandonCertificate
 *
 * Asks for a sign of life: `ponged`.
 * @typedef {{type: 'ping'}} Ping
 * @typedef {Open | Detail | Expect | Optimize | Step | Pause | Cancel | Export | Certify | AbandonCertificate | Ping} Command
 */

/** @typedef {'control' | 'limit' | 'report'} Exportable */

/**
 * The worker has loaded the core.
 * @typedef {{type: 'started', version: string, cages: string[]}} Started
 *
 * `group` is the symmetry that the run keeps. Of a file: `asked` is its problem, complete but for where it starts, and
 * `report` what came out.
 * @typedef {{type: 'opened', run: number, cage: CageReport, group: Group, asked?: Problem, report?:
 *   Pick<Report, 'levels' | 'limit' | 'energies' | 'certificate'>}} Opened
 *
 * The surface as it is now; `evaluations` over all levels so far; `coarse` where `detail` tells more.
 * @typedef {{type: 'surfaced', run: number, evaluations: number, limit: Mesh, control: Mesh, coarse?: boolean}} Surfaced
 *
 * Its energies by the reporting rule.
 * @typedef {{type: 'measured', run: number, evaluations: number, energies: Energies}} Measured
 *
 * Samples since the last message, SAMPLE_SIZE numbers each: evaluations over all levels, energy, gradient norm,
 * level.
 * @typedef {{type: 'stepped', run: number, progress: Progress, samples: Float64Array}} Stepped
 *
 * `limit` is that of the levels so far.
 * @typedef {{type: 'levelEnded', run: number, report: LevelReport, limit: Limit}} LevelEnded
 * @typedef {{type: 'paused', run: number, progress: Progress}} Paused
 * @typedef {{type: 'ended', run: number, stop: StopReason, progress: Progress}} Ended
 *
 * The best surface, so that nothing is lost with the worker.
 * @typedef {{type: 'saved', run: number, evaluations: number, state: {level: number, points: Float64Array}}} Saved
 *
 * @typedef {{type: 'exported', run: number, what: Exportable, text: string}} Exported
 *
 * `progress` is in [0, 1].
 * @typedef {{type: 'certificateAdvanced', run: number, progress: number}} CertificateAdvanced
 * @typedef {{type: 'certified', run: number, report: CertificateReport}} Certified
 * @typedef {{type: 'certificateAbandoned', run: number}} CertificateAbandoned
 * @typedef {{type: 'ponged'}} Ponged
 *
 * `input`: what the user's file or options did wrong. `internal`: the worker is of no further use.
 * @typedef {{type: 'failed', run: number, kind: 'input' | 'internal', message: string}} Failed
 * @typedef {Started | Opened | Surfaced | Measured | Stepped | LevelEnded | Paused | Ended | Saved | Exported |
 *   CertificateAdvanced | Certified | CertificateAbandoned | Ponged | Failed} Message
 */

/** Numbers of one sample in `stepped`. */
export const SAMPLE_SIZE = 4;

/**
 * The buffers of a message that are handed over rather than copied.
 * @param {Message} message
 * @returns {ArrayBuffer[]}
 */
export function transferables(message) {
  /** @type {ArrayBufferView[]} */
  let views = [];
  if (message.type === 'surfaced') {
    views = [message.limit, message.control].flatMap((mesh) => Object.values(mesh));
  } else if (message.type === 'stepped') {
    views = [message.samples];
  } else if (message.type === 'saved') {
    views = [message.state.points];
  }
  return views.map((view) => /** @type {ArrayBuffer} */ (view.buffer)).filter((buffer) => buffer.byteLength > 0);
}
