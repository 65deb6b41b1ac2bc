// SPDX-License-Identifier: MIT
/**
 * @file The processors that a worker computes on. One is its own, the others it shares with all workers of the site that are busy,
 * of this page and of others: a lock of the browser stands for each, which a worker that dies gives back.
 */

/**
 * @param {object} surroundings
 * @param {Pick<LockManager, 'request'> | undefined} surroundings.locks none where there are no threads
 * @param {number} surroundings.count how many processors there are
 * @param {(threads: number) => void} surroundings.use called whenever the number of processors that it may compute on changes
 * @returns {(busy: boolean) => void} asks for them all, of which each comes as soon as no other worker has it; or gives them back
 */
export function createProcessors({ locks, count, use }) {
  /** @type {{threads: number, giveBack: AbortController} | null} */
  let busyWith = null;

  /** @param {LockManager} manager */
  function take(manager) {
    const mine = { threads: 1, giveBack: new AbortController() };
    const { signal } = mine.giveBack;
    busyWith = mine;
    const given = new Promise((resolve) => {
      signal.addEventListener('abort', resolve);
    });
    for (let i = 1; i < count; i++) {
      const held = () => {
        if (signal.aborted) return;
        use(++mine.threads);
        return given;
      };
      manager.request(`umbilic processor ${i}`, { signal }, held).catch(() => {}); // no longer wanted
    }
  }

  return (busy) => {
    if (!locks || busy === (busyWith !== null)) return;
    if (busy) return take(/** @type {LockManager} */ (locks));
    busyWith?.giveBack.abort();
    busyWith = null;
    use(1);
  };
}
