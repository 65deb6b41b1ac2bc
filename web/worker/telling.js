// SPDX-License-Identifier: MIT
/**
 * @file What the page is told of a run, and when: surfaces, copies for safe keeping, energies, steps and levels, none of
 * them twice, and no more often than the page can show.
 */
import { crossingsOf } from './crossings.js';
import { MOVING_QUADS, RESTING_QUADS, densityFor } from './density.js';
import { Occasion } from './occasion.js';
import { createSurfacing } from './surfacing.js';

/** @import {Cage, Minimizer, parseReport} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Wish} from './computed.js' */
/** @import {Message} from './protocol.js' */

/** Milliseconds between two meshes, and between two messages about steps. */
const SURFACE_INTERVAL = 1000 / 15;
const STEP_INTERVAL = 1000 / 20;
/** Milliseconds between two copies of the surface. The page writes them down; what is later is lost with the browser. */
const SAVE_INTERVAL = 1000;
/** Milliseconds between two measurements of all energies; also the longest that one may take during a run. */
const MEASURE_INTERVAL = 1000;
const MEASURE_LIMIT = 60;
/** A measurement takes at most about this many times as long as a step. */
const MEASURE_STEPS = 8;

/** What has been told of one run. */
const nothingTold = () => ({
  levels: 0,
  /** The surface that was sent last: its level, the faces of its evaluated mesh, and its energy, if known. */
  surface: { level: -1, patches: 0, energy: NaN },
  /** Whether a surface has been sent since the run began or went on. */
  shown: false,
  /** Of the start. */
  energy: NaN,
  /** The evaluations of the last copy, and of the last measurement. */
  saved: -1,
  measured: -1,
});

/** @param {Mesh} coarsest limit mesh with one quad for each face of the evaluated mesh */
const facesOf = (coarsest) => coarsest.triangles.length / 6;

/**
 * @param {object} surroundings
 * @param {{Cage: typeof Cage, Minimizer: typeof Minimizer, InputError: new (message: string) => Error,
 *   parseReport: typeof parseReport}} surroundings.core
 * @param {(message: Message) => void} surroundings.post
 * @param {() => number} surroundings.now milliseconds
 */
