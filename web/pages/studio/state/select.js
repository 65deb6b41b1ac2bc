// SPDX-License-Identifier: MIT
/**
 * @file What the views derive from the state: which buttons work, and the status in words.
 */
import { cageWords } from '../../../words/cages.js';
import { energyWarnings, roundingWords } from '../../../words/energies.js';
import { functionalWords } from '../../../words/functionals.js';
import { foundWords, freeWords } from '../../../words/holding.js';
import { integer } from '../../../words/numbers.js';
import { verdict } from '../../../words/verdict.js';
import { holdIsUsable } from './hold.js';
import { askedOf, certifyingOf, evaluationsOf } from './parts.js';
import { canBeCertified, canDescend, outcomeOf } from './next.js';
import { settingsAreFree } from './reduce.js';
import { activeWeights, problemWith } from './settings.js';

/** @import {Energies, FunctionalName, Limit} from '../../../../wasm/types.js' */
/** @import {Action, Opening, Settings, State} from './types.js' */

/** @typedef {{label: string, action: Action['type'], enabled: boolean}} Button */

/**
 * The run's buttons. The first one starts, pauses or resumes.
 * @param {State} state
 * @returns {{primary: Button, step: Button, cancel: Button, reset: Button}}
 */
export function runButtons(state) {
  const { document, session } = state;
  const { phase, opening } = session;
  const asked = askedOf(phase);
  const usable =
    document.cage !== null && !problemWith(document.settings) && holdIsUsable(state) && phase.name !== 'unavailable';
  const startable = usable && (!opening || opening.then === 'hold') && opening?.purpose !== 'cage';
  const active = (phase.name === 'running' || phase.name === 'paused') && !opening;
  const still = phase.name === 'resting' || phase.name === 'paused' || phase.name === 'ended';
  /** @type {Button} */
  let primary = { label: 'Start', action: 'startPressed', enabled: startable && settingsAreFree(state) };
  if (phase.name === 'running') primary = { label: 'Pause', action: 'pausePressed', enabled: active && !asked };
  if (phase.name === 'paused') primary = { label: 'Resume', action: 'startPressed', enabled: active && !asked };
  return {
    primary,
    step: { label: 'Step', action: 'stepPressed', enabled: startable && !asked && still },
    cancel: { label: 'Cancel', action: 'cancelPressed', enabled: (active && asked !== 'cancel') || opening !== null },
    reset: {
      label: 'Reset',
      action: 'resetPressed',
      enabled: usable && !opening && (document.result.samples.length > 0 || active || phase.name === 'ended'),
    },
  };
}

/**
 * The certificate's button, which begins or cancels it.
 * @param {State} state
 * @returns {Button}
 */
export function certificateButton(state) {
  const certifying = certifyingOf(state.session.phase);
  if (canDescend(state)) return { label: 'Descend', action: 'descendPressed', enabled: true };
  if (!certifying) return { label: 'Check', action: 'certifyPressed', enabled: canBeCertified(state) };
  return { label: 'Cancel', action: 'certificateCancelPressed', enabled: !certifying.abandoning };
}

/** What is being opened, in a sentence. @param {Opening} opening @returns {string | null} null if that is not worth one */
function openingSentence({ purpose, source }) {
  if (purpose === 'cage') return `Opening ${titleOf(source.name)} …`;
  if (purpose === 'recovery') return 'Bringing the surface back …';
  return purpose === 'entry' ? 'Opening the catalog’s minimizer …' : null;
}

/**
 * The current activity, in a sentence that changes only when something begins or ends.
 * @param {State} state
 */
