// SPDX-License-Identifier: MIT
/**
 * @file What holds the surface at the boundaries of its cage, and which of them are filled: how the user's choices change
 * it. Pure. Boundaries are numbered from 1, as the cage's report lists them.
 */

/** @import {BoundaryCondition, Constraints, FaceSelection, Fill} from '../../../../wasm/types.js' */
/** @import {OpenCage, Settings, TakenCage} from './types.js' */

/** What the core holds where nothing is said. */
export const FIRST_CONDITION = 'tangent';

/**
 * The condition of a boundary; null if it has several, by stretches.
 * @param {Constraints} constraints
 * @param {number} number of the boundary
 * @returns {BoundaryCondition | null}
 */
export function conditionAt({ boundary = {} }, number) {
  const { condition = FIRST_CONDITION, loops = [] } = boundary;
  const own = loops.filter(({ loop }) => loop === number);
  const whole = own.findLastIndex(({ from }) => from === undefined);
  if (own.length > whole + 1) return null;
  return own[whole]?.condition ?? condition;
}

/** Constraints with other conditions, which are left out where they say nothing. @param {Constraints} constraints @param {NonNullable<Constraints['boundary']>} boundary @returns {Constraints} */
function withBoundary(constraints, { condition = FIRST_CONDITION, loops = [] }) {
  const rest = { ...constraints };
  delete rest.boundary;
  const said = { ...(condition !== FIRST_CONDITION && { condition }), ...(loops.length && { loops }) };
  return Object.keys(said).length ? { ...rest, boundary: said } : rest;
}

/**
 * @param {Constraints} constraints
 * @param {number | null} number of the boundary; null for all
 * @param {BoundaryCondition} condition
 * @returns {Constraints}
 */
export function withCondition(constraints, number, condition) {
  const { condition: common = FIRST_CONDITION, loops = [] } = constraints.boundary ?? {};
  if (number === null) return withBoundary(constraints, { condition });
  const others = loops.filter(({ loop }) => loop !== number);
  const own = condition === common ? [] : [{ loop: number, condition }];
  return withBoundary(constraints, { condition: common, loops: [...others, ...own] });
}

/** The numbers of the boundaries that are filled. @param {Fill | null} fill @param {OpenCage | null} cage @returns {number[]} */
export function filledBoundaries(fill, cage) {
  if (!fill) return [];
  return fill.loops?.length ? fill.loops : (cage?.counts.boundaries ?? []).map(({ number }) => number);
}

/**
 * Without some groups. Where something is still filled, to hold nothing must be said.
 * @param {Constraints} constraints
 * @param {Set<string>} gone
 * @param {boolean} filled
 * @returns {Constraints}
 */
function withoutGroups({ hold, ...rest }, gone, filled) {
  if (!hold) return rest;
  const groups = (hold.groups ?? []).filter((name) => !gone.has(name));
  /** @type {FaceSelection} */
  const left = { ...(groups.length && { groups }), ...(hold.faces?.length && { faces: hold.faces }) };
  return filled || left.groups || left.faces ? { ...rest, hold: left } : rest;
}

/**
 * Fills boundaries, or takes that back. The groups of a fill that is taken back can no longer be held, and a boundary that
 * is filled has no condition.
 * @param {Settings} settings whose constraints do not say what is free
 * @param {OpenCage} cage
 * @param {TakenCage | null} taken
 * @param {number | null} number of the boundary; null for all
 * @param {boolean} filled
 * @returns {Settings}
 */
export function withFill({ fill, constraints, ...settings }, cage, taken, number, filled) {
  const all = cage.counts.boundaries.map((boundary) => boundary.number);
  const changed = number === null ? all : [number];
  const now = new Set(filledBoundaries(fill, cage));
  for (const one of changed) {
    if (filled) now.add(one);
    else now.delete(one);
  }
  const loops = all.filter((one) => now.has(one));
  const opened = (taken?.fills ?? []).filter(({ boundary }) => !now.has(boundary));
  const gone = new Set(opened.flatMap(({ group }) => [group, `${group}-rim`]));
  const { condition, loops: listed = [] } = constraints.boundary ?? {};
  const conditions = { condition, loops: listed.filter(({ loop }) => !now.has(loop)) };
  return {
    ...settings,
    fill: loops.length ? { ...(filled && fill), loops } : null,
    constraints: withBoundary(withoutGroups(constraints, gone, loops.length > 0), conditions),
  };
}
