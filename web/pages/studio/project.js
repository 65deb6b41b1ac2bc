// SPDX-License-Identifier: MIT
/**
 * @file The file of a project: what is kept of a document, with its history, as JSON. Its `problem` is that of the surface, as
 * the core reads it, with the surface to start from; the rest is the page's own, and refers to it.
 *
 *     {"umbilic": "project", "version": 1, "name": "Two junctions, 3 arms",
 *      "problem": {"umbilic": "problem", "version": 1, "cage": {…}, "terms": {…}, "options": {…}, "start": {…}},
 *      "document": {…}, "phase": "ended", "view": {…}, "past": […], "future": […], "parts": {…}}
 */
import { createPacking } from './packing.js';
import { hasMoved } from './state/restore.js';
import { problemOf, problemWith, sourceOf } from './state/settings.js';

/** @import {Packed, Part} from './packing.js' */
/** @import {Kept} from './state/kept.js' */
/** @import {FileText} from './state/types.js' */

const VERSION = 1;

/** Whether a text is that of a project, as it begins. @param {Uint8Array} text */
export const isProject = (text) =>
  /^\s*\{\s*"umbilic":\s*"project"/.test(new TextDecoder('latin1').decode(text.subarray(0, 200)));

/** Arrays of numbers, and numbers that JSON does not have. @type {Array<[name: string, type: Float64ArrayConstructor | Int32ArrayConstructor]>} */
const arrays = [
  ['float64', Float64Array],
  ['int32', Int32Array],
];

/** @param {string} _ @param {unknown} value */
function plain(_, value) {
  if (typeof value === 'number' && !Number.isFinite(value)) return { number: String(value) };
  const known = arrays.find(([, type]) => value instanceof type);
  return known ? { [known[0]]: [.../** @type {Float64Array} */ (value)] } : value;
}

/** @param {string} _ @param {any} value */
function live(_, value) {
  if (!value || typeof value !== 'object') return value;
  const keys = Object.keys(value);
  if (keys.length !== 1) return value;
  const [key] = keys;
  if (key === 'number' && typeof value.number === 'string') return Number(value.number);
  const known = arrays.find(([name]) => name === key);
  return known && Array.isArray(value[key]) ? known[1].from(value[key]) : value;
}

/** @param {Part} part @returns {Part} */
const withText = (part) =>
  'text' in part && typeof part.text !== 'string' ? { ...part, text: new TextDecoder().decode(part.text) } : part;

/** @param {Kept} kept @param {string} name @returns {string} */
export function formatProject(kept, name) {
  const { cage, settings, result } = kept.document;
  if (!cage) throw new Error('no cage is open');
  const moved = hasMoved(result) && result.saved;
  const problem = problemOf(cage.source, moved ? result.settings : settings, null);
  if (typeof problem === 'string') throw new Error('the cage has no problem');
  const { packed, parts } = createPacking('part').pack(kept);
  const { document, past, future, phase, view } = packed;
  // The text of its cage is in the problem, and the points of its surface are too.
  const own = document.cage && 'part' in document.cage.source ? document.cage.source.part : null;
  const others = [...parts].filter(([key]) => key !== own).map(([key, part]) => [key, withText(part)]);
  const saved = moved ? { ...moved, state: null } : result.saved;
  const { text } = /** @type {Partial<FileText>} */ (cage.source);
  const decoded = text instanceof Uint8Array ? new TextDecoder().decode(text) : text;
  const project = {
    umbilic: 'project',
    version: VERSION,
    name,
    problem: {
      umbilic: 'problem',
      version: 1,
      ...problem,
      cage: decoded === undefined ? problem.cage : { ...problem.cage, text: decoded },
      ...(moved && { start: { level: moved.state.level, points: [...moved.state.points] } }),
    },
    // A run that went on is opened as one that is paused.
    phase: phase === 'running' ? 'paused' : phase,
    view,
    document: { ...document, result: { ...result, saved } },
    past,
    future,
    parts: Object.fromEntries(others),
  };
  return `${JSON.stringify(project, plain)}\n`;
}

/**
 * @param {string} text
 * @returns {{kept: Kept, name: string}}
 * @throws {Error} with a sentence, if it is no project of this version
 */
export function parseProject(text) {
  const project = parsed(text);
  const { problem, document, phase, view, past, future, name } = project;
  const { start, cage } = problem;
  /** @type {Map<string, Part>} */
  const parts = new Map(Object.entries(project.parts));
  const { source } = document.cage;
  if ('part' in source) parts.set(source.part, /** @type {FileText} */ (sourceOf(cage, document.cage.name)));
  const { saved } = document.result;
  const surface = saved && !saved.state && { ...saved, state: surfaceFrom(start) };
  /** @type {Packed} */
  const packed = {
    phase,
    view,
    document: surface ? { ...document, result: { ...document.result, saved: surface } } : document,
    past,
    future,
  };
  return { kept: createPacking().unpack(packed, parts), name: String(name) };
}

/** @param {any} start */
function surfaceFrom(start) {
  if (!Number.isInteger(start?.level) || !Array.isArray(start.points)) throw new Error('Its surface is missing.');
  return { level: start.level, points: Float64Array.from(start.points) };
}

/** @param {string} text @returns {any} whose members have the types of a project's */
function parsed(text) {
  /** @type {any} */
  let project;
  try {
    project = JSON.parse(text, live);
  } catch (error) {
    throw new Error(`It is not whole: ${error instanceof Error ? error.message : error}.`, { cause: error });
  }
  if (project?.version !== VERSION)
    throw new Error(`It is of version ${project?.version}; this page reads ${VERSION}.`);
  const { problem, document, past, future, parts, view } = project;
  const whole =
    problem?.cage &&
    document?.cage?.source &&
    document.settings?.levels &&
    document.result?.settings &&
    [document.result.samples, document.result.levels, past, future].every(Array.isArray) &&
    parts &&
    view?.camera &&
    ['resting', 'paused', 'ended'].includes(project.phase);
  if (!whole) throw new Error('Parts of it are missing.');
  const wrong = problemWith(document.settings);
  if (wrong) throw new Error(wrong);
  return project;
}
