// SPDX-License-Identifier: MIT
/**
 * @file How the worker reacts to messages: it keeps the open run, steps it one energy evaluation at a time, and reports
 * to the page no more often than the page can show. It knows neither workers nor timers; functions for posting,
 * yielding and the time are passed in.
 */
import { createCertification } from './certification.js';
import { MOVING_QUADS, RESTING_QUADS, SAVED_QUADS, densityFor } from './density.js';
import { createExpectation } from './expectation.js';
import { Occasion } from './occasion.js';
import { openedMessage } from './opened.js';
import { createSurfacing } from './surfacing.js';

/** @import {Cage, Minimizer, parseReport} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Command, Exportable, Message, Open} from './protocol.js' */

/**
 * @typedef {object} Surroundings
 * @property {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error, parseReport: typeof parseReport}} core
 * @property {(message: Message) => void} post
 * @property {(task: () => void) => void} yieldThen runs the task after the messages that have arrived by then
 * @property {() => number} now milliseconds
 * @property {() => void} [rested] called when everything about a surface at rest has been sent and its level is
 *   prepared
 */

/** Milliseconds between two meshes, and between two messages about steps. */
const SURFACE_INTERVAL = 1000 / 15;
const STEP_INTERVAL = 1000 / 20;
/** Milliseconds between two saved copies of the surface. */
const SAVE_INTERVAL = 2000;
/** Milliseconds between two measurements of all energies; also the longest that one may take during a run. */
const MEASURE_INTERVAL = 1000;
const MEASURE_LIMIT = 60;
/** A measurement takes at most about this many times as long as a step. */
const MEASURE_STEPS = 8;
/**
 * The largest number of patches of a level that is prepared in advance; a larger one takes memory that viewing does not
 * need.
 */
const MOST_PATCHES_AHEAD = 4000;

/**
 * @param {Surroundings} surroundings
 * @returns {(command: Command) => void}
 */
