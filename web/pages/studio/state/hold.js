// SPDX-License-Identifier: MIT
/**
 * @file What of the surface is held: how the user's choices change it. Pure. A held face is held by its group if the
 * whole group is held, and by its number otherwise; so painting the last face of a group is holding the group.
 */

import { withCondition, withFill } from './boundary.js';
import { withSession, withSettings, withView } from './parts.js';
import { cageOnScreen, faceCount } from './taken.js';

/** @import {Constraints, FaceGroup, FaceSelection, Mesh} from '../../../../wasm/types.js' */
/** @import {CageFaces, Document, HoldAction, Settings, State} from './types.js' */

/**
 * For each face of the cage 1 if it is held, else 0.
 * @param {Constraints} constraints
 * @param {CageFaces | null} cage
 * @returns {Uint8Array}
 */
export function heldFaces({ hold, free }, cage) {
  if (!cage) return new Uint8Array(0);
  const freed = free ?? (cage.free && { groups: cage.free });
  const chosen = selected(hold ?? freed ?? {}, cage);
  return freed && !hold ? chosen.map((one) => 1 - one) : chosen;
}

/** The faces that the run on the screen holds with all copies, if that is what is asked; else null. @param {Document} document */
export const heldWithCopies = ({ settings, result }) =>
  settings.constraints.symmetric && holdsTheSame(settings, result.settings) ? result.held : null;

/**
 * As `heldFaces`, with the copies over the symmetry where they are known.
 * @param {Constraints} constraints
 * @param {CageFaces | null} cage
 * @param {number[] | null} withCopies
 */
export function shownHeld(constraints, cage, withCopies) {
  const held = heldFaces(constraints, cage);
  if (withCopies) held.fill(0);
  for (const face of withCopies ?? []) held[face - 1] = 1;
  return held;
}

/** @param {FaceSelection} selection @param {CageFaces} cage @returns {Uint8Array} */
function selected({ groups = [], faces = [] }, { counts, groups: known, fileFaces }) {
  const chosen = new Uint8Array(faceCount(counts));
  for (const { name, faces: own } of known) if (groups.includes(name)) for (const face of own) chosen[face - 1] = 1;
  const listed = new Set(faces);
  for (let f = 0; f < chosen.length; f++) if (listed.has((fileFaces?.[f] ?? f) + 1)) chosen[f] = 1;
  return chosen;
}

/**
 * The constraints that hold these faces, and else what they held before. Of faces that the file does not have only whole
 * groups can be held, and of those that were refined only whole ones. Where something is filled, holding nothing must be
 * said.
 * @param {Constraints} constraints
 * @param {Uint8Array} held 1 for each held face
 * @param {CageFaces} cage
 * @returns {Constraints}
 */
function holding(constraints, held, { groups, fileFaces, free }) {
  const rest = { ...constraints };
  delete rest.hold;
  delete rest.free;
  const whole = groups.filter(({ faces }) => faces.every((face) => held[face - 1]));
  const named = new Set(whole.flatMap(({ faces }) => faces));
  const listed = new Set();
  const partly = new Set();
  held.forEach((one, f) => {
    const face = (fileFaces?.[f] ?? f) + 1;
    if (!one) partly.add(face);
    else if (face > 0 && !named.has(f + 1)) listed.add(face);
  });
  const faces = [...listed].filter((face) => !partly.has(face));
  /** @type {FaceSelection} */
  const hold = { ...(whole.length && { groups: whole.map(({ name }) => name) }), ...(faces.length && { faces }) };
  return whole.length || faces.length || free ? { ...rest, hold } : rest;
}

/**
 * The same, not said by what is free: by what is held, or not at all where the core does the same by itself.
 * @param {Constraints} constraints
 * @param {CageFaces} cage
 * @returns {Constraints}
 */
function withoutFree({ free, ...rest }, cage) {
  if (!free || rest.hold) return rest;
  const { groups = [], faces = [] } = free;
  const byItself = cage.free?.length === groups.length && groups.every((name) => cage.free?.includes(name));
  return byItself && !faces.length ? rest : holding(rest, heldFaces({ free }, cage), cage);
}

/** With faces also the other parts of the same face of the file; without new ones. @param {number[]} faces from 0 @param {CageFaces} cage @returns {number[]} */
function wholeFaces(faces, { fileFaces }) {
  if (!fileFaces) return faces;
  const own = new Set(faces.map((face) => fileFaces[face]).filter((face) => face >= 0));
  return [...fileFaces.keys()].filter((f) => own.has(fileFaces[f]));
}

/** How much of a group is held. @param {FaceGroup} group @param {Uint8Array} held @returns {'all' | 'some' | 'none'} */
export function heldPart({ faces }, held) {
  const count = faces.reduce((sum, face) => sum + held[face - 1], 0);
  if (count === faces.length) return 'all';
  return count ? 'some' : 'none';
}

/**
 * The held faces and those that share a vertex with one. Faces of the cage share a vertex where triangles over them do.
 * @param {Uint8Array} held
 * @param {Pick<Mesh, 'positions' | 'triangles' | 'faces'>} mesh
 * @returns {Uint8Array}
 */
export function grown(held, { positions, triangles, faces }) {
  const near = new Uint8Array(positions.length / 3);
  for (let i = 0; i < triangles.length; i++) if (held[faces[Math.floor(i / 3)]]) near[triangles[i]] = 1;
  const larger = held.slice();
  for (let i = 0; i < triangles.length; i++) if (near[triangles[i]]) larger[faces[Math.floor(i / 3)]] = 1;
  return larger;
}

/**
 * The settings that belong to the cage that is open.
 * @typedef {Pick<Settings, 'constraints' | 'fill'>} Kept
 * @param {Kept} settings
 * @returns {Kept}
 */
