// SPDX-License-Identifier: MIT
/**
 * @file The names of documents among each other, and of the files that are saved.
 */
import { stemOf } from '../../words/cages.js';

/** @import {Download, DownloadOptions, State} from './state/types.js' */

/** "two-3.umbilic.json" @param {State} state */
export const projectName = ({ document }) => `${stemOf(document.cage?.name ?? 'cage')}.umbilic.json`;

/** The endings and the types of the files. @type {Record<Download, {ending: string, type: string}>} */
const formats = {
  control: { ending: '.obj', type: 'model/obj' },
  quads: { ending: '.obj', type: 'model/obj' },
  limit: { ending: '-limit.obj', type: 'model/obj' },
  ply: { ending: '-limit.ply', type: 'application/octet-stream' },
  stl: { ending: '-limit.stl', type: 'model/stl' },
  glb: { ending: '-limit.glb', type: 'model/gltf-binary' },
  picture: { ending: '.png', type: 'image/png' },
  history: { ending: '-history.csv', type: 'text/csv;charset=utf-8' },
  report: { ending: '.json', type: 'application/json' },
  problem: { ending: '-problem.json', type: 'application/json' },
};

/** @param {Download} what @returns {string} MIME */
export const typeOf = (what) => formats[what].type;

/**
 * "two-3-mvs_cross-level2.obj", "two-3-mvs_cross-level2-refined1.obj", "two-3-mvs_cross-level2-limit.stl",
 * "two-3-mvs_cross-level2-mean-1920x1080.png", "two-3-mvs_cross-history.csv", "two-3-mvs_cross.json",
 * "two-3-mvs_cross-problem.json"; without the functional before a run.
 * @param {State} state
 * @param {Download} what
 * @param {DownloadOptions} [options]
 */
export function fileName({ document: { cage, result }, view }, what, { steps = 1, size, colouring } = {}) {
  const parts = [stemOf(cage?.name ?? 'cage')];
  if (result.samples.length) parts.push(result.settings.functional);
  if (!['history', 'report', 'problem'].includes(what)) parts.push(`level${result.saved?.state.level ?? 0}`);
  if (what === 'quads') parts.push(`refined${steps}`);
  if (what === 'picture') parts.push(view.shading, ...(size ? [size.join('x')] : []));
  if (colouring) parts.push(colouring.shading);
  return parts.join('-') + formats[what].ending;
}

/** Titles as names: those that are there before have a number. @param {string[]} titles @returns {string[]} */
export function numbered(titles) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  return titles.map((title) => {
    const count = (counts.get(title) ?? 0) + 1;
    counts.set(title, count);
    return count > 1 ? `${title} (${count})` : title;
  });
}