export function createTelling({ core, post, now }) {
  const surfacing = createSurfacing(core);
  const occasions = {
    step: new Occasion(STEP_INTERVAL, now),
    surface: new Occasion(SURFACE_INTERVAL, now),
    save: new Occasion(SAVE_INTERVAL, now),
    measure: new Occasion(MEASURE_INTERVAL, now),
  };
  /** @type {Minimizer | null} */
  let minimizer = null;
  let run = 0;
  let constrained = false;
  let told = nothingTold();
  /** @type {number[]} */
  let samples = [];
  /** The level at which a measurement took too long. */
  let slowLevel = -1;

  /** @returns {Minimizer} */
  function current() {
    if (!minimizer) throw new Error('no cage is open');
    return minimizer;
  }

  /** @param {number} quads @param {boolean} [first] whether the page should ask for a finer one */
  function surface(quads, first = false) {
    const { level, energy, total_evaluations } = current().progress;
    const coarsest = level === told.surface.level ? null : current().limitMesh(1);
    told.surface = { level, patches: coarsest ? facesOf(coarsest) : told.surface.patches, energy };
    told.shown = true;
    const density = densityFor(told.surface.patches, quads);
    const limit = coarsest && density === 1 ? coarsest : current().limitMesh(density);
    const sent = surfacing.of(current(), limit, density);
    const { patches } = told.surface;
    post({ type: 'surfaced', run, evaluations: total_evaluations, patches, ...sent, ...(first && { coarse: true }) });
  }

  /** Number of faces of the evaluated mesh; the control mesh may be coarser. */
  function patches() {
    const { level, patches: known } = told.surface;
    return current().progress.level === level ? known : facesOf(current().limitMesh(1));
  }

  function saved() {
    told.saved = current().progress.total_evaluations;
    post({ type: 'saved', run, evaluations: told.saved, state: current().state });
  }

  function energies() {
    const start = now();
    const { energies: found } = current();
    const { level, total_evaluations } = current().progress;
    if (now() - start > MEASURE_LIMIT) slowLevel = level;
    told.measured = total_evaluations;
    post({ type: 'measured', run, evaluations: told.measured, level, energies: found });
  }

  /** What the constraints do to a surface that has been minimized; the report has it, and costs several evaluations. */
  function constraints() {
    const { total_evaluations: evaluations } = current().progress;
    if (!constrained || !evaluations) return;
    const { constraints: report } = core.parseReport(current().report());
    if (report) post({ type: 'constrained', run, evaluations, report });
  }

  function steps() {
    if (!samples.length) return;
    const packed = Float64Array.from(samples);
    samples = [];
    post({ type: 'stepped', run, progress: current().progress, samples: packed });
  }

  function levels() {
    if (current().progress.ended_levels === told.levels) return;
    const { levels: ended, limit } = current();
    for (const report of ended.slice(told.levels)) post({ type: 'levelEnded', run, report, limit });
    told.levels = ended.length;
    energies(); // fast: the core has just computed them for its own report
  }

  /**
   * Tells the first moved surface first, then one thing per call, so that pause and cancel never wait for two.
   * @param {number} cost milliseconds of a step
   */
  function oneThing(cost) {
    const { total_evaluations: evaluations, level, energy } = current().progress;
    const { surface: last } = told;
    // The first evaluation is at the surface at rest.
    if (evaluations === 1) told.energy = energy;
    if (level === last.level && Number.isNaN(last.energy)) last.energy = energy;
    // The energy rises if the core continues with a finer quadrature rule.
    const moved = level !== last.level || (energy !== last.energy && !Number.isNaN(energy));
    const quick = cost * MEASURE_STEPS < MEASURE_LIMIT && level !== slowLevel;
    if (moved && (occasions.surface.due || (!told.shown && energy < told.energy))) {
      occasions.surface.do(() => surface(MOVING_QUADS));
    } else if (!told.shown) {
      return;
    } else if (occasions.save.due && evaluations !== told.saved) {
      occasions.save.do(saved);
    } else if (quick && occasions.measure.due && evaluations !== told.measured) {
      occasions.measure.do(energies);
    }
  }

  return {
    surface,
    energies,
    steps,
    levels,

    /**
     * Begins to tell of another run.
     * @param {number} number of the run
     * @param {Minimizer} opened
     * @param {{constrained: boolean, wish: Wish | null}} about whether it has a report of constraints, and what is to
     *   be computed of its surfaces
     */
    begin(number, opened, about) {
      run = number;
      minimizer = opened;
      ({ constrained } = about);
      told = nothingTold();
      samples = [];
      surfacing.begin(about.wish);
      occasions.surface.postpone();
    },

    /** The run goes on: its first moved surface comes first. */
    goOn() {
      slowLevel = -1;
      told.shown = false;
      occasions.step.postpone();
    },

    /** What was told of the run no longer holds, but for its meshes' topology. @param {boolean} runs */
    retargeted(runs) {
      const { level, patches } = told.surface;
      told = { ...nothingTold(), surface: { level, patches, energy: NaN } };
      samples = [];
      slowLevel = -1;
      post({ type: 'retargeted', run, runs, group: current().group });
    },

    /** Tells no surface before another interval has passed. */
    postpone: () => occasions.surface.postpone(),

    /** Keeps what the last evaluation found, for the next message about steps. */
    sample() {
      const { total_evaluations, energy, gradient_norm, level } = current().progress;
      samples.push(total_evaluations, energy, gradient_norm, level);
    },

    /** Tells what is due after a step. @param {boolean} done whether the run has ended @param {number} cost of the step, in milliseconds */
    progress(done, cost) {
      if (samples.length && (done || occasions.step.due)) occasions.step.do(steps);
      levels();
      if (!done) oneThing(cost);
    },

    /** Tells everything about a surface at rest. */
    rest() {
      surface(RESTING_QUADS);
      saved();
      energies();
      constraints();
    },

    /** @param {Wish | null} wish what is computed of surfaces from now on */
    wishFor: (wish) => surfacing.wishFor(wish),

    /** Tells the surface at rest again. */
    again() {
      if (minimizer && told.surface.level >= 0) surface(RESTING_QUADS);
    },

    patches,

    /** Tells where the surface at rest crosses itself. */
    crossings() {
      const crossings = crossingsOf(current().limitMesh(densityFor(patches(), RESTING_QUADS)));
      post({ type: 'searched', run, evaluations: current().progress.total_evaluations, crossings });
    },

    /** Tells the surface and the cage that the run began from. */
    recall: () =>
      post({ type: 'recalled', run, ...surfacing.recalled(current(), densityFor(patches(), RESTING_QUADS)) }),
  };
}
