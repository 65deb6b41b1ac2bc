// SPDX-License-Identifier: MIT
/**
 * @file What the worker tells of a run that it has opened: its cage and symmetry, and of a file its problem and results.
 */

import { mayBeBinary } from '../../wasm/values.js';

/** @import {Cage, Minimizer, parseReport} from '../../wasm/umbilic.js' */
/** @import {Problem} from '../../wasm/types.js' */
/** @import {Opened} from './protocol.js' */

/** @typedef {{Cage: typeof Cage, parseReport: typeof parseReport}} Core */

/**
 * The parts that only a file has. The start of a report is its surface, of which the page needs no points.
 * @param {Core} core
 * @param {Problem | string} problem
 * @param {Minimizer} opened
 */
function fileParts(core, problem, opened) {
  if (typeof problem !== 'string') return {};
  const { cage, terms, fill, constraints, options, start } = opened.problem;
  const { umbilic, levels, limit, energies, certificate, constraints: held } = core.parseReport(problem);
  const report = umbilic === 'report' && { report: { levels, limit, energies, certificate, constraints: held } };
  return { asked: { cage, terms, fill, constraints, options, ...(start && !report && { start }) }, ...report };
}

/**
 * The text that the core has made of a file that was none, so that the page can keep it and pass it on.
 * @param {Problem | string} problem
 * @param {Minimizer} opened
 */
function textParts(problem, opened) {
  const bytes = typeof problem !== 'string' && 'text' in problem.cage ? problem.cage.text : '';
  if (!(bytes instanceof Uint8Array) || !mayBeBinary(bytes)) return {};
  const { text } = /** @type {{text: string}} */ (opened.problem.cage);
  return { text };
}

/**
 * The cage before its boundaries were filled, if they are.
 * @param {Core} core
 * @param {Minimizer} opened
 */
function unfilledParts({ Cage }, opened) {
  const { cage, fill } = opened.problem;
  if (!fill) return {};
  const unfilled = new Cage(cage);
  const { counts } = unfilled;
  // Each face is a fan of triangles, two less than it has corners.
  const corners = new Uint32Array(counts.faces + (counts.holes ?? 0)).fill(2);
  for (const face of unfilled.mesh().faces) corners[face]++;
  unfilled.dispose();
  return { unfilled: { counts, corners } };
}

/**
 * @param {Core} core
 * @param {number} run
 * @param {Problem | string} problem
 * @param {Minimizer} opened
 * @returns {Opened}
 */
export function openedMessage(core, run, problem, opened) {
  const { cage, group, groups, progress } = opened;
  const held = opened.problem.constraints.symmetric && { held: opened.held };
  const parts = {
    ...fileParts(core, problem, opened),
    ...textParts(problem, opened),
    ...unfilledParts(core, opened),
    ...held,
  };
  return { type: 'opened', run, level: progress.level, cage, group, groups, ...parts };
}
