// SPDX-License-Identifier: MIT
/**
 * @file How a run follows what is asked while the hand still moves: where only the weights of a blend, the
 * places of pins or the points of a cage that holds something differ from those of the run, it goes on with the new
 * ones. Pure.
 */
import { askedOf, withResult, withSession } from './parts.js';
import { activeWeights, problemWith } from './settings.js';

/** @import {Retargeted} from '../../../worker/protocol.js' */
/** @import {Pin, Targets} from '../../../../wasm/types.js' */
/** @import {Point} from '../../../cage/polygons.js' */
/** @import {Action, Settings, State} from './types.js' */

/** Whether the worker has a run that can take other targets. @param {State} state */
function isOpen({ session: { phase, opening }, document: { result } }) {
  const taken = phase.name === 'running' || phase.name === 'paused' || phase.name === 'ended';
  return taken && !askedOf(phase) && !opening && !result.catalogs;
}

/** @param {Settings} settings */
const blends = ({ functional }) => functional === 'blend';

/** Whether a run goes on that can take other weights. @param {State} state */
export const takesWeights = (state) =>
  isOpen(state) && blends(state.document.settings) && blends(state.document.result.settings);

/** What is held, but for where the pins lie and their normals point. One that lies where the surface is holds all coordinates. @param {Settings} settings */
function heldBeside({ constraints, fill }) {
  const pins = constraints.pins?.map(({ at = [0, 0, 0], normal, ...pin }) => ({
    ...pin,
    normal: Boolean(normal),
    free: at.map((x) => !Number.isFinite(x)),
  }));
  return JSON.stringify({ ...constraints, fill, pins });
}

/** What of a pin a run can be told. @param {Pin} pin */
const targetOf = ({ at, normal }) => ({ ...(at && { at }), ...(Array.isArray(normal) && { normal }) });

/** Whether the surface takes more from the cage than where it begins. @param {State['document']} document */
function holdsSomething({ cage, settings: { constraints, fill } }) {
  const { hold, free, pins = [], closeness } = constraints;
  return Boolean(cage?.counts.boundaries.length || hold || free || closeness || fill) || pins.length > 0;
}

/** Whether a run goes on that can take other points of its cage, and that they matter to. @param {State} state */
export function takesPoints(state) {
  const { settings, result } = state.document;
  const [asked, run] = [settings, result.settings].map(({ constraints, fill }) => ({ constraints, fill }));
  return isOpen(state) && same(asked, run) && holdsSomething(state.document);
}

/** The run is told where the points of its cage are. @param {State} state @param {Point[]} points @returns {State} */
export const withPoints = (state, points) => withSession(state, { targets: { points: points.flat() } });

/** @param {unknown} one @param {unknown} other */
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/**
 * What a run has to be told so that it does what is asked; null if it does, or if that takes a new run.
 * @param {Settings} asked
 * @param {Settings} run the settings of the run
 * @returns {Targets | null}
 */
export function targetsBetween(asked, run) {
  const [terms, before] = [asked, run].map(activeWeights);
  const pins = asked.constraints.pins ?? [];
  const [places, placesBefore] = [pins, run.constraints.pins ?? []].map((some) => some.map(targetOf));
  const moved = !same(places, placesBefore);
  const weighed = !same(terms, before);
  if (!moved && !weighed) return null;
  if (weighed && !(blends(asked) && blends(run))) return null;
  // Where a pin lies that is asked to be where the surface was, only a new run knows; and so for its normal.
  const unknown = places.some((place, i) => Object.keys(placesBefore[i] ?? {}).some((key) => !(key in place)));
  if (heldBeside(asked) !== heldBeside(run) || unknown) return null;
  return { ...(weighed && { terms }), ...(moved && { pins: places }) };
}

const followedActions = new Set(['weightsChanged', 'pinMoved', 'pinTurned', 'undoPressed', 'redoPressed']);

/**
 * The state in which the run is told what an action has changed, if it can follow.
 * @param {State} state after the action
 * @param {Action} action
 * @returns {State}
 */
export function followed(state, action) {
  const { settings, result } = state.document;
  if (!followedActions.has(action.type) || !isOpen(state) || problemWith(settings)) return state;
  const targets = targetsBetween(settings, result.settings);
  return targets ? withSession(state, { targets }) : state;
}

/**
 * The run has taken the targets: what it told before is about others.
 * @param {State} state
 * @param {Retargeted} message
 * @returns {State}
 */
export function afterRetargeted(state, { runs, group }) {
  const { settings, result } = state.document;
  const { points } = state.session.targets ?? {};
  // A copy of the surface fits a cage of another symmetry no longer.
  const saved = points && !same(group, result.group) ? null : result.saved;
  const fresh = withResult(state, {
    settings: { ...result.settings, weights: settings.weights, constraints: settings.constraints },
    group,
    progress: null,
    stop: null,
    samples: [],
    levels: [],
    limit: null,
    saved,
    start: points ? null : (saved?.state ?? result.start ?? null),
    certificate: null,
    constrained: null,
  });
  return withSession(fresh, {
    before: null,
    phase: runs ? { name: 'running', asked: null } : { name: 'paused', asked: null },
  });
}
