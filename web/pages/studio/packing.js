// SPDX-License-Identifier: MIT
/**
 * @file Takes what is kept of a document apart, so that only what is new has to be written: the steps of the history and the
 * texts of files are parts of their own, written once. Since they are never changed, a part is known by its object.
 */

/** @import {Document, FileText, OpenCage, Step} from './state/types.js' */
/** @import {Kept} from './state/kept.js' */

/** Stands for a part. @typedef {{part: string}} Reference */
/** @typedef {Omit<Document, 'cage'> & {cage: (Omit<OpenCage, 'source'> & {source: OpenCage['source'] | Reference}) | null}} PackedDocument */
/** @typedef {Exclude<Step, {document: Document}> | (Omit<Extract<Step, {document: Document}>, 'document'> & {document: PackedDocument})} PackedStep */
/** @typedef {Omit<Kept, 'document' | 'history'> & {document: PackedDocument, past: string[], future: string[]}} Packed */
/** @typedef {PackedStep | FileText} Part */

/** A word that no other visit uses. */
export const visit = () => `${Date.now().toString(36)}.${Math.random().toString(36).slice(2, 8)}`;

/** @param {string} [prefix] of the keys of parts */
export function createPacking(prefix = visit()) {
  /** @type {WeakMap<object, string>} */
  const keys = new WeakMap();
  let count = 0;

  /** @param {object} object */
  function keyOf(object) {
    const key = keys.get(object) ?? `${prefix}.${++count}`;
    keys.set(object, key);
    return key;
  }

  /** @param {Document} document @param {Map<string, Part>} parts @returns {PackedDocument} */
  function packDocument({ cage, ...document }, parts) {
    if (cage?.source.kind !== 'text') return { ...document, cage };
    const part = keyOf(cage.source);
    parts.set(part, cage.source);
    return { ...document, cage: { ...cage, source: { part } } };
  }

  /** @param {Step} step @param {Map<string, Part>} parts */
  function packStep(step, parts) {
    const key = keyOf(step);
    parts.set(key, 'document' in step ? { ...step, document: packDocument(step.document, parts) } : step);
    return key;
  }

  /** @param {PackedDocument} document @param {Map<string, Part>} parts @returns {Document} */
  function unpackDocument({ cage, ...document }, parts) {
    if (!cage || !('part' in cage.source)) return { ...document, cage: /** @type {OpenCage | null} */ (cage) };
    const { part } = cage.source;
    const source = /** @type {FileText | undefined} */ (parts.get(part));
    if (!source) throw new Error('the file of its cage is missing');
    keys.set(source, part);
    return { ...document, cage: { ...cage, source } };
  }

  /** @param {string} key @param {Map<string, Part>} parts @returns {Step[]} none if it is missing */
  function unpackStep(key, parts) {
    const packed = /** @type {PackedStep | undefined} */ (parts.get(key));
    if (!packed) return [];
    const step = 'document' in packed ? { ...packed, document: unpackDocument(packed.document, parts) } : packed;
    keys.set(step, key);
    return [step];
  }

  return {
    /** @param {Kept} kept @returns {{packed: Packed, parts: Map<string, Part>}} all parts that it has, by their keys */
    pack({ document, history, ...rest }) {
      /** @type {Map<string, Part>} */
      const parts = new Map();
      const [past, future] = [history.past, history.future].map((steps) => steps.map((step) => packStep(step, parts)));
      return { packed: { ...rest, document: packDocument(document, parts), past, future }, parts };
    },

    /** @param {Packed} packed @param {Map<string, Part>} parts @returns {Kept} */
    unpack({ document, past, future, ...rest }, parts) {
      const [before, after] = [past, future].map((steps) => steps.flatMap((key) => unpackStep(key, parts)));
      return { ...rest, document: unpackDocument(document, parts), history: { past: before, future: after } };
    },
  };
}
