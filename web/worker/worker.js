// SPDX-License-Identifier: MIT
/**
 * @file The studio's worker: a session, with a warm-up of the core.
 */
import { Cage, InputError, Minimizer, parseReport } from '../../wasm/umbilic.js';
import { host, post, yieldThen } from './host.js';
import { createSession } from './session.js';
import { warmUp } from './warm_up.js';

const core = { Cage, InputError, Minimizer, parseReport };
let warm = false;

/** Called after the first surface has been sent, which must not wait for the warm-up. */
function rested() {
  if (warm) return;
  warm = true;
  warmUp(core, yieldThen);
}

host(() => createSession({ core, post, yieldThen, now: () => performance.now(), rested }));
