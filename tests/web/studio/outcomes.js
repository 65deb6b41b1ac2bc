// SPDX-License-Identifier: MIT
/**
 * @file Runs that have ended in different ways, for the tests of what is said of them and of what comes next.
 */
import {
  after,
  answered,
  certificate,
  energies,
  levelReport,
  noLimit,
  progress,
  running,
  surfaceState,
} from './state.js';

/** @typedef {import('../../../wasm/types.js').LevelReport} LevelReport */
/** @typedef {import('../../../wasm/types.js').Limit} Limit */
/** @typedef {import('../../../wasm/types.js').StopReason} StopReason */
/** @typedef {import('../../../web/pages/studio/state/types.js').Settings} Settings */
/** @typedef {import('../../../web/pages/studio/state/types.js').State} State */

/** @param {Partial<Limit>} more @returns {Limit} */
export const limit = (more) => ({ ...noLimit(), ...more });
const bar = limit({ status: 'converging', energy: 3913.2, order: 2, error: 30.1, lower: 3883.1 });
export const bound = limit({ status: 'not_converging', energy: 25.13, order: 0.4 });
export const folded = { ...energies(1e-20), below_bound: true, resolved: false };
/** Levels whose energies by the reporting rule are these. @param {...number} values */
export const levelsOf = (...values) => values.map((energy_reported, level) => levelReport(level, { energy_reported }));
export const three = levelsOf(300, 270, 251.3);
export const none = { ...certificate(), negative: 0 };

/** The settings of the run, as if it had been asked for with these. @param {State} state @param {Partial<Settings>} change @returns {State} */
export function asked(state, change) {
  const { document } = state;
  const settings = { ...document.settings, ...change };
  return { ...state, document: { ...document, settings, result: { ...document.result, settings } } };
}

/**
 * A run that has ended.
 * @param {object} what
 * @param {StopReason} [what.stop]
 * @param {LevelReport[]} [what.levels]
 * @param {Limit} [what.limit]
 * @param {Partial<Settings>} [what.settings]
 * @param {import('../../../wasm/types.js').CertificateReport} [what.certificate]
 * @param {import('../../../wasm/types.js').Energies} [what.energies]
 */
export function over({
  stop = 'converged',
  levels = three,
  limit: found = bar,
  settings = {},
  certificate: report,
  ...what
}) {
  return after(
    asked(running(), settings),
    ...levels.map((one) => answered({ type: 'levelEnded', run: 1, report: one, limit: found })),
    answered({ type: 'ended', run: 1, stop, progress: progress(2, 5) }),
    answered({ type: 'saved', run: 1, evaluations: 5, state: surfaceState(2, 9) }),
    answered({ type: 'measured', run: 1, evaluations: 5, level: 2, energies: what.energies ?? energies(113) }),
    ...(report ? [answered({ type: 'certified', run: 1, report })] : []),
  );
}
