// SPDX-License-Identifier: MIT
/**
 * @file What the worker does with the messages: holds the run that is open, steps it one energy evaluation at a time,
 * and tells the page about it no more often than the page can show. Knows neither workers nor timers: posting, yielding
 * and the clock are given.
 */
import { MOVING_QUADS, RESTING_QUADS, SAVED_QUADS, densityFor } from './density.js';

/** @import {Cage, Minimizer} from '../../wasm/umbilic.js' */
/** @import {Command, Message, Open} from './protocol.js' */

/**
 * @typedef {object} Surroundings
 * @property {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error}} core
 * @property {(message: Message) => void} post
 * @property {(task: () => void) => void} yieldThen runs the task after the messages that have arrived meanwhile
 * @property {() => number} now milliseconds
 */

/** Milliseconds between two meshes, and between two messages about steps. */
const SURFACE_INTERVAL = 1000 / 15;
const STEP_INTERVAL = 1000 / 20;
/** Milliseconds between two copies of the control mesh for safe keeping. */
const SAVE_INTERVAL = 2000;
/** Milliseconds between two measurements of all energies, and the most that one may take while a run goes on. */
const MEASURE_INTERVAL = 1000;
const MEASURE_LIMIT = 60;
/** A measurement takes at most about this many times as long as a step. */
const MEASURE_STEPS = 8;
/** No side work may take more than this part of the time. */
const SIDE_SHARE = 0.25;

/** Something done now and then, at most once per interval and only for a share of the time. */
class Occasion {
  #interval;
  #now;
  #due = 0;

  /** @param {number} interval @param {() => number} now */
  constructor(interval, now) {
    this.#interval = interval;
    this.#now = now;
  }

  get due() {
    return this.#now() >= this.#due;
  }

  /** @param {() => void} work */
  do(work) {
    const start = this.#now();
    work();
    const end = this.#now();
    this.#due = Math.max(start + this.#interval, end + (end - start) / SIDE_SHARE);
  }
}

/**
 * @param {Surroundings} surroundings
 * @returns {(command: Command) => void}
 */
export function createSession({ core, post, yieldThen, now }) {
  /** @type {Minimizer | null} */
  let minimizer = null;
  let run = 0;
  let patches = 0;
  /** @type {'resting' | 'stepping' | 'running'} */
  let pace = 'resting';
  let ticking = false;
  let levelsTold = 0;
  let surfaceEvaluations = -1;
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

  /** @returns {Minimizer} */
  function current() {
    if (!minimizer) throw new Error('no cage is open');
    return minimizer;
  }

  /** @param {Open} command */
  function open(command) {
    const { source } = command;
    const cage =
      source.kind === 'text'
        ? core.Cage.read(source.text)
        : core.Cage.generate(source.name, { family: source.family, thickness: source.thickness });
    try {
      const opened = new core.Minimizer(cage, command.options);
      minimizer?.dispose();
      minimizer = opened;
      run = command.run;
      pace = 'resting';
      levelsTold = 0;
      surfaceEvaluations = -1;
      savedEvaluations = -1;
      measuredEvaluations = -1;
      samples = [];
      post({ type: 'opened', run, counts: cage.counts });
    } finally {
      cage.dispose();
    }
    tellSurface(RESTING_QUADS);
    tellSaved();
    tellEnergies();
  }

  /** @param {number} quads */
  function tellSurface(quads) {
    const control = current().controlMesh();
    patches = control.edges.length / 4; // all faces are quads and the mesh is closed
    const limit = current().limitMesh(densityFor(patches, quads));
    surfaceEvaluations = current().progress.totalEvaluations;
    post({ type: 'surfaced', run, evaluations: surfaceEvaluations, limit, control });
  }

  function tellSaved() {
    const { level, totalEvaluations } = current().progress;
    savedEvaluations = totalEvaluations;
    post({ type: 'saved', run, level, evaluations: totalEvaluations, obj: current().controlObj() });
  }

  function tellEnergies() {
    const start = now();
    const { energies } = current();
    if (now() - start > MEASURE_LIMIT) slowLevel = current().progress.level;
    measuredEvaluations = current().progress.totalEvaluations;
    post({ type: 'measured', run, evaluations: measuredEvaluations, energies });
  }

  function tellSteps() {
    const packed = Float64Array.from(samples);
    samples = [];
    post({ type: 'stepped', run, progress: current().progress, samples: packed });
  }

  /** Everything that the page may not have yet, now that the surface rests. */
  function tellRest() {
    tellSurface(RESTING_QUADS);
    tellSaved();
    tellEnergies();
  }

  function tellLevels() {
    if (current().levelCount === levelsTold) return;
    for (const report of current().levels.slice(levelsTold)) post({ type: 'levelEnded', run, report });
    levelsTold = current().levelCount;
    tellEnergies(); // The core has just computed them for its own report.
  }

  /** @param {boolean} done */
  function tellProgress(done) {
    if (samples.length && (done || stepOccasion.due)) stepOccasion.do(tellSteps);
    tellLevels();
    if (!done) tellOnTheWay();
  }

  /** One thing at a time, so that pause and cancel never wait for two. */
  function tellOnTheWay() {
    const { totalEvaluations: evaluations, level } = current().progress;
    const quick = stepCost * MEASURE_STEPS < MEASURE_LIMIT && level !== slowLevel;
    if (saveOccasion.due && evaluations !== savedEvaluations) saveOccasion.do(tellSaved);
    else if (quick && measureOccasion.due && evaluations !== measuredEvaluations) measureOccasion.do(tellEnergies);
    else if (surfaceOccasion.due && evaluations !== surfaceEvaluations) {
      surfaceOccasion.do(() => tellSurface(MOVING_QUADS));
    }
  }

  function tick() {
    ticking = false;
    if (pace === 'resting' || !minimizer) return;
    const before = minimizer.progress.totalEvaluations;
    const start = now();
    const done = minimizer.step(1);
    stepCost = now() - start;
    const { totalEvaluations, energy, gradientNorm, level } = minimizer.progress;
    const evaluated = totalEvaluations > before;
    if (evaluated) samples.push(totalEvaluations, energy, gradientNorm, level);
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
    pace = newPace;
    slowLevel = -1;
    keepTicking();
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
      case 'optimize':
        return go('running');
      case 'step':
        return go('stepping');
      case 'pause':
        return rest();
      case 'cancel':
        return cancel();
      case 'export':
        return post({ type: 'exported', run, obj: current().limitObj(densityFor(patches, SAVED_QUADS)) });
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
