// SPDX-License-Identifier: MIT
/**
 * @file The cage as a run takes it: with the boundaries filled that its problem fills. Constraints number the faces of the
 * file's cage, meshes those of the filled one. Pure.
 */

/** @import {CageReport, FaceGroup} from '../../../../wasm/types.js' */
/** @import {Opened, Unfilled} from '../../../worker/protocol.js' */
/** @import {CageFaces, Document, Result, TakenCage} from './types.js' */

/** The number of faces of a cage with those that are holes, which constraints number as well. @param {CageReport} counts */
export const faceCount = ({ faces, holes = 0 }) => faces + holes;

/** The boundaries that were filled, and the groups of the new faces, as the notes of the cage tell. @param {CageReport} cage @returns {TakenCage['fills']} */
const fillsOf = ({ notes }) =>
  notes.flatMap((note) => {
    const [, boundary, group] = /^filled boundary (\d+) of .* the group '(.*?)'(?:;|$)/.exec(note) ?? [];
    return group ? [{ boundary: Number(boundary), group }] : [];
  });

/**
 * For each face of the filled cage the face of the file's cage, from 0, that it is or is a part of; -1 if it is new, or
 * if faces were taken out, so that nobody can tell. New faces come last. Where the cage was refined first, there is one
 * quad for each corner of a face.
 * @param {number} faces of the filled cage
 * @param {number} fresh how many of them are new
 * @param {Unfilled} unfilled
 * @returns {Int32Array}
 */
function facesOfFile(faces, fresh, { counts, corners }) {
  const found = new Int32Array(faces).fill(-1);
  const quads = corners.reduce((sum, count) => sum + count, 0);
  const own = faceCount(counts);
  if (faces - fresh === own) found.forEach((_, f) => f < own && (found[f] = f));
  else if (faces - fresh === quads) found.set([...corners].flatMap((count, face) => Array(count).fill(face)));
  return found;
}

/**
 * The file's cage, and the filled one if it is filled.
 * @param {Pick<Opened, 'cage' | 'groups' | 'unfilled'>} opened
 * @returns {{counts: CageReport, groups: FaceGroup[], taken: TakenCage | null}}
 */
export function cagesOf({ cage: counts, groups, unfilled }) {
  if (!unfilled) return { counts, groups, taken: null };
  const fills = fillsOf(counts);
  const known = new Set(unfilled.counts.groups.map(({ name }) => name));
  const added = groups.filter(({ name }) => !known.has(name));
  const fresh = added
    .filter(({ name }) => fills.some(({ group }) => group === name))
    .reduce((sum, { faces }) => sum + faces.length, 0);
  const fileFaces = facesOfFile(faceCount(counts), fresh, unfilled);
  /** @type {TakenCage} */
  const taken = { counts, groups, fileFaces, fills, free: added.map(({ name }) => name) };
  const own = groups
    .filter((group) => !added.includes(group))
    .map(({ name, faces }) => ({
      name,
      faces: [...new Set(faces.map((face) => fileFaces[face - 1] + 1))].filter((face) => face > 0),
    }));
  return { counts: unfilled.counts, groups: own, taken };
}

/** The cage whose faces the mesh on the screen numbers. @param {Document} document @returns {CageFaces | null} */
export const cageOnScreen = ({ cage, result }) => result.taken ?? cage;

/**
 * The number in the file of a boundary of the cage that the run takes, of which those that are filled are left out.
 * @param {Document['cage']} cage
 * @param {Result['taken']} taken
 * @param {number} number from 1
 */
export function boundaryOfFile(cage, taken, number) {
  const filled = new Set(taken?.fills.map(({ boundary }) => boundary));
  return cage?.counts.boundaries.filter((boundary) => !filled.has(boundary.number))[number - 1]?.number ?? null;
}
