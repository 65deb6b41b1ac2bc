// SPDX-License-Identifier: MIT
/**
 * @file What can be saved of a document: the names of the files, the options that each has, how large each will be, and
 * whether there is anything to save yet. Pure.
 */
import { glbSize } from '../../files/glb.js';
import { plySize } from '../../files/ply.js';
import { stlSize } from '../../files/stl.js';
import { certifyingOf } from './state/parts.js';

/** @import {Download, DownloadOptions, State} from './state/types.js' */

/** @typedef {'density' | 'steps' | 'extent' | 'picture'} OptionName of the options of a file, which are shown together */
/** @typedef {{what: Download, name: string, words: string, options: OptionName[]}} Choice */

/** In the order of the menu, whose groups are these. @type {Array<{group: string, choices: Choice[]}>} */
export const downloadGroups = [
  {
    group: 'Control mesh',
    choices: [
      { what: 'control', name: 'Control cage, OBJ', words: 'All digits, in the file’s units.', options: [] },
      {
        what: 'quads',
        name: 'Refined to quads, OBJ',
        words: 'Catmull–Clark steps of the control cage, which leave the surface as it is.',
        options: ['steps'],
      },
    ],
  },
  {
    group: 'Limit surface',
    choices: [
      { what: 'limit', name: 'Quads, OBJ', words: 'With normals, in the file’s units.', options: ['density'] },
      {
        what: 'ply',
        name: 'With curvatures, PLY',
        words: 'Triangles with normals, κ₁, κ₂, H and K.',
        options: ['density', 'extent'],
      },
      { what: 'stl', name: 'For printing, STL', words: 'Triangles.', options: ['density', 'extent'] },
      {
        what: 'glb',
        name: 'With colours, GLB',
        words: 'Triangles with normals, and with the colours of the shading.',
        options: ['density', 'extent'],
      },
      { what: 'picture', name: 'Picture, PNG', words: 'The view, without the legend.', options: ['picture'] },
    ],
  },
  {
    group: 'Numbers',
    choices: [
      {
        what: 'history',
        name: 'History of the run, CSV',
        words: 'Evaluation, level, energy and gradient norm, a line each.',
        options: [],
      },
      { what: 'report', name: 'Report, JSON', words: 'The problem and all results, with the surface.', options: [] },
      {
        what: 'problem',
        name: 'Problem, JSON',
        words: 'What was asked, for the command line or for this page.',
        options: [],
      },
    ],
  },
];

/** @param {Download} wanted @returns {Choice} */
export function choiceOf(wanted) {
  const found = downloadGroups.flatMap(({ choices }) => choices).find(({ what }) => what === wanted);
  if (!found) throw new Error(`there is no download ${wanted}`);
  return found;
}

/** Unless another density is chosen, a limit mesh has at most about this many triangles. */
const USUAL_TRIANGLES = 60_000;
const MOST_TRIANGLES = 2_000_000;

/** @typedef {{density: number, triangles: number}} Fineness of a limit mesh */

/**
 * The densities that are offered: powers of two, until the mesh has too many triangles. There is always one.
 * @param {number} patches
 * @returns {Fineness[]}
 */
export function finenesses(patches) {
  const all = [1, 2, 4, 8, 16, 32, 64, 128].map((density) => ({ density, triangles: 2 * patches * density ** 2 }));
  return all.filter(({ density, triangles }) => density === 1 || triangles <= MOST_TRIANGLES);
}

/** The one that is chosen unless the user chooses another. @param {Fineness[]} offered @returns {Fineness} */
export const usualFineness = (offered) =>
  offered.findLast(({ triangles }) => triangles <= USUAL_TRIANGLES) ?? offered[0];

/** Bytes of OBJ text, on average: per vertex of a control mesh, with its face, and per triangle of a limit mesh. */
const OBJ_VERTEX = 80;
const OBJ_TRIANGLE = 83;

/**
 * About how many bytes a file will have; null where that says nothing.
 * @param {Download} what
 * @param {DownloadOptions} options
 * @param {{patches: number, vertices: number}} of the surface: patches of its evaluated mesh, and vertices of its control mesh
 * @returns {number | null}
 */
export function sizeOf(what, { density = 1, steps = 1, colouring }, { patches, vertices }) {
  const triangles = 2 * patches * density ** 2;
  switch (what) {
    case 'control':
      return OBJ_VERTEX * vertices;
    case 'quads':
      return OBJ_VERTEX * vertices * 4 ** steps;
    case 'limit':
      return OBJ_TRIANGLE * triangles;
    case 'ply':
      return plySize(triangles / 2, triangles);
    case 'stl':
      return stlSize(triangles);
    case 'glb':
      return glbSize(triangles / 2, triangles, Boolean(colouring));
    default:
      return null;
  }
}

/** Whether there is something to save. @param {State} state @param {Download} what */
function exists({ document: { result }, view }, what) {
  if (what === 'control' || what === 'quads') return result.saved !== null;
  if (what === 'report') return result.latest !== null;
  return what === 'history' ? result.samples.length > 0 : view.surface !== null;
}

/** Whether it can be saved now. @param {State} state @param {Download} what */
export function canSave(state, what) {
  const { exporting, opening, phase } = state.session;
  const busy = exporting || opening || certifyingOf(phase) || phase.name === 'unavailable';
  return !busy && exists(state, what);
}
