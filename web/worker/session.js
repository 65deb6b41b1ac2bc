// SPDX-License-Identifier: MIT
/**
 * @file How the worker reacts to messages: it keeps the open run and steps it. When it steps is in pacing.js, what it
 * tells in telling.js, what it does ahead in preparing.js. It knows neither workers nor timers; functions for posting,
 * yielding and the time are passed in.
 */
import { createCertification } from './certification.js';
import { MOVING_QUADS } from './density.js';
import { cageObj, exported } from './exporting.js';
import { openedMessage } from './opened.js';
import { createPacing } from './pacing.js';
import { createPreparing } from './preparing.js';
import { createTelling } from './telling.js';

/** @import {Cage, Minimizer, parseReport} from '../../wasm/umbilic.js' */
/** @import {Targets} from '../../wasm/types.js' */
/** @import {Wish} from './computed.js' */
/** @import {Command, Export, Message, Open} from './protocol.js' */

/**
 * @typedef {object} Surroundings
 * @property {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error, parseReport: typeof parseReport}} core
 * @property {(message: Message) => void} post
 * @property {(task: () => void) => void} yieldThen runs the task after the messages that have arrived by then
 * @property {() => number} now milliseconds
 * @property {() => void} [rested] called when everything about a surface at rest has been sent and its level is
 *   prepared
 * @property {(busy: boolean) => void} [busy] told after everything that it does whether it has work that all processors are to share
 */

/**
 * @param {Surroundings} surroundings
 * @returns {(command: Command) => void}
 */
