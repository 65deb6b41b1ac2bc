// SPDX-License-Identifier: MIT
/**
 * @file The studio's worker: a session, and what makes its first minute fast.
 */
import { Cage, InputError, Minimizer } from '../../wasm/umbilic.js';
import { host, post, yieldThen } from './host.js';
import { createSession } from './session.js';
import { warmUp } from './warm_up.js';

const core = { Cage, InputError, Minimizer };
const loaded = await host(() => createSession({ core, post, yieldThen, now: () => performance.now() }));
if (loaded) warmUp(core, yieldThen);
