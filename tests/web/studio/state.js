// SPDX-License-Identifier: MIT
/**
 * @file States and messages that the tests of the page's state begin with.
 */
import { initialState, reduce } from '../../../web/pages/studio/state/reduce.js';
import { askedOf, certifyingOf } from '../../../web/pages/studio/state/parts.js';
import { runButtons } from '../../../web/pages/studio/state/select.js';

/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */
/** @typedef {import('../../../web/pages/studio/state/types.js').Action} Action */
/** @typedef {import('../../../web/pages/studio/state/types.js').OpenCage} OpenCage */
/** @typedef {import('../../../web/worker/protocol.js').Message} Message */

/** @param {State} state @param {...Action} actions @returns {State} */
export const after = (state, ...actions) => actions.reduce(reduce, state);

/** @param {Message} message @returns {Action} */
export const answered = (message) => ({ type: 'answered', message });

/** A file of no use as a cage. @param {string} name @returns {Action} */
export const drop = (name) => ({ type: 'fileChosen', name, text: new TextEncoder().encode('v 0 0 0') });

/** The fields of a state by their names, wherever they are. `settings` are those of the next run. @param {State} state */
export const leaves = ({ document, session, view }) => ({
  ...view,
  ...session,
  ...document.result,
  ...document,
  status: session.phase.name,
  asked: askedOf(session.phase),
  certifying: certifyingOf(session.phase),
  runSettings: document.result.settings,
});

/** A state whose cage is another. @param {State} state @param {(cage: OpenCage) => OpenCage} change @returns {State} */
export function withCage(state, change) {
  if (!state.document.cage) throw new Error('no cage');
  return { ...state, document: { ...state.document, cage: change(state.document.cage) } };
}

/** Which of the run's buttons work. @param {State} state */
export function working(state) {
  const { primary, ...others } = runButtons(state);
  return [primary, ...Object.values(others)].filter(({ enabled }) => enabled).map(({ label }) => label);
}

/** @returns {import('../../../wasm/types.js').Mesh} */
export function mesh() {
  return {
    centre: new Float64Array(3),
    positions: new Float32Array(9),
    normals: new Float32Array(9),
    curvatures: new Float32Array(6),
    triangles: new Uint32Array([0, 1, 2]),
    faces: new Uint32Array(1),
    edges: new Uint32Array([0, 1, 1, 2, 2, 0]),
  };
}

/** @param {number} level @param {number} total_evaluations @returns {import('../../../wasm/types.js').Progress} */
export function progress(level, total_evaluations) {
  return {
    phase: 'minimize',
    level,
    ended_levels: 0,
    iterations: total_evaluations,
    evaluations: total_evaluations,
    total_evaluations,
    energy: 120,
    gradient_norm: 1,
    predicted_decrease: 0.5,
    share_done: 0.25,
    seconds_left: 8,
  };
}

/** @param {number} bending @returns {import('../../../wasm/types.js').Energies} */
export function energies(bending) {
  return {
    bending,
    willmore: 22,
    mvs: 300,
    mvs_cross: 4000,
    mehlum_tarrou: 3000,
    second_form_variation: NaN,
    mean_curvature_variation: 2000,
    curvedness_variation: 1e5,
    area: 12,
    gaussian: -4 * Math.PI,
    quadrature_error: 0.01,
    resolved: true,
    below_bound: false,
    embedded: false,
  };
}

/**
 * @param {number} level
 * @param {Partial<import('../../../wasm/types.js').LevelReport>} [more]
 * @returns {import('../../../wasm/types.js').LevelReport}
 */
export function levelReport(level, more = {}) {
  return {
    level,
    patches: 24 * 4 ** level,
    unknowns: 78,
    energy: 120,
    energy_reported: 120.1,
    iterations: 4,
    evaluations: 5,
    seconds: 1,
    stop: 'converged',
    metric: 'hessian',
    metrics: 1,
    factorizations: 1,
    parametrization_stages: 0,
    evaluable: true,
    cap_rings: 4,
    narrower_caps_energy: NaN,
    narrower_caps_evaluations: 0,
    credible: true,
    thickened: false,
    quadrature: 0,
    predicted_decrease: 1e-5,
    ...more,
  };
}

/** @returns {import('../../../wasm/types.js').Limit} of too few levels */
export const noLimit = () => ({
  status: 'too_few_levels',
  energy: 120.1,
  order: NaN,
  error: NaN,
  lower: NaN,
  caps_included: true,
});

/** @returns {import('../../../wasm/types.js').CertificateReport} */
export const certificate = () => ({ level: 2, unknowns: 1146, gauge: 7, tau: 0.001, negative: 6 });

/** A surface that is told from others by its first number. @param {number} level @param {number} mark */
export const surfaceState = (level, mark) => ({ level, points: Float64Array.of(mark, 0, 0) });

/** What the worker says when it has opened run `run`. @param {number} run @returns {Action[]} */
export function openedMessages(run) {
  const counts = { vertices: 26, edges: 60, faces: 32, genus: 2 };
  const components = [{ ...counts, boundaries: 0 }];
  const cage = { ...counts, components, boundaries: [], groups: [], repairs: [], notes: [] };
  return [
    answered({ type: 'opened', run, level: 0, cage, group: { name: 'D3h', order: 12 }, groups: [] }),
    answered({ type: 'surfaced', run, evaluations: 0, patches: 24, limit: mesh(), density: 1, control: mesh() }),
    answered({ type: 'saved', run, evaluations: 0, state: surfaceState(0, run) }),
    answered({ type: 'measured', run, evaluations: 0, level: 0, energies: energies(150) }),
  ];
}

/**
 * One message about `count` evaluations, at the run's own level `level`.
 * @param {number} run
 * @param {number} count
 * @param {number} [level]
 * @returns {Action}
 */
export function stepped(run, count, level = 0) {
  const samples = Float64Array.from(
    Array.from({ length: count }, (_, i) => [i + 1, 150 - i, 10 / (i + 1), level]).flat(),
  );
  return answered({ type: 'stepped', run, progress: progress(level, count), samples });
}

/** The page with its first cage open. @returns {State} */
export function resting() {
  const started = answered({ type: 'started', version: '1.2.3', cages: ['cube', 'two-3', 'two-4'] });
  return after(initialState(), started, ...openedMessages(1));
}

/** The page after some steps of its first run. @returns {State} */
export function running() {
  return after(
    resting(),
    { type: 'startPressed' },
    stepped(1, 5),
    answered({ type: 'saved', run: 1, evaluations: 5, state: surfaceState(0, 5) }),
  );
}

/** The page after its first run, which ended at level 2. @returns {State} */
export function ended() {
  return after(
    running(),
    answered({ type: 'ended', run: 1, stop: 'converged', progress: progress(2, 5) }),
    answered({ type: 'saved', run: 1, evaluations: 5, state: surfaceState(2, 9) }),
    answered({ type: 'measured', run: 1, evaluations: 5, level: 2, energies: energies(113) }),
  );
}
