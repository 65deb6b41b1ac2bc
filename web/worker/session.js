// SPDX-License-Identifier: MIT
/**
 * @file What the worker does with the messages: holds the run that is open, steps it one energy evaluation at a time,
 * and tells the page about it no more often than the page can show. Knows neither workers nor timers: posting, yielding
 * and the clock are given.
 */
import { createCertification } from './certification.js';
import { MOVING_QUADS, RESTING_QUADS, SAVED_QUADS, densityFor } from './density.js';
import { createExpectation } from './expectation.js';
import { Occasion } from './occasion.js';

/** @import {Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh, Problem} from '../../wasm/types.js' */
/** @import {Command, Exportable, Message, Open} from './protocol.js' */
/** @import {parseReport} from '../../wasm/umbilic.js' */

/**
 * @typedef {object} Surroundings
 * @property {{Minimizer: typeof Minimizer, InputError: new (message: string) => Error, parseReport: typeof parseReport}} core
 * @property {(message: Message) => void} post
 * @property {(task: () => void) => void} yieldThen runs the task after the messages that have arrived meanwhile
 * @property {() => number} now milliseconds
 * @property {() => void} [rested] is called when all has been told of a surface that rests, and its level is prepared
 */

/** Milliseconds between two meshes, and between two messages about steps. */
const SURFACE_INTERVAL = 1000 / 15;
const STEP_INTERVAL = 1000 / 20;
/** Milliseconds between two copies of the surface for safe keeping. */
const SAVE_INTERVAL = 2000;
/** Milliseconds between two measurements of all energies, and the most that one may take while a run goes on. */
const MEASURE_INTERVAL = 1000;
const MEASURE_LIMIT = 60;
/** A measurement takes at most about this many times as long as a step. */
const MEASURE_STEPS = 8;
/** Patches of the largest level that is prepared before it is asked for: more take memory that looking does not. */
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
  /** Whether a run that has opened has told nothing more yet. */
  let introducing = false;
  /** Whether it is a minimizer that has not been shown yet. */
  let coarse = false;
  /** Whether it may be minimized: a minimizer is but looked at. */
  let startable = false;
  let levelsTold = 0;
  /** Of the surface that was told last: its level, faces of the mesh that it is evaluated on, and energy, if known. */
  let told = { level: -1, patches: 0, energy: NaN };
  /** Whether a surface has been told since the run began or went on. */
  let shown = false;
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
  /** The level at which a measurement has taken too long. */
  let slowLevel = -1;
  const certification = createCertification({ post, yieldThen: (task) => yieldThen(() => guard(run, task)) });

  const expectation = createExpectation({ core, yieldThen: (task) => yieldThen(() => guard(run, task)) });

  /** @returns {Minimizer} */
  function current() {
    if (!minimizer) throw new Error('no cage is open');
    return minimizer;
  }

  /** What a file has to say of itself. @param {Problem | string} problem @param {Minimizer} opened */
  function said(problem, opened) {
    if (typeof problem !== 'string') return {};
    const { cage, terms, options } = opened.problem;
    const { umbilic, levels, limit, energies, certificate } = core.parseReport(problem);
    const report = umbilic === 'report' && { report: { levels, limit, energies, certificate } };
    return { asked: { cage, terms, options }, ...report };
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
    levelsTold = 0;
    told = { level: -1, patches: 0, energy: NaN };
    firstEnergy = NaN;
    savedEvaluations = -1;
    measuredEvaluations = -1;
    samples = [];
    surfaceOccasion.postpone();
    post({ type: 'opened', run, cage: opened.cage, group: opened.group, ...said(command.problem, opened) });
    yieldThen(() => guard(command.run, () => introduce(command.run)));
    if (command.then) go(command.then === 'run' ? 'running' : 'stepping');
  }

  /**
   * A cage that rests is shown finely, a minimizer coarsely until more is asked for; one that is to be minimized at once is not, because
   * what moves comes sooner.
   * @param {number} opened
   */
  function introduce(opened) {
    if (!introducing || run !== opened) return;
    if (pace === 'resting' && coarse) {
      coarse = false;
      return tellSurface(MOVING_QUADS, true);
    }
    if (pace === 'resting') return tellRest();
    tellEnergies();
    surfaceOccasion.postpone();
  }

  /** @param {Mesh} coarsest limit mesh, which has one quad for each face of the mesh that the surface is evaluated on */
  const facesOf = (coarsest) => coarsest.triangles.length / 6;

  /** Faces of the mesh that the surface is evaluated on; the control mesh may be coarser. */
  function patches() {
    return current().progress.level === told.level ? told.patches : facesOf(current().limitMesh(1));
  }

  /** @param {number} quads @param {boolean} [first] whether a finer one is to be asked for */
  function tellSurface(quads, first = false) {
    const { level, energy, total_evaluations } = current().progress;
    const coarsest = level === told.level ? null : current().limitMesh(1);
    told = { level, patches: coarsest ? facesOf(coarsest) : told.patches, energy };
    shown = true;
    const control = current().controlMesh();
    const density = densityFor(told.patches, quads);
    const limit = coarsest && density === 1 ? coarsest : current().limitMesh(density);
    post({ type: 'surfaced', run, evaluations: total_evaluations, limit, control, ...(first && { coarse: true }) });
  }

  function tellSaved() {
    savedEvaluations = current().progress.total_evaluations;
    post({ type: 'saved', run, evaluations: savedEvaluations, state: current().state });
  }

  function tellEnergies() {
    const start = now();
    const { energies } = current();
    if (now() - start > MEASURE_LIMIT) slowLevel = current().progress.level;
    measuredEvaluations = current().progress.total_evaluations;
    post({ type: 'measured', run, evaluations: measuredEvaluations, energies });
  }

  function tellSteps() {
    const packed = Float64Array.from(samples);
    samples = [];
    post({ type: 'stepped', run, progress: current().progress, samples: packed });
  }

  /** Everything that the page may not have yet, now that the surface rests. */
  function tellRest() {
    introducing = false;
    tellSurface(RESTING_QUADS);
    tellSaved();
    tellEnergies();
    prepareAhead(run);
  }

  /**
   * What the first step of a level takes, in parts between the messages, so that the surface moves at once when it is to.
   * @param {number} opened
   */
  function prepareAhead(opened) {
    if (opened !== run || pace !== 'resting') return;
    if (!startable || told.patches > MOST_PATCHES_AHEAD || current().progress.phase !== 'prepare') return rested();
    current().step(1);
    yieldThen(() => guard(opened, () => prepareAhead(opened)));
  }

  function tellLevels() {
    if (current().progress.ended_levels === levelsTold) return;
    const { levels, limit } = current();
    for (const report of levels.slice(levelsTold)) post({ type: 'levelEnded', run, report, limit });
    levelsTold = levels.length;
    tellEnergies(); // The core has just computed them for its own report.
  }

  /** @param {boolean} done */
  function tellProgress(done) {
    if (samples.length && (done || stepOccasion.due)) stepOccasion.do(tellSteps);
    tellLevels();
    if (!done) tellOnTheWay();
  }

  /** The first surface that has moved first; then one thing at a time, so that pause and cancel never wait for two. */
  function tellOnTheWay() {
    const { total_evaluations: evaluations, level, energy } = current().progress;
    // The first evaluation is that of the surface at rest.
    if (evaluations === 1) firstEnergy = energy;
    if (level === told.level && Number.isNaN(told.energy)) told.energy = energy;
    // It rises where the core goes on with a finer quadrature rule.
    const moved = level !== told.level || (energy !== told.energy && !Number.isNaN(energy));
    const quick = stepCost * MEASURE_STEPS < MEASURE_LIMIT && level !== slowLevel;
    if (moved && (surfaceOccasion.due || (!shown && energy < firstEnergy))) {
      surfaceOccasion.do(() => tellSurface(MOVING_QUADS));
    } else if (!shown) {
      return;
    } else if (saveOccasion.due && evaluations !== savedEvaluations) {
      saveOccasion.do(tellSaved);
    } else if (quick && measureOccasion.due && evaluations !== measuredEvaluations) {
      measureOccasion.do(tellEnergies);
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
    tellProgress(done);
    if (done) return end();
    if (pace === 'stepping' && evaluated) return rest();
    keepTicking();
  }

  /**
   * The next tick comes after the messages that have arrived, so that pause and cancel wait for one evaluation at
   * most.
   */
  function keepTicking() {
    if (ticking) return;
    ticking = true;
    yieldThen(() => guard(run, tick));
  }

  function rest() {
    pace = 'resting';
    if (samples.length) tellSteps();
    post({ type: 'paused', run, progress: current().progress });
    tellRest();
  }

  /** The answer first, what takes longer afterwards. */
  function end() {
    pace = 'resting';
    if (samples.length) tellSteps();
    const levels = current().levels;
    const stop = levels.length ? levels[levels.length - 1].stop : 'cancelled';
    post({ type: 'ended', run, stop, progress: current().progress });
    tellLevels();
    tellRest();
  }

  /** Ending a level measures it once more, which the user need not wait for. */
  function cancel() {
    if (current().progress.phase === 'done') return end();
    pace = 'resting';
    if (samples.length) tellSteps();
    post({ type: 'ended', run, stop: 'cancelled', progress: current().progress });
    current().cancel();
    tellLevels();
    tellRest();
  }

  /** @param {'stepping' | 'running'} newPace */
  function go(newPace) {
    certification.drop();
    pace = newPace;
    slowLevel = -1;
    shown = false;
    stepOccasion.postpone(); // the first surface that has moved comes first
    keepTicking();
  }

  /** @param {Exportable} what */
  function exported(what) {
    if (what === 'control') return current().controlObj();
    if (what === 'limit') return current().limitObj(densityFor(patches(), SAVED_QUADS));
    return current().report(certification.ready() ?? undefined);
  }

  function certify() {
    if (pace === 'resting') certification.begin(run, current());
  }

  /** @param {Command} command */
  function obey(command) {
    if (command.type === 'ping') return post({ type: 'ponged' });
    if (command.type === 'open') return open(command);
    if (command.run > run) return; // The run did not open.
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
   * Does the work and tells the page when it fails.
   * @param {number} about the run
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
