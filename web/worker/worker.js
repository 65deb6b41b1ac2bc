// SPDX-License-Identifier: MIT
/**
 * @file The studio's worker: a session, with a warm-up of the core.
 */
import { Cage, InputError, Minimizer, parseReport, useThreads } from '../../wasm/umbilic.js';
import { host, post, yieldThen } from './host.js';
import { createProcessors } from './processors.js';
import { createSession } from './session.js';
import { warmUp } from './warm_up.js';

const core = { Cage, InputError, Minimizer, parseReport };
/** Not all of the work is shared among threads, so that more gain little. */
const MOST_PROCESSORS = 8;
let warm = false;

/** Called after the first surface has been sent, which must not wait for the warm-up. */
function rested() {
  if (warm) return;
  warm = true;
  warmUp(core, yieldThen);
}

const busy = createProcessors({
  locks: globalThis.crossOriginIsolated ? navigator.locks : undefined,
  count: Math.min(navigator.hardwareConcurrency, MOST_PROCESSORS),
  use: (threads) => void useThreads(threads),
});

host(() => createSession({ core, post, yieldThen, now: () => performance.now(), rested, busy }));
