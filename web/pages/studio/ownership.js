// SPDX-License-Identifier: MIT
/**
 * @file Which page a document belongs to. Pages that are open side by side share one store; a document is only read and
 * written by the page that owns it, which is one at a time. A page that is closed or has crashed owns nothing.
 */

/** @param {string} id */
const lockOf = (id) => `umbilic-document-${id}`;

/** @param {LockManager | undefined} locks of the browser; without any, a page owns all that it asks for */
export function createOwnership(locks = globalThis.navigator?.locks) {
  /** What gives a document away again. @type {Map<string, () => void>} */
  const owned = new Map();

  return {
    /** Takes a document unless another page owns it. @param {string} id @returns {Promise<boolean>} whether it is owned */
    take(id) {
      if (!locks || owned.has(id)) return Promise.resolve(true);
      return new Promise((resolve) => {
        const request = locks.request(lockOf(id), { ifAvailable: true }, (lock) => {
          resolve(lock !== null);
          if (!lock) return undefined;
          return new Promise((release) => {
            owned.set(id, () => release(undefined));
          });
        });
        request.catch(() => resolve(false));
      });
    },

    /** @param {string} id */
    give(id) {
      owned.get(id)?.();
      owned.delete(id);
    },
  };
}
