// SPDX-License-Identifier: MIT
/**
 * @file What is held, and what was minimized where something is held, in words.
 */
import { functionalWords } from './functionals.js';
import { compact, counted, integer, significant } from './numbers.js';

/** @import {Constraints, ConstraintsReport, Energies, FaceGroup, FunctionalName, HeldBoundaryReport, HeldRegionReport, Pin, Pull} from '../../wasm/types.js' */

/** What the pointer does on the surface, and how. @type {Record<'turn' | 'hold' | 'free' | 'pin' | 'edit', {name: string, words: string}>} */
export const pointerWords = {
  turn: { name: 'Turn', words: '' },
  hold: { name: 'Paint', words: 'Drag over the surface to hold faces; with Shift, to free them.' },
  free: { name: 'Erase', words: 'Drag over held faces to free them; with Shift, to hold them.' },
  pin: {
    name: 'Pin',
    words:
      'Click on the surface to pin the nearest vertex of the cage where it is. Drag the handle of a pin to move it.',
  },
  edit: {
    name: 'Edit',
    words:
      'Click a face or a vertex of the cage to select it; with Shift, beside others. Drag with Shift to select vertices in a box.',
  },
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

/** Whether all is free, so that only the factor A of third-order energies differs from the whole surface's. @param {Energies} energies */
const allIsFree = ({ area, free }) => Math.abs((free?.area ?? area) - area) <= 1e-9 * area;

/** What is minimized where something is held, beside the functional's name. @param {Energies} energies */
export const freeName = (energies) => (allIsFree(energies) ? 'with the constant area A₀' : 'over the free faces');

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
  const over = allIsFree(energies)
    ? []
    : [
        `Minimized over the free faces, ${freePercent(energies)} % of the area; the other rows are the whole surface’s.`,
      ];
  if (!terms.some((id) => functionalWords(id).areaPower > 0) || !(free.area_factor > 0)) return over;
  return [
    ...over,
    `${over.length ? 'There A' : 'A'} is constant: A₀ = ${significant(free.area_factor)}, the area of the cage’s own surface.`,
  ];
}

/** How strongly something pulls, "37.2 / length", and in which direction: "towards (1, 0, −0.5)". @param {Pull} pull */
export function pullWords({ pull, strength }) {
  const value = `${significant(strength, 4)} / length`;
  return {
    value,
    direction: `The derivative of the energy by its position: (${pull.map((x) => compact(x)).join(', ')})`,
  };
}

/** How strongly a boundary pulls: as a whole, and in all its parts, of which some may cancel. @param {HeldBoundaryReport} report */
export const boundaryPullWords = ({ strength, total }) =>
  `pulls with ${significant(strength, 4)} / length; its parts with ${significant(total, 4)}`;

/** A held region by its group, if it is one, or by its first face. @param {HeldRegionReport} region @param {FaceGroup[]} groups */
export function regionWords({ faces, first_face }, groups) {
  const group = groups.find((one) => one.faces.length === faces && Math.min(...one.faces) === first_face);
  return group ? group.name : `${counted(faces, 'face')}, from face ${integer(first_face)}`;
}

/** The unit of lengths: that of a file, or of a generated cage. @param {boolean} file */
export const lengthUnit = (file) => (file ? 'in the file’s units' : 'in the cage’s units');

/** What the colours of the deviation are numbers of. @param {boolean} file */
export const deviationUnit = (file) => `along the normal of the cage’s own surface, ${lengthUnit(file)}`;

/** What the fields for the closeness mean. @param {Constraints['closeness']} closeness @param {boolean} file whether the cage is a file's */
export function closenessWords(closeness, file) {
  if (closeness && 'weight' in closeness)
    return 'The weight of ∫ |X − X₀|² dA beside the energy, in energy per length⁴.';
  return `The distance from the cage’s own surface that no point exceeds, ${lengthUnit(file)}.`;
}

/** The weight that was found for a largest distance. @param {ConstraintsReport | null} report @param {Constraints} constraints @returns {string[]} */
export function foundWords(report, { closeness }) {
  if (!closeness || !('within' in closeness) || report?.closeness === undefined) return [];
  return [`Pulled to the cage’s own surface with weight ${significant(report.closeness)} per length⁴.`];
}
