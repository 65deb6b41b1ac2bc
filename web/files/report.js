// SPDX-License-Identifier: MIT
/**
 * @file The run as a JSON report with the fields that the command line writes, and the names of the files that are
 * saved.
 */
import { activeWeights } from '../state/settings.js';
import { stemOf } from '../words/cages.js';

/** @import {State} from '../state/types.js' */

/** JSON knows no NaN: what diverges is null. @param {number} value */
const orNull = (value) => (Number.isFinite(value) ? value : null);

/**
 * @param {State} state with a cage
 * @returns {string}
 */
export function reportJson(state) {
  const { cage, latest, runSettings, levels, limit, certificate, group, version } = state;
  const { quadratureError = NaN, ...energies } = latest?.energies ?? {};
  const objective =
    runSettings.functional === 'blend'
      ? { weights: activeWeights(runSettings) }
      : { functional: runSettings.functional };
  const report = {
    version,
    input: cage && { name: cage.name, ...cage.counts },
    ...objective,
    cap: runSettings.cap,
    ...(group && { group }),
    energies: Object.fromEntries(Object.entries(energies).map(([name, value]) => [name, orNull(value)])),
    quadrature_error: orNull(quadratureError),
    ...(limit && {
      extrapolated: {
        status: limit.status,
        energy: orNull(limit.energy),
        order: orNull(limit.order),
        error: orNull(limit.error),
      },
    }),
    levels: levels.map(({ energyReported, ...level }) => ({
      level: level.level,
      patches: level.patches,
      unknowns: level.unknowns,
      energy: orNull(level.energy),
      energy_reported: orNull(energyReported),
      iterations: level.iterations,
      evaluations: level.evaluations,
      seconds: level.seconds,
      stop: level.stop,
      metric: level.metric,
      metrics: level.metrics,
      evaluable: level.evaluable,
      ...(level.quadrature && { quadrature: level.quadrature }),
    })),
    ...(certificate && { certificate }),
  };
  return `${JSON.stringify(report, null, 2)}\n`;
}

/**
 * "two-3-mvs_cross-level2.obj", "two-3-mvs_cross-level2-limit.obj", "two-3-mvs_cross.json"; without the functional
 * before a run.
 * @param {State} state
 * @param {'control' | 'limit' | 'report'} what
 */
export function fileName(state, what) {
  const parts = [stemOf(state.cage?.name ?? 'cage')];
  if (state.samples.length) parts.push(state.runSettings.functional);
  if (what === 'report') return `${parts.join('-')}.json`;
  parts.push(`level${state.saved?.level ?? 0}`);
  if (what === 'limit') parts.push('limit');
  return `${parts.join('-')}.obj`;
}
