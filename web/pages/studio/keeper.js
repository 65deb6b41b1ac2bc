// SPDX-License-Identifier: MIT
/**
 * @file Keeps documents in the store: soon after a change, one write at a time, each only with what is new.
 */
import { createPacking, visit } from './packing.js';

/** @import {AskStore, KeepOutcome, Stored} from '../../worker/store.js' */
/** @import {Kept} from './state/kept.js' */

/** Milliseconds from a change to its write. */
const SOON = 150;
/** Milliseconds between two writes of one document, since a run changes it many times a second. */
export const KEEP_INTERVAL = 700;

/**
 * What is written beside what is kept: its address, and when it was on the screen last.
 * @typedef {{kept: Kept, address: string, seen: number, closed: number}} Copy
 */

/**
 * @typedef {object} Writer of one document
 * @property {() => void} touch it has changed
 * @property {() => Promise<void>} flush writes what has changed, at once
 * @property {() => Promise<void>} stop ends it, once what is being written has been written
 *
 * @typedef {object} Writing
 * @property {(copy: Copy) => void} [written] called with what is in the store
 * @property {() => void} [parted] called when another page has written the document, which nobody may write here from then on
 * @property {Iterable<string>} [known] keys of the parts that are in the store
 * @property {string | null} [after] the page that wrote it last, as it was read
 */

/**
 * @param {object} surroundings
 * @param {AskStore} surroundings.ask
 * @param {(failure: string | null) => void} surroundings.told called with each write: why it failed, or null
 * @param {() => number} [surroundings.now] milliseconds
 */
export function createKeeper({ ask, told, now = () => performance.now() }) {
  const page = visit();
  const packing = createPacking(page);

  /**
   * @param {string} id
   * @param {() => Copy} copy called when it is written
   * @param {Writing} [about]
   * @returns {Writer}
   */
  function writer(id, copy, { written = () => {}, parted = () => {}, known = [], after = null } = {}) {
    const there = new Set(known);
    let dirty = false;
    let stopped = false;
    let gone = false;
    let last = -Infinity;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    /** @type {Promise<void>} */
    let writing = Promise.resolve();

    function schedule() {
      if (timer !== undefined || stopped || gone) return;
      timer = setTimeout(() => void write(), Math.max(SOON, last + KEEP_INTERVAL - now()));
    }

    function write() {
      clearTimeout(timer);
      timer = undefined;
      return (writing = writing.then(writeOnce));
    }

    async function writeOnce() {
      if (!dirty || gone) return;
      dirty = false;
      last = now();
      const mine = copy();
      const { kept, ...about } = mine;
      const { packed, parts } = packing.pack(kept);
      const { address, ...times } = about;
      const stored = { id, ...times, page, content: { ...packed, address } };
      /** @returns {Promise<KeepOutcome>} */
      function keep() {
        const fresh = new Map([...parts].filter(([key]) => !there.has(key)));
        return ask({ ask: 'keep', stored, parts: fresh, keys: [...parts.keys()], after });
      }
      try {
        let outcome = await keep();
        if (outcome === 'incomplete') {
          there.clear();
          outcome = await keep();
        }
        if (outcome === 'changed') {
          gone = true;
          clearTimeout(timer);
          return parted();
        }
        there.clear();
        for (const key of parts.keys()) there.add(key);
        written(mine);
        told(null);
      } catch (error) {
        dirty = true; // written with the next change
        told(error instanceof Error ? error.message : String(error));
      }
    }

    return {
      touch() {
        dirty = true;
        schedule();
      },
      flush: write,
      stop() {
        clearTimeout(timer);
        stopped = true;
        return writing;
      },
    };
  }

  return {
    writer,

    /** The documents of the store, without their parts. @returns {Promise<Stored[]>} */
    list: () => ask({ ask: 'list' }),

    /** @param {Stored} stored @returns {Promise<Copy & Required<Pick<Writing, 'known' | 'after'>>>} */
    async read({ id, seen, closed, page, content: { address, ...packed } }) {
      const parts = await ask({ ask: 'read', id });
      return {
        kept: packing.unpack(packed, parts),
        address,
        seen,
        closed,
        known: [...parts.keys()],
        after: page ?? null,
      };
    },

    /** @param {string[]} ids */
    remove: (ids) => ask({ ask: 'remove', ids }),
  };
}