export function statusSentence(state) {
  const { document, session } = state;
  const { phase, opening } = session;
  if (phase.name === 'unavailable') return 'The computation is not available.';
  const sentence = opening && openingSentence(opening);
  if (sentence) return sentence;
  if (phase.name === 'loading') return 'Loading …';
  const asked = askedOf(phase);
  if (asked) return asked === 'pause' ? 'Pausing …' : 'Cancelling …';
  if (!document.cage) return 'Drop a cage file on the page, or choose a shape.';
  if (phase.name === 'running') return 'Minimizing …';
  if (certifyingOf(phase)) return 'Looking for surfaces near it with less energy …';
  const outcome = outcomeOf(state);
  if (outcome) return verdict(outcome).sentence;
  return holdIsUsable(state) ? 'Ready.' : 'Cannot start: see Hold.';
}

/**
 * The level of a run's result, if the run has ended with a better surface than that of its last level.
 * @param {State} state
 * @returns {number | null}
 */
export function earlierLevel(state) {
  const { latest, levels } = state.document.result;
  const last = levels.at(-1);
  if (state.session.phase.name !== 'ended' || !latest || !last) return null;
  const current = latest.evaluations >= evaluationsOf(state);
  return current && latest.level < last.level ? latest.level : null;
}

/**
 * The limit of the levels and the error of the last integration, if they are final and the surface's own. Where the catalog
 * knows better than its levels, they tell nothing.
 * @param {State} state
 * @returns {{limit: Limit | null, integration: number | null}}
 */
export function errorsOf({ document: { result, minimizer }, session: { phase } }) {
  const over = phase.name === 'ended' && result.stop !== 'interrupted';
  const known = !result.catalogs || minimizer?.entry.status === 'converged';
  const credible = result.latest?.energies.resolved && !result.latest.energies.below_bound;
  const error = result.latest?.energies.quadrature_error ?? NaN;
  return {
    limit: over && known ? result.limit : null,
    integration: over && credible && result.levels.length > 0 && error > 0 ? error : null,
  };
}

/**
 * What is to be said of the energies in the table. Whether they can be the surface's is said while nothing moves.
 * @param {State} state
 * @returns {Array<{words: string, warning?: boolean}>}
 */
export function energyNotes(state) {
  const { latest, settings, constrained } = state.document.result;
  if (!latest) return [{ words: 'They appear with a surface.' }];
  if (state.session.phase.name === 'running') {
    const stale = evaluationsOf(state) > latest.evaluations;
    return stale ? [{ words: `As of evaluation ${integer(latest.evaluations)}.` }] : [];
  }
  const level = earlierLevel(state);
  const terms = /** @type {FunctionalName[]} */ (Object.keys(activeWeights(settings)));
  const rounding = roundingWords(latest.energies.input_rounding);
  return [
    ...(level === null ? [] : [{ words: `Of level ${level}, which is better than the last one.` }]),
    ...freeWords(latest.energies, terms).map((words) => ({ words })),
    ...foundWords(constrained, settings.constraints).map((words) => ({ words })),
    ...(rounding ? [{ words: rounding }] : []),
    ...energyWarnings(latest.energies).map((words) => ({ words, warning: true })),
  ];
}

/** A cage's name as the page shows it: generated ones in words, files by their name. @param {string} name */
export function titleOf(name) {
  return cageWords(name).title;
}

/** What a document is called. @param {State} state */
export function documentName({ document, session }) {
  return titleOf(document.cage?.name ?? session.opening?.source.name ?? document.generator.name);
}

/** @param {Settings} settings */
export function objectiveName(settings) {
  if (settings.functional !== 'blend') return functionalWords(settings.functional).name;
  return Object.entries(activeWeights(settings))
    .map(([id, weight]) => `${weight} × ${functionalWords(/** @type {FunctionalName} */ (id)).name}`)
    .join(' + ');
}

/**
 * The value of the objective: the weighted sum of energies, over the free faces where some are held; NaN if one of them
 * diverges.
 * @param {Settings} settings
 * @param {Energies} energies
 */
export function objectiveValue(settings, energies) {
  return Object.entries(activeWeights(settings)).reduce(
    (sum, [id, weight]) => sum + weight * (energies.free ?? energies)[/** @type {FunctionalName} */ (id)],
    0,
  );
}