export const keptOf = ({ constraints, fill }) => ({ constraints, fill });

/** Of a cage that has just been opened. @type {Kept} */
export const nothingKept = { constraints: {}, fill: null };

/** Whether two settings hold and fill the same. @param {Kept} one @param {Kept} other */
export const holdsTheSame = (one, other) =>
  (one.constraints === other.constraints && one.fill === other.fill) ||
  JSON.stringify(keptOf(one)) === JSON.stringify(keptOf(other));

/** Says why nothing can be minimized with what is held; null if it can. @param {Document} document */
export function problemOfHold(document) {
  const { constraints } = document.settings;
  if (!document.cage || !(constraints.hold ?? constraints.free)) return null;
  const held = heldFaces(constraints, cageOnScreen(document));
  return held.every(Boolean) ? 'Everything is held: free some faces.' : null;
}

/** Says why the closeness is none; null if it is one, or is not asked for. @param {Constraints} constraints */
export function problemOfCloseness({ closeness }) {
  if (!closeness) return null;
  if ('within' in closeness) {
    return closeness.within > 0 && Number.isFinite(closeness.within) ? null : 'The distance is a number above 0.';
  }
  return closeness.weight >= 0 && Number.isFinite(closeness.weight) ? null : 'The weight is a number of at least 0.';
}

/**
 * Whether what is held keeps anything from being minimized: by itself, or because the core has refused it. A fill that was
 * refused has been taken back.
 * @param {State} state
 */
export const holdIsUsable = ({ document, session: { refused } }) =>
  !problemOfHold(document) &&
  !problemOfCloseness(document.settings.constraints) &&
  (!refused || refused.place === 'fill');

/**
 * @param {State} state
 * @param {HoldAction} action
 * @returns {State}
 */
export function afterHold(state, action) {
  const next = changed(state, action);
  if (next === state || holdsTheSame(next.document.settings, state.document.settings)) return next;
  return withSession(next, { refused: null });
}

/** @param {State} state @param {HoldAction} action @returns {State} */
function changed(state, action) {
  const { document, view } = state;
  const { settings } = document;
  const cage = cageOnScreen(document);
  if (!document.cage || !cage) return state;
  const { constraints } = settings;
  /** @param {Partial<Settings>} change */
  const changedTo = (change) => withSettings(withView(state, { said: '' }), change);
  /** @param {Constraints} next */
  const withConstraints = (next) => changedTo({ constraints: next });
  /** @param {Uint8Array} held */
  const withHeld = (held) => withConstraints(holding(constraints, held, cage));
  const held = heldFaces(constraints, cage);
  switch (action.type) {
    case 'facesPainted': {
      const value = action.held ? 1 : 0;
      const painted = wholeFaces(action.faces, cage).filter((face) => face in held && held[face] !== value);
      if (!painted.length) return state;
      for (const face of painted) held[face] = value;
      return withHeld(held);
    }
    case 'paintingEnded':
      return state;
    case 'groupHeld': {
      const group = cage.groups.find(({ name }) => name === action.name);
      if (!group) return state;
      for (const face of group.faces) held[face - 1] = action.held ? 1 : 0;
      return withHeld(held);
    }
    case 'holdEdited':
      if (action.how === 'all') return withHeld(held.fill(1));
      if (action.how === 'clear') return withHeld(held.fill(0));
      if (action.how === 'invert') return withHeld(held.map((one) => 1 - one));
      return view.surface ? withHeld(grown(held, view.surface.limit)) : state;
    case 'vertexPinned': {
      const { pins = [] } = constraints;
      const { vertex } = action;
      if (!(Number.isInteger(vertex) && vertex >= 1 && vertex <= document.cage.counts.vertices)) return state;
      if (pins.some((pin) => pin.vertex === vertex)) {
        return withView(state, { said: `Vertex ${vertex} is pinned already.` });
      }
      return withView(withConstraints({ ...constraints, pins: [...pins, { vertex }] }), { pin: pins.length });
    }
    case 'pinRemoved': {
      const { pins = [], ...rest } = constraints;
      const left = pins.filter((_, i) => i !== action.index);
      return withView(withConstraints(left.length ? { ...rest, pins: left } : rest), { pin: null });
    }
    case 'copiesSwitched': {
      const { symmetric, ...rest } = constraints;
      return Boolean(symmetric) === action.on
        ? state
        : withConstraints(action.on ? { ...rest, symmetric: true } : rest);
    }
    case 'pinMoved': {
      const { pins = [] } = constraints;
      const moved = pins.map((pin, i) => (i === action.index ? { ...pin, at: action.at } : pin));
      return withConstraints({ ...constraints, pins: moved });
    }
    case 'pinTurned': {
      const { pins = [] } = constraints;
      const { index, normal } = action;
      if (Array.isArray(normal) && !(Math.hypot(...normal) > 0)) return state;
      const turned = pins.map(({ normal: before, ...pin }, i) => {
        if (i !== index) return before === undefined ? pin : { ...pin, normal: before };
        return normal === false ? pin : { ...pin, normal };
      });
      return withConstraints({ ...constraints, pins: turned });
    }
    case 'conditionChosen':
      return withConstraints(withCondition(constraints, action.boundary, action.condition));
    case 'fillPressed': {
      const { boundary, filled } = action;
      const said = { ...settings, constraints: withoutFree(constraints, cage) };
      return changedTo(withFill(said, document.cage, document.result.taken, boundary, filled));
    }
    case 'closenessChanged': {
      const next = { ...constraints };
      if (action.closeness) next.closeness = action.closeness;
      else delete next.closeness;
      return withConstraints(next);
    }
  }
}
