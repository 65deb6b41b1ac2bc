// SPDX-License-Identifier: MIT
/**
 * @file The studio's worker: a session, and what makes its first minute fast.
 */
import { InputError, Minimizer, parseReport } from '../../wasm/umbilic.js';
import { host, post, yieldThen } from './host.js';
import { createSession } from './session.js';
import { warmUp } from './warm_up.js';

const core = { InputError, Minimizer, parseReport };
let warm = false;

/** Not before the first surface has been told, which must not wait for it. */
function rested() {
  if (warm) return;
  warm = true;
  warmUp(core, yieldThen);
}

host(() => createSession({ core, post, yieldThen, now: () => performance.now(), rested }));
