// SPDX-License-Identifier: MIT
/**
 * @file What is held, and what was minimized where something is held, in words.
 */
import { functionalWords } from './functionals.js';
import { compact, counted, integer, significant } from './numbers.js';

/** @import {Energies, FunctionalName, Pin} from '../../wasm/types.js' */

/** What the pointer does on the surface, and how. @type {Record<'turn' | 'hold' | 'free' | 'pin', {name: string, words: string}>} */
export const pointerWords = {
  turn: { name: 'Turn', words: '' },
  hold: { name: 'Paint', words: 'Drag over the surface to hold faces; with Shift, to free them.' },
  free: { name: 'Erase', words: 'Drag over held faces to free them; with Shift, to hold them.' },
  pin: { name: 'Pin', words: 'Click on the surface to pin the nearest vertex of the cage where it is.' },
};

/** How much is held: "24 of 104 faces held". @param {number} held @param {number} faces */
export function heldWords(held, faces) {
  return held ? `${integer(held)} of ${counted(faces, 'face')} held` : 'Nothing is held.';
}

/**
 * When a change of what is held takes effect; empty if it has.
 * @param {boolean} changed whether the run on the screen holds something else
 * @param {string} status of the run
 */
export function changeWords(changed, status) {
  if (!changed || status === 'resting' || status === 'loading') return '';
  if (status === 'ended') return 'The next Start begins from the cage with this.';
  return 'This run goes on with what it holds; the change applies from the next Start.';
}

/** "Vertex 17", "Face 3 at (0.5, 0.25)". @param {Pin} pin */
export function pinWords({ vertex, face, corner, uv, at, position = true, normal }) {
  const place =
    vertex === undefined
      ? `Face ${face}${corner === undefined ? '' : `, corner ${corner},`} at (${(uv ?? []).map((x) => compact(x)).join(', ')})`
      : `Vertex ${vertex}`;
  const target = at ? ` to (${at.map((x) => (Number.isFinite(x) ? compact(x) : 'free')).join(', ')})` : '';
  const kept = [...(position ? [] : ['normal only']), ...(position && normal ? ['with its normal'] : [])];
  return [place + target, ...kept].join(', ');
}

/** The fraction of the area that is free, in percent. @param {Energies} energies */
function freePercent({ area, free }) {
  const percent = (100 * (free?.area ?? area)) / area;
  return percent < 1 || percent > 99 ? compact(percent, 2) : integer(percent);
}

/**
 * What was minimized where faces are held: over what, and with which factor.
 * @param {Energies} energies
 * @param {FunctionalName[]} terms the functionals that are minimized
 * @returns {string[]}
 */
export function freeWords(energies, terms) {
  const { free } = energies;
  if (!free) return [];
  const over = `Minimized over the free faces, ${freePercent(energies)} % of the area; the other rows are the whole surface’s.`;
  if (!terms.some((id) => functionalWords(id).thirdOrder) || !(free.area_factor > 0)) return [over];
  return [over, `There A is constant: A₀ = ${significant(free.area_factor)}, the area of the cage’s own surface.`];
}
