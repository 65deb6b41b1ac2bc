// SPDX-License-Identifier: MIT
/**
 * @file Where on the page a refusal of the core belongs: beside the boundary, the fill or the closeness that it is about.
 * The core's messages name the member of the problem, and the boundary or a vertex of it. Pure.
 */
import { conditionAt, filledBoundaries } from './boundary.js';
import { boundaryLoops } from './loops.js';
import { boundaryOfFile } from './taken.js';

/** @import {Refusal, State} from './types.js' */

/** The members of a problem that have a place of their own. @type {Array<{place: Refusal['place'], pattern: RegExp}>} */
const places = [
  { place: 'fill', pattern: /(?:^|: )fill(?:\.[\w.[\]]+)?: (.*)$/s },
  { place: 'boundary', pattern: /(?:^|: )constraints\.boundary(?:\.[\w.[\]]+)?: (.*)$/s },
  { place: 'closeness', pattern: /(?:^|: )constraints\.closeness(?:\.[\w.[\]]+)?: (.*)$/s },
];

/** @param {string} words */
const sentence = (words) => `${words[0].toUpperCase()}${words.slice(1)}${/[.!?}]$/.test(words) ? '' : '.'}`;

/**
 * The boundary that a refusal of its condition is about: the one with the vertex that it names, else the first with
 * curvature.
 * @param {State} state
 * @param {string} words
 */
function refusedCondition(state, words) {
  const { document, view } = state;
  const { settings, cage } = document;
  const { surface } = view;
  const vertex = Number(/vertex (\d+)/.exec(words)?.[1]) - 1;
  const loops = surface ? boundaryLoops(surface.limit) : [];
  const named = boundaryOfFile(cage, document.result.taken, loops.findIndex((loop) => loop.includes(vertex)) + 1);
  const curved = cage?.counts.boundaries.find(
    ({ number }) => conditionAt(settings.constraints, number) === 'curvature',
  );
  return named ?? curved?.number ?? null;
}

/** The boundary that could not be filled: the one that is named, else the one that was asked for. @param {State} state @param {string} words */
function refusedFill({ document: { settings, result, cage } }, words) {
  const named = Number(/boundary (\d+)/.exec(words)?.[1]);
  if (named) return named;
  const before = filledBoundaries(result.settings.fill, cage);
  const asked = filledBoundaries(settings.fill, cage).filter((number) => !before.includes(number));
  return asked.length === 1 ? asked[0] : null;
}

/**
 * @param {State} state
 * @param {string} message of the core
 * @returns {Refusal | null} null if it has no place of its own
 */
export function placedRefusal(state, message) {
  for (const { place, pattern } of places) {
    const words = pattern.exec(message)?.[1];
    if (!words) continue;
    const boundary =
      place === 'boundary' ? refusedCondition(state, words) : place === 'fill' ? refusedFill(state, words) : null;
    return { place, boundary, message: sentence(words) };
  }
  return null;
}
