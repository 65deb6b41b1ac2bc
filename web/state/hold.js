// SPDX-License-Identifier: MIT
/**
 * @file What of the surface is held: how the user's choices change it. Pure. A held face is held by its group if the
 * whole group is held, and by its number otherwise; so painting the last face of a group is holding the group.
 */

/** @import {Constraints, FaceGroup, FaceSelection, Mesh} from '../../wasm/types.js' */
/** @import {HoldAction, OpenCage, Settings, State} from './types.js' */

/**
 * For each face of the cage 1 if it is held, else 0.
 * @param {Constraints} constraints
 * @param {OpenCage | null} cage
 * @returns {Uint8Array}
 */
export function heldFaces({ hold, free }, cage) {
  if (!cage) return new Uint8Array(0);
  const chosen = selected(hold ?? free ?? {}, cage);
  return free && !hold ? chosen.map((one) => 1 - one) : chosen;
}

/** @param {FaceSelection} selection @param {OpenCage} cage @returns {Uint8Array} */
function selected({ groups = [], faces = [] }, cage) {
  const chosen = new Uint8Array(cage.counts.faces);
  const named = cage.groups.filter(({ name }) => groups.includes(name)).flatMap((group) => group.faces);
  for (const face of [...named, ...faces]) chosen[face - 1] = 1;
  return chosen;
}

/**
 * The constraints that hold these faces, and else what they held before.
 * @param {Constraints} constraints
 * @param {Uint8Array} held 1 for each held face
 * @param {FaceGroup[]} groups
 * @returns {Constraints}
 */
function holding(constraints, held, groups) {
  const rest = { ...constraints };
  delete rest.hold;
  delete rest.free;
  const whole = groups.filter(({ faces }) => faces.every((face) => held[face - 1]));
  const named = new Set(whole.flatMap(({ faces }) => faces));
  const faces = [...held.keys()].map((face) => face + 1).filter((face) => held[face - 1] && !named.has(face));
  /** @type {FaceSelection} */
  const hold = { ...(whole.length && { groups: whole.map(({ name }) => name) }), ...(faces.length && { faces }) };
  return whole.length || faces.length ? { ...rest, hold } : rest;
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
 * Whether two settings hold the same.
 * @param {Pick<Settings, 'constraints'>} one
 * @param {Pick<Settings, 'constraints'>} other
 */
export const holdsTheSame = ({ constraints: one }, { constraints: other }) =>
  one === other || JSON.stringify(one) === JSON.stringify(other);

/** Says why nothing can be minimized with what is held; null if it can. @param {Pick<State, 'settings' | 'cage'>} state */
export function problemOfHold({ settings: { constraints }, cage }) {
  if (!cage || !(constraints.hold ?? constraints.free)) return null;
  return heldFaces(constraints, cage).every(Boolean) ? 'Everything is held: free some faces.' : null;
}

/**
 * @param {State} state
 * @param {HoldAction} action
 * @returns {State}
 */
export function afterHold(state, action) {
  const { cage, surface, settings } = state;
  if (!cage) return state;
  const { constraints } = settings;
  /** @param {Constraints} next @returns {State} */
  const withConstraints = (next) => ({ ...state, settings: { ...settings, constraints: next } });
  /** @param {Uint8Array} held */
  const withHeld = (held) => withConstraints(holding(constraints, held, cage.groups));
  const held = heldFaces(constraints, cage);
  switch (action.type) {
    case 'facesPainted': {
      const value = action.held ? 1 : 0;
      const changed = action.faces.filter((face) => face in held && held[face] !== value);
      if (!changed.length) return state;
      for (const face of changed) held[face] = value;
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
      return surface ? withHeld(grown(held, surface.limit)) : state;
    case 'vertexPinned': {
      const { pins = [] } = constraints;
      const { vertex } = action;
      const exists = Number.isInteger(vertex) && vertex >= 1 && vertex <= cage.counts.vertices;
      if (!exists || pins.some((pin) => pin.vertex === vertex)) return state;
      return withConstraints({ ...constraints, pins: [...pins, { vertex }] });
    }
    case 'pinRemoved': {
      const { pins = [], ...rest } = constraints;
      const left = pins.filter((_, i) => i !== action.index);
      return withConstraints(left.length ? { ...rest, pins: left } : rest);
    }
  }
}