export function createSession({ core, post, yieldThen, now, rested = () => {}, busy = () => {} }) {
  /** @type {Minimizer | null} */
  let minimizer = null;
  let run = 0;
  /** Whether an opened run has sent nothing but `opened` so far. */
  let introducing = false;
  /** Whether the surface is a minimizer that has only been shown coarsely. */
  let coarse = false;
  /** Whether the surface may be minimized; a minimizer from the catalog is only viewed. */
  let startable = false;
  /** Those that have arrived since the last step. @type {Targets | null} */
  let targets = null;
  /** Whether another document is on the screen, to which the processors are left. */
  let behind = false;
  /** Whether a surface at rest is about to be sent with what is computed of it. */
  let computing = false;
  /** @param {() => void} task fails as the work of the run that is open then */
  const later = (task) => yieldThen(() => guard(run, task));
  const pacing = createPacing({ yieldThen: later, now });
  const telling = createTelling({ core, post, now });
  const preparing = createPreparing({ core, yieldThen: later });
  const certification = createCertification({ post, yieldThen: later });

  /** @returns {Minimizer} */
  function current() {
    if (!minimizer) throw new Error('no cage is open');
    return minimizer;
  }

  /** @param {Open} command */
  function open(command) {
    const opened = preparing.take(command.problem);
    certification.drop();
    minimizer?.dispose();
    minimizer = opened;
    run = command.run;
    pacing.rest();
    targets = null;
    introducing = true;
    coarse = command.look ?? false;
    startable = !coarse;
    const message = openedMessage(core, run, command.problem, opened);
    const constrained = message.cage.boundaries.length > 0 || Object.keys(opened.problem.constraints).length > 0;
    telling.begin(run, opened, { constrained, wish: command.wish ?? null });
    post(startable ? { ...message, estimate: opened.estimate } : message);
    yieldThen(() => guard(command.run, () => introduce(command.run)));
    if (command.then) go(command.then === 'run' ? 'running' : 'stepping');
  }

  /**
   * Sends what the page shows first. A resting cage is sent finely, a viewed minimizer coarsely until the page asks for
   * more. A run that starts at once is not shown at rest, since its first moved surface then comes sooner.
   * @param {number} opened
   */
  function introduce(opened) {
    if (!introducing || run !== opened) return;
    if (pacing.pace === 'resting' && coarse) {
      coarse = false;
      return telling.surface(MOVING_QUADS, true);
    }
    if (pacing.pace === 'resting') return tellRest();
    telling.energies();
    telling.postpone();
  }

  function tellRest() {
    introducing = false;
    telling.rest();
    if (!startable) return rested();
    const mine = current();
    preparing.ahead(mine, telling.patches(), () => minimizer === mine && pacing.pace === 'resting', rested);
  }

  /** Takes the targets that have arrived. */
  function retarget() {
    const asked = targets;
    targets = null;
    if (!asked) return;
    guard(run, () => {
      current().retarget(asked);
      telling.retargeted(pacing.pace !== 'resting');
    });
  }

  /** @param {Targets} asked */
  function follow(asked) {
    certification.drop();
    targets = { ...targets, ...asked };
    const paused = pacing.pace === 'resting' && current().progress.phase !== 'done';
    if (!paused) return go('running');
    retarget();
    tellRest();
  }

  function advance() {
    retarget();
    const before = current().progress.total_evaluations;
    const done = pacing.timed(() => current().step(1));
    const evaluated = current().progress.total_evaluations > before;
    if (evaluated) telling.sample();
    telling.progress(done, pacing.cost);
    if (done) end();
    else if (pacing.pace === 'stepping' && evaluated) rest();
  }

  /** @param {'stepping' | 'running'} pace */
  function go(pace) {
    certification.drop();
    telling.goOn();
    pacing.go(pace, advance);
  }

  function rest() {
    pacing.rest();
    telling.steps();
    post({ type: 'paused', run, progress: current().progress });
    tellRest();
  }

  /** Sends the answer first, then what takes longer. */
  function end() {
    pacing.rest();
    telling.steps();
    const stop = current().levels.at(-1)?.stop ?? 'cancelled';
    post({ type: 'ended', run, stop, progress: current().progress });
    telling.levels();
    tellRest();
  }

  /** Answers before the core measures the ended level once more, so that the user need not wait. */
  function cancel() {
    if (current().progress.phase === 'done') return end();
    pacing.rest();
    telling.steps();
    post({ type: 'ended', run, stop: 'cancelled', progress: current().progress });
    current().cancel();
    telling.levels();
    tellRest();
  }

  /** What is asked for last counts, as weights may follow a hand. @param {Wish | null} wish */
  function compute(wish) {
    telling.wishFor(wish);
    if (computing) return;
    computing = true;
    later(() => {
      computing = false;
      if (pacing.pace === 'resting') telling.again();
    });
  }

  /** @param {Export} command */
  function send({ what, options = {} }) {
    const about = { patches: telling.patches, certificate: certification.ready };
    post({ type: 'exported', run, what, options, content: exported(core, current(), what, options, about) });
  }

  /** @param {Command} command */
  function obey(command) {
    if (command.type === 'ping') return post({ type: 'ponged' });
    if (command.type === 'open') return open(command);
    if (command.type === 'compute') return compute(command.wish);
    if (command.type === 'stand') return void (behind = command.behind);
    if (command.run > run) return; // the run did not open
    if (command.run < run) {
      if (command.type === 'optimize' || command.type === 'step')
        throw new Error('the surface is no longer held by the worker');
      return;
    }
    switch (command.type) {
      case 'detail':
        return introduce(run);
      case 'search':
        return pacing.pace === 'resting' ? telling.crossings() : undefined;
      case 'recall':
        return telling.recall();
      case 'tellCage':
        return post({ type: 'cageTold', run, obj: cageObj(core, current()) });
      case 'expect':
        return preparing.expect(command.problem);
      case 'optimize':
        return go('running');
      case 'step':
        return go('stepping');
      case 'retarget':
        return follow(command.targets);
      case 'pause':
        return rest();
      case 'cancel':
        return cancel();
      case 'export':
        return send(command);
      case 'certify':
        return pacing.pace === 'resting' ? certification.begin(run, current()) : undefined;
      case 'descend':
        return pacing.pace === 'resting' ? certification.descend(run, current()) : undefined;
      case 'abandonCertificate':
        return certification.abandon(run);
    }
  }

  /**
   * Runs `work` and reports to the page if it fails.
   * @param {number} about the number of the run
   * @param {() => void} work
   */
  function guard(about, work) {
    try {
      work();
    } catch (error) {
      const input = error instanceof core.InputError;
      const message = error instanceof Error ? error.message : String(error);
      if (!input) pacing.rest();
      post({ type: 'failed', run: about, kind: input ? 'input' : 'internal', message });
    } finally {
      busy(!behind && (pacing.pace !== 'resting' || certification.works));
    }
  }

  return (command) => guard('run' in command ? command.run : run, () => obey(command));
}
