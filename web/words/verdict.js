// SPDX-License-Identifier: MIT
/**
 * @file What came out of a run, in one sentence, and the one thing to do next. All that the page says of a result follows
 * from here; what the other texts add are details.
 */
import { counted, percent, significant, withError } from './numbers.js';

/** @import {CertificateReport, LevelReport, Limit, StopReason} from '../../wasm/types.js' */
/** @import {EntryStatus} from '../files/catalog.js' */

/** What can be done next. @typedef {'finer' | 'goOn' | 'check' | 'descend'} Next */

/** What the button of each says. @type {Record<Next, string>} */
export const nextWords = {
  finer: 'Go one level finer',
  goOn: 'Go on',
  check: 'Check that it is a minimum',
  descend: 'Descend',
};

/**
 * @typedef {object} Outcome
 * @property {'paused' | 'ended'} phase
 * @property {StopReason | 'interrupted' | null} stop null while it is paused
 * @property {number} energy of the last surface of the run; NaN before the first
 * @property {number} level of that surface
 * @property {LevelReport[]} levels that have ended
 * @property {Limit | null} limit
 * @property {number | null} accuracy that was asked for, as a part of the limit
 * @property {number} maxIterations per level
 * @property {CertificateReport | null} certificate of the surface
 * @property {'nothing' | 'boundary' | 'part'} held
 * @property {EntryStatus | null} catalog what the catalog knows of the surface, if it is the catalog's
 * @property {Next[]} possible what the page can do now
 */

/** A sentence, and what to do next: the first of these that is possible. @typedef {{sentence: string, wishes: Next[]}} Finding */

/** An error bar needs this many levels. */
export const ENOUGH_LEVELS = 3;
/** So many levels that do not settle are not likely to do so on a finer one. */
const MANY_LEVELS = 5;
/** Number of digits of energies without an error, and of an error. */
const DIGITS = 4;
const ERROR_DIGITS = 2;
/** A larger error, as a part of the energy, is told as a range. */
const WIDE_ERROR = 0.3;

const STILL_FALLING = 'it was still falling';

/** @param {number} energy */
const number = (energy) => significant(energy, DIGITS);

/** @param {LevelReport[]} levels */
const evaluated = (levels) => levels.filter(({ evaluable }) => evaluable);
/** Those whose energies can be their surfaces'. @param {LevelReport[]} levels */
const credible = (levels) => evaluated(levels).filter((level) => level.credible !== false);

/**
 * The sentence about a result, and the next action, which is null where the run's own buttons are all there is to do.
 * @param {Outcome} outcome
 * @returns {{sentence: string, next: Next | null}}
 */
export function verdict(outcome) {
  const { sentence, wishes } = finding(outcome);
  return { sentence, next: wishes.find((wish) => outcome.possible.includes(wish)) ?? null };
}

/** @param {Outcome} outcome @returns {Finding} */
function finding(outcome) {
  const { phase, stop, catalog, levels } = outcome;
  if (phase === 'paused') return halted(outcome, 'Paused');
  if (catalog) return ofTheCatalog(outcome, catalog);
  switch (stop) {
    case 'cancelled':
      return halted(outcome, 'Stopped');
    case 'interrupted':
      return halted(outcome, 'Broken off');
    case 'not_finite':
      return { sentence: 'Nothing was minimized: the energy of this surface is not finite.', wishes: [] };
  }
  if (stop === 'below_bound' || stop === 'not_resolved' || levels.at(-1)?.credible === false) return folded(outcome);
  switch (stop) {
    case 'max_iterations': {
      const most = counted(outcome.maxIterations, 'iteration');
      return early(outcome, `Stopped after ${most}, the most allowed,`);
    }
    case 'line_search_stalled':
      return {
        sentence: `Ended at ${number(outcome.energy)}: no step led lower, but that proves no minimum.`,
        wishes: ['finer'],
      };
    case 'degenerate':
      return { sentence: 'Ended early: a part of the surface collapsed.', wishes: [] };
    default:
      return minimized(outcome);
  }
}

/** A run that may go on. @param {Outcome} outcome @param {string} how @returns {Finding} */
function halted(outcome, how) {
  const { energy, phase } = outcome;
  if (!Number.isFinite(energy)) return { sentence: `${how} before the first step.`, wishes: [] };
  if (how === 'Broken off') return { sentence: `${how} at ${number(energy)}; its surface is kept.`, wishes: ['goOn'] };
  if (phase === 'paused') return { sentence: `${how} at ${number(energy)}; ${STILL_FALLING}.`, wishes: [] };
  return early(outcome, how);
}

/** A run that ended before its last level was done; where that was not yet better, the surface of a coarser one is the result. @param {Outcome} outcome @param {string} how @returns {Finding} */
function early({ energy, level, levels }, how) {
  const before = credible(levels).filter((one) => one.level !== level);
  const least = Math.min(...before.map(({ energy_reported }) => energy_reported));
  const sentence =
    least < energy
      ? `${how} before the finest mesh was any better; a coarser one is the result, with ${number(least)}.`
      : `${how} at ${number(energy)}; ${STILL_FALLING}.`;
  return { sentence, wishes: ['goOn'] };
}

/** A run whose last level has energies that are not its surface's. @param {Outcome} outcome @returns {Finding} */
function folded({ levels, stop }) {
  const known = credible(levels);
  if (known.length) {
    const least = Math.min(...known.map(({ energy_reported }) => energy_reported));
    return {
      sentence: `The surface folded on the finest mesh, so that a coarser one is the result, with ${number(least)}.`,
      wishes: [],
    };
  }
  const reason =
    stop === 'below_bound'
      ? 'it has less energy than any such surface can, so it must have folded'
      : 'it has folds or necks too thin for its mesh, so its energy is not known';
  return { sentence: `No minimum: ${reason}.`, wishes: levels.length < ENOUGH_LEVELS ? ['finer'] : [] };
}