export function createSession({ core, post, yieldThen, now, rested = () => {} }) {
  /** @type {Minimizer | null} */
  let minimizer = null;
  let run = 0;
  /** @type {'resting' | 'stepping' | 'running'} */
  let pace = 'resting';
  let ticking = false;
  /** Whether an opened run has sent nothing but `opened` so far. */
  let introducing = false;
  /** Whether the surface is a minimizer that has only been shown coarsely. */
  let coarse = false;
  /** Whether the surface may be minimized; a minimizer from the catalog is only viewed. */
  let startable = false;
  let levelsSent = 0;
  /** The surface that was sent last: its level, the faces of its evaluated mesh, and its energy, if known. */
  let sent = { level: -1, patches: 0, energy: NaN };
  /** Whether a surface has been sent since the run began or continued. */
  let shown = false;
  const surfacing = createSurfacing(core);
  /** Whether the run has a report of constraints. */
  let constrained = false;
  let firstEnergy = NaN;
  let savedEvaluations = -1;
  let measuredEvaluations = -1;
  /** @type {number[]} */
  let samples = [];
  const stepOccasion = new Occasion(STEP_INTERVAL, now);
  const surfaceOccasion = new Occasion(SURFACE_INTERVAL, now);
  const saveOccasion = new Occasion(SAVE_INTERVAL, now);
  const measureOccasion = new Occasion(MEASURE_INTERVAL, now);
  let stepCost = Infinity;
  /** The level at which a measurement took too long. */
  let slowLevel = -1;
  const certification = createCertification({ post, yieldThen: (task) => yieldThen(() => guard(run, task)) });

  const expectation = createExpectation({ core, yieldThen: (task) => yieldThen(() => guard(run, task)) });

  /** @returns {Minimizer} */
  function current() {
    if (!minimizer) throw new Error('no cage is open');
    return minimizer;
  }

  /** @param {Open} command */
  function open(command) {
    const opened = expectation.take(command.problem);
    certification.drop();
    minimizer?.dispose();
    minimizer = opened;
    run = command.run;
    pace = 'resting';
    introducing = true;
    coarse = command.look ?? false;
    startable = !coarse;
    levelsSent = 0;
    sent = { level: -1, patches: 0, energy: NaN };
    surfacing.begin(command.deviation ?? false);
    firstEnergy = NaN;
    savedEvaluations = -1;
    measuredEvaluations = -1;
    samples = [];
    surfaceOccasion.postpone();
    const message = openedMessage(core, run, command.problem, opened);
    constrained = message.cage.boundaries.length > 0 || Object.keys(opened.problem.constraints).length > 0;
    post(message);
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
    if (pace === 'resting' && coarse) {
      coarse = false;
      return sendSurface(MOVING_QUADS, true);
    }
    if (pace === 'resting') return sendRest();
    sendEnergies();
    surfaceOccasion.postpone();
  }

  /** @param {Mesh} coarsest limit mesh with one quad for each face of the evaluated mesh */
  const facesOf = (coarsest) => coarsest.triangles.length / 6;

  /** Number of faces of the evaluated mesh; the control mesh may be coarser. */
  function patches() {
    return current().progress.level === sent.level ? sent.patches : facesOf(current().limitMesh(1));
  }

  /** @param {number} quads @param {boolean} [first] whether the page should ask for a finer one */
  function sendSurface(quads, first = false) {
    const { level, energy, total_evaluations } = current().progress;
    const coarsest = level === sent.level ? null : current().limitMesh(1);
    sent = { level, patches: coarsest ? facesOf(coarsest) : sent.patches, energy };
    shown = true;
    const density = densityFor(sent.patches, quads);
    const limit = coarsest && density === 1 ? coarsest : current().limitMesh(density);
    const surface = surfacing.of(current(), limit, density);
    post({ type: 'surfaced', run, evaluations: total_evaluations, ...surface, ...(first && { coarse: true }) });
  }

  function sendSaved() {
    savedEvaluations = current().progress.total_evaluations;
    post({ type: 'saved', run, evaluations: savedEvaluations, state: current().state });
  }

  function sendEnergies() {
    const start = now();
    const { energies } = current();
    const { level, total_evaluations } = current().progress;
    if (now() - start > MEASURE_LIMIT) slowLevel = level;
    measuredEvaluations = total_evaluations;
    post({ type: 'measured', run, evaluations: measuredEvaluations, level, energies });
  }

  /** What the constraints do to a surface that has been minimized; the report has it, and costs several evaluations. */
  function sendConstraints() {
    const { total_evaluations: evaluations } = current().progress;
    if (!constrained || !evaluations) return;
    const { constraints } = core.parseReport(current().report());
    if (constraints) post({ type: 'constrained', run, evaluations, report: constraints });
  }

  /** @param {boolean} on whether the distances from the cage's own surface are sent from now on */
  function deviate(on) {
    surfacing.deviate(on);
    if (on && minimizer && pace === 'resting' && sent.level >= 0) sendSurface(RESTING_QUADS);
  }

  function sendSteps() {
    const packed = Float64Array.from(samples);
    samples = [];
    post({ type: 'stepped', run, progress: current().progress, samples: packed });
  }

  /** Sends everything about a surface at rest. */
  function sendRest() {
    introducing = false;
    sendSurface(RESTING_QUADS);
    sendSaved();
    sendEnergies();
    sendConstraints();
    prepareAhead(run);
  }

  /**
   * Prepares the first step of a level, in parts between the messages, so that the surface will move at once.
   * @param {number} opened
   */
  function prepareAhead(opened) {
    if (opened !== run || pace !== 'resting') return;
    if (!startable || sent.patches > MOST_PATCHES_AHEAD || current().progress.phase !== 'prepare') return rested();
    current().step(1);
    yieldThen(() => guard(opened, () => prepareAhead(opened)));
  }

  function sendLevels() {
    if (current().progress.ended_levels === levelsSent) return;
    const { levels, limit } = current();
    for (const report of levels.slice(levelsSent)) post({ type: 'levelEnded', run, report, limit });
    levelsSent = levels.length;
    sendEnergies(); // fast: the core has just computed them for its own report
  }

  /** @param {boolean} done */
  function sendProgress(done) {
    if (samples.length && (done || stepOccasion.due)) stepOccasion.do(sendSteps);
    sendLevels();
    if (!done) sendWhileRunning();
  }

  /** Sends the first moved surface first, then one thing per call, so that pause and cancel never wait for two. */
  function sendWhileRunning() {
    const { total_evaluations: evaluations, level, energy } = current().progress;
    // The first evaluation is at the surface at rest.
    if (evaluations === 1) firstEnergy = energy;
    if (level === sent.level && Number.isNaN(sent.energy)) sent.energy = energy;
    // The energy rises if the core continues with a finer quadrature rule.
    const moved = level !== sent.level || (energy !== sent.energy && !Number.isNaN(energy));
    const quick = stepCost * MEASURE_STEPS < MEASURE_LIMIT && level !== slowLevel;
    if (moved && (surfaceOccasion.due || (!shown && energy < firstEnergy))) {
      surfaceOccasion.do(() => sendSurface(MOVING_QUADS));
    } else if (!shown) {
      return;
    } else if (saveOccasion.due && evaluations !== savedEvaluations) {
      saveOccasion.do(sendSaved);
    } else if (quick && measureOccasion.due && evaluations !== measuredEvaluations) {
      measureOccasion.do(sendEnergies);
    }
  }

  function tick() {
    ticking = false;
    if (pace === 'resting' || !minimizer) return;
    const before = minimizer.progress.total_evaluations;
    const start = now();
    const done = minimizer.step(1);
    stepCost = now() - start;
    const { total_evaluations, energy, gradient_norm, level } = minimizer.progress;
    const evaluated = total_evaluations > before;
    if (evaluated) samples.push(total_evaluations, energy, gradient_norm, level);
    sendProgress(done);
    if (done) return end();
    if (pace === 'stepping' && evaluated) return rest();
    keepTicking();
  }

  /**
   * Schedules the next step after the messages that have arrived, so that pause and cancel wait for at most one
   * evaluation.
   */
  function keepTicking() {
    if (ticking) return;
    ticking = true;
    yieldThen(() => guard(run, tick));
  }

  function rest() {
    pace = 'resting';
    if (samples.length) sendSteps();
    post({ type: 'paused', run, progress: current().progress });
    sendRest();
  }

  /** Sends the answer first, then what takes longer. */
  function end() {
    pace = 'resting';
    if (samples.length) sendSteps();
    const levels = current().levels;
    const stop = levels.length ? levels[levels.length - 1].stop : 'cancelled';
    post({ type: 'ended', run, stop, progress: current().progress });
    sendLevels();
    sendRest();
  }

  /** Answers before the core measures the ended level once more, so that the user need not wait. */
  function cancel() {
    if (current().progress.phase === 'done') return end();
    pace = 'resting';
    if (samples.length) sendSteps();
    post({ type: 'ended', run, stop: 'cancelled', progress: current().progress });
    current().cancel();
    sendLevels();
    sendRest();
  }

  /** @param {'stepping' | 'running'} newPace */
  function go(newPace) {
    certification.drop();
    pace = newPace;
    slowLevel = -1;
    shown = false;
    stepOccasion.postpone(); // the first moved surface comes first
    keepTicking();
  }

  /** @param {Exportable} what */
  function exported(what) {
    if (what === 'control') return current().controlObj();
    if (what === 'limit') return current().limitObj(densityFor(patches(), SAVED_QUADS));
    if (what === 'problem') return `${JSON.stringify(current().problem, null, 2)}\n`;
    return current().report(certification.ready() ?? undefined);
  }

  function certify() {
    if (pace === 'resting') certification.begin(run, current());
  }

  /** @param {Command} command */
  function obey(command) {
    if (command.type === 'ping') return post({ type: 'ponged' });
    if (command.type === 'open') return open(command);
    if (command.type === 'deviate') return deviate(command.on);
    if (command.run > run) return; // the run did not open
    if (command.run < run) {
      if (command.type === 'optimize' || command.type === 'step')
        throw new Error('the surface is no longer held by the worker');
      return;
    }
    switch (command.type) {
      case 'detail':
        return introduce(run);
      case 'expect':
        return expectation.begin(command.problem);
      case 'optimize':
        return go('running');
      case 'step':
        return go('stepping');
      case 'pause':
        return rest();
      case 'cancel':
        return cancel();
      case 'export':
        return post({ type: 'exported', run, what: command.what, text: exported(command.what) });
      case 'certify':
        return certify();
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
      if (!input) pace = 'resting';
      post({ type: 'failed', run: about, kind: input ? 'input' : 'internal', message });
    }
  }

  return (command) => guard('run' in command ? command.run : run, () => obey(command));
}
