// SPDX-License-Identifier: MIT
/**
 * @file Which page a document belongs to. Pages that are open side by side share one store; a document is only read and
 * written by the page that owns it, which is one at a time. A page that is closed or has crashed owns nothing. A page that
 * is loaded again finds what it owned by the memory of its browser tab.
 */

/** How long a page that is loaded again waits until the one before it has given a document away, in milliseconds. */
const PATIENCE = 4_000;
const KEY = 'umbilic.documents';

/** @param {string} id */
const lockOf = (id) => `umbilic-document-${id}`;

/** What the browser tab remembers. @param {() => Storage} storage may throw */
function remembered(storage) {
  try {
    const ids = JSON.parse(storage().getItem(KEY) ?? '[]');
    return new Set(Array.isArray(ids) ? ids.map(String) : []);
  } catch {
    return new Set();
  }
}

/**
 * @param {LockManager | undefined} locks of the browser; without any, a page owns all that it asks for
 * @param {() => Storage} storage of the browser tab
 */
export function createOwnership(locks = globalThis.navigator?.locks, storage = () => sessionStorage) {
  /** What gives a document away again. @type {Map<string, () => void>} */
  const owned = new Map();
  const before = remembered(storage);

  function remember() {
    try {
      storage().setItem(KEY, JSON.stringify([...owned.keys()]));
    } catch {
      // The page will find its documents unless another one is faster.
    }
  }

  return {
    /** Whether this browser tab owned a document before it was loaded again. @param {string} id */
    had: (id) => before.has(id),

    /** Which of these documents no page owns. @param {string[]} ids @returns {Promise<string[]>} */
    async free(ids) {
      const held = new Set((await locks?.query())?.held?.map(({ name }) => name));
      return ids.filter((id) => !held.has(lockOf(id)));
    },

    /** Takes a document unless another page owns it. @param {string} id @returns {Promise<boolean>} whether it is owned */
    take(id) {
      if (!locks || owned.has(id)) return Promise.resolve(true);
      const options = before.has(id) ? { signal: AbortSignal.timeout(PATIENCE) } : { ifAvailable: true };
      return new Promise((resolve) => {
        const request = locks.request(lockOf(id), options, (lock) => {
          resolve(lock !== null);
          if (!lock) return undefined;
          return new Promise((release) => {
            owned.set(id, () => release(undefined));
            remember();
          });
        });
        request.catch(() => resolve(false));
      });
    },

    /** @param {string} id */
    give(id) {
      owned.get(id)?.();
      owned.delete(id);
      remember();
    },
  };
}