/** A run that ended as it should. @param {Outcome} outcome @returns {Finding} */
function minimized(outcome) {
  const { limit, certificate } = outcome;
  if (certificate && certificate.negative > 0) {
    return {
      sentence: `Not a minimum${knownWords(outcome)}; ${loweringWords(certificate)} the energy.`,
      wishes: ['descend'],
    };
  }
  if (limit?.status === 'not_converging') return unsettled(outcome, limit);
  const proved = certificate !== null;
  const { where, known, wishes } = accuracyOf(outcome);
  return {
    sentence: `${proved ? 'A minimum' : 'Minimized'}${where}${heldWords[outcome.held]}${known}.`,
    wishes: proved ? wishes.filter((wish) => wish !== 'check') : wishes,
  };
}

/** @type {Record<Outcome['held'], string>} */
const heldWords = { nothing: '', boundary: ' with its boundary kept', part: ' around what is held' };

/** @param {Limit} limit */
const energyOf = ({ energy, error }) =>
  Number.isFinite(error) ? withError(energy, error, ERROR_DIGITS).value : number(energy);

/**
 * How well the energy is known: on which mesh, and the words after a colon.
 * @param {Outcome} outcome
 * @returns {{where: string, known: string, wishes: Next[]}}
 */
function accuracyOf({ limit, levels, accuracy, energy }) {
  // Levels that only prepare have no limit, nor an energy that stands in for it.
  const value = limit && Number.isFinite(limit.energy) ? energyOf(limit) : number(energy);
  switch (limit?.status) {
    case 'converging':
      return { where: '', known: withinWords(limit, accuracy), wishes: ['check'] };
    case 'too_few_levels': {
      const missing = ENOUGH_LEVELS - evaluated(levels).length;
      const meshes = missing > 1 ? `${missing} finer meshes` : 'a finer mesh';
      const known = `: ${value}; its accuracy takes ${meshes} to tell`;
      return { where: ' on this mesh', known, wishes: ['finer', 'check'] };
    }
    case 'not_comparable': {
      const known = `: ${value}; every mesh is pulled differently, so its accuracy is not known`;
      return { where: ' within the distance', known, wishes: ['check'] };
    }
    case 'not_minimized': {
      const known = `: ${value}; its accuracy is not known, since a coarser mesh ended early`;
      return { where: ' on this mesh', known, wishes: ['finer', 'check'] };
    }
    default:
      return { where: '', known: Number.isFinite(energy) ? `: ${value}` : '', wishes: ['check'] };
  }
}

/** The energy, as well as it is known, after a colon. @param {Outcome} outcome */
function knownWords({ limit, accuracy, energy }) {
  if (limit?.status === 'converging') return withinWords(limit, accuracy);
  return `: ${limit && Number.isFinite(limit.energy) ? energyOf(limit) : number(energy)} on this mesh`;
}

/** @param {CertificateReport} certificate */
const loweringWords = ({ negative }) => counted(negative, 'direction lowers', 'directions lower');

/** @param {Limit} limit that is converging @param {number | null} accuracy */
function withinWords(limit, accuracy) {
  const { energy, error, lower } = limit;
  const part = error / Math.abs(energy);
  if (!(part <= WIDE_ERROR))
    return `: between ${number(Math.max(lower ?? energy - error, 0))} and ${number(energy + error)}`;
  const missed = accuracy !== null && part > accuracy ? `, not the ${percent(accuracy)} asked for` : '';
  return part > 0 ? `: ${energyOf(limit)}, within ${percent(part)}${missed}` : `: ${energyOf(limit)}`;
}

/** A run whose levels tell no limit. @param {Outcome} outcome @param {Limit} limit @returns {Finding} */
function unsettled({ levels }, { energy }) {
  const known = evaluated(levels);
  const [before, last] = known.slice(-2).map(({ energy_reported }) => energy_reported);
  const what = last < before ? 'The energy keeps falling' : 'The energy does not settle';
  const many = known.length >= MANY_LEVELS;
  const outlook = many ? 'there may be no surface of least energy' : 'a finer mesh may tell more';
  return {
    sentence: `${what} as the mesh is refined: ${number(energy)} is an upper bound; ${outlook}.`,
    wishes: many ? [] : ['finer'],
  };
}

/** A minimizer of the catalog, of which the catalog knows more than its run. @param {Outcome} outcome @param {EntryStatus} status @returns {Finding} */
function ofTheCatalog({ limit, certificate }, status) {
  const within = status === 'converged' && limit ? withinWords(limit, null) : '';
  if (certificate && certificate.negative > 0) {
    return {
      sentence: `The catalog’s minimizer with this symmetry${within}; without it, ${loweringWords(certificate)} the energy.`,
      wishes: ['descend'],
    };
  }
  switch (status) {
    case 'converged':
      return { sentence: `The catalog’s minimizer${within}.`, wishes: [] };
    case 'zero_attained':
      return { sentence: 'The catalog’s minimizer: it has none of this energy, and no surface has less.', wishes: [] };
    case 'infimum_not_attained':
      return {
        sentence: 'From the catalog: one of the surfaces that come ever nearer to the least energy, which none has.',
        wishes: [],
      };
    default:
      return {
        sentence:
          'The catalog’s best surface: the energy does not settle as the mesh is refined, so it is an upper bound.',
        wishes: [],
      };
  }
}
