// SPDX-License-Identifier: MIT
/**
 * @file The two tables, each with its notes: all energies of the surface by the reporting rule, and the levels that have
 * ended.
 */
import { energyNotes, objectiveName, objectiveValue } from '../state/select.js';
import { embeddedWords } from '../../../words/energies.js';
import { functionalWords, functionals, stopWords } from '../../../words/functionals.js';
import { invariants, invariantsNote } from '../../../words/invariants.js';
import { freeName, lengthUnit } from '../../../words/holding.js';
import { counted, duration, integer, significant, withError } from '../../../words/numbers.js';
import { metricWords, thickenedWords } from '../../../words/results.js';
import { createLines, element, whenChanged } from '../../../views/dom.js';
import { formulaNodes } from '../../../views/formula.js';
import { termButton } from '../../../views/glossary.js';

/** @import {ConstraintsReport, Energies, LevelReport} from '../../../../wasm/types.js' */
/** @import {Measurement, Result, Settings, State} from '../state/types.js' */

/** Largest number of digits of energies in the table of levels. */
const LEVEL_DIGITS = 7;
/** An integral of the Gaussian curvature below this is rounding error. */
const ROUND_OFF = 1e-9;
const DIVERGES = 'Third-order energies are infinite at extraordinary vertices without a cap.';

/**
 * The content of a cell: a number, with the digits that its error justifies; or the reason why there is none.
 * @param {number} value
 * @param {number | null} error of the integration
 * @returns {Node[]}
 */
function cell(value, error) {
  if (Number.isNaN(value)) return [element('span', { class: 'muted', title: DIVERGES }, 'diverges')];
  return [document.createTextNode(error === null ? significant(value) : withError(value, error).value)];
}

/**
 * @param {string} name
 * @param {string} formula
 * @param {Node[]} now
 * @param {Node[]} start
 * @param {boolean} objective
 * @param {Node[]} [note] below the name
 */
function energyRow(name, formula, now, start, objective, note = []) {
  return element(
    'tr',
    objective ? { class: 'objective' } : {},
    element('th', { scope: 'row', title: formula }, name, ...note),
    element('td', { class: 'muted' }, ...start),
    element('td', {}, ...now),
  );
}

/**
 * @param {Settings} settings settings of the run to which the energies belong
 * @param {Energies} now
 * @param {Energies | null} start null if the surface is still that of the start
 * @param {number | undefined} deviation the largest, where something is held
 * @param {string} unit of lengths
 * @returns {HTMLTableRowElement[]}
 */
function energyRows(settings, now, start, deviation, unit) {
  const blend = settings.functional === 'blend';
  // A stored report may be older than a functional. With caps no energy diverges.
  const isTold = (/** @type {number | undefined} */ value) =>
    value !== undefined && !(Number.isNaN(value) && settings.cap !== 'none');
  const told = functionals.filter(({ id }) => isTold(now[id]));
  const rows = told.map(({ id, name, formula }) => {
    const objective = settings.functional === id && !now.free;
    const error = objective ? now.quadrature_error : null;
    const embedded = id === 'willmore' && now.embedded;
    const note = embedded ? [element('small', { title: embeddedWords.reason }, embeddedWords.name)] : [];
    const first = start && isTold(start[id]) ? cell(start[id], null) : [];
    return energyRow(name, formula, cell(now[id], error), first, objective, note);
  });
  if (blend || now.free) {
    const [value, first] = [now, start].map((energies) => (energies ? objectiveValue(settings, energies) : null));
    const name = settings.functional === 'blend' ? 'Blend' : functionalWords(settings.functional).name;
    rows.unshift(
      energyRow(
        name,
        objectiveName(settings),
        cell(value ?? NaN, now.quadrature_error),
        first === null ? [] : cell(first, null),
        true,
        now.free ? [element('small', {}, freeName(now))] : [],
      ),
    );
  }
  /** @param {Energies | null} energies */
  const gaussian = (energies) => {
    const value = energies ? energies.gaussian / (4 * Math.PI) : 0;
    return energies ? cell(Math.abs(value) < ROUND_OFF ? 0 : value, null) : [];
  };
  rows.push(
    energyRow('Area A', '∫ dA, in length²', cell(now.area, null), start ? cell(start.area, null) : [], false),
    energyRow('∫ K dA / 4π', '1 − genus, for one component', gaussian(now), gaussian(start), false),
  );
  if (deviation !== undefined) {
    const title = 'From the cage’s own surface, between points of the same parameters';
    const note = [element('small', {}, `|X − X₀|, ${unit}`)];
    rows.push(energyRow('Largest deviation', title, cell(deviation, null), [], false, note));
  }
  return rows;
}

/**
 * The invariants, under a line that says what they are; none where they diverge, or where a stored report is older.
 * @param {Energies['invariants']} now
 * @param {Energies['invariants']} start undefined if the surface is still that of the start
 * @returns {HTMLTableRowElement[]}
 */
function invariantRows(now, start) {
  if (!now || invariants.some(({ id }) => !Number.isFinite(now[id]))) return [];
  const rows = invariants.map(({ id, symbol, formula }) =>
    element(
      'tr',
      {},
      element(
        'th',
        { scope: 'row', title: `${id} in reports` },
        `${symbol} `,
        element('span', { class: 'formula' }, ...formulaNodes(formula)),
      ),
      element('td', { class: 'muted' }, ...(start ? cell(start[id], null) : [])),
      element('td', {}, ...cell(now[id], null)),
    ),
  );
  const head = element(
    'th',
    { scope: 'rowgroup', colspan: '3' },
    termButton('odd-invariants'),
    element('span', { class: 'formula' }, invariantsNote),
  );
  return [element('tr', {}, head), ...rows];
}

/** @param {HTMLElement} root */
export function createEnergiesView(root) {
  const body = element('tbody');
  const odd = element('tbody', { class: 'invariants' });
  const startHead = element('th', { scope: 'col' }, 'Start');
  const nowHead = element('th', { scope: 'col' }, 'Now');
  const head = element('tr', {}, element('td'), startHead, nowHead);
  const table = element('table', { class: 'energies' }, element('thead', {}, head), body, odd);
  const notes = element('div');
  root.append(table, notes);

  const show = whenChanged(
    (
      /** @type {Measurement | null} */ latest,
      /** @type {Measurement | null} */ first,
      /** @type {Settings} */ settings,
      /** @type {ConstraintsReport | null} */ constrained,
      /** @type {string} */ unit,
    ) => {
      table.hidden = !latest;
      if (!latest) return;
      const moved = first !== null && first !== latest;
      head.hidden = !moved;
      table.classList.toggle('moved', moved);
      const start = moved ? first.energies : null;
      body.replaceChildren(...energyRows(settings, latest.energies, start, constrained?.deviation, unit));
      odd.replaceChildren(...invariantRows(latest.energies.invariants, start?.invariants));
    },
  );
  const showNotes = createLines(notes);

  return {
    /** @param {State} state */
    update(state) {
      show(
        state.document.result.latest,
        state.document.result.first,
        state.document.result.settings,
        state.document.result.constrained,
        lengthUnit(state.document.cage?.source.kind === 'text'),
      );
      showNotes(energyNotes(state));
    },
    dispose: () => root.replaceChildren(),
  };
}

/** A level's energy, with as many digits as the quadrature error justifies and the column can hold. @param {LevelReport} report */
function levelEnergy({ energy, energy_reported }) {
  if (Number.isNaN(energy_reported)) return 'diverges';
  const { value } = withError(energy_reported, Math.abs(energy_reported - energy));
  return value.length > LEVEL_DIGITS + 1 ? significant(energy_reported, LEVEL_DIGITS) : value;
}

/** @param {LevelReport} report */
function levelTitle({ unknowns, seconds, metrics, evaluable }) {
  const facts = [counted(unknowns, 'unknown'), `metric built ${counted(metrics, 'time')}`];
  if (Number.isFinite(seconds)) facts.splice(1, 0, duration(seconds));
  if (!evaluable) facts.push('prepares the first level that is evaluated on its own mesh');
  return facts.join(', ');
}

/** @param {HTMLElement} root */
export function createLevelsView(root) {
  const body = element('tbody');
  const heads = [
    termButton('level', 'Level'),
    termButton('patch', 'Patches'),
    'Energy',
    termButton('evaluation', 'Evaluations'),
    termButton('metric', 'Metric'),
    'Ended',
  ].map((name) => element('th', { scope: 'col' }, name));
  const notes = element('div');
  root.append(element('table', { class: 'levels' }, element('thead', {}, element('tr', {}, ...heads)), body), notes);
  const showNotes = createLines(notes);

  const show = whenChanged((/** @type {Result['levels']} */ levels) => {
    const details = root.closest('details');
    if (details) details.hidden = !levels.length;
    showNotes(thickenedWords(levels).map((words) => ({ words })));
    body.replaceChildren(
      ...levels.map((report) => {
        return element(
          'tr',
          { title: levelTitle(report) },
          element('td', {}, String(report.level)),
          element('td', {}, integer(report.patches)),
          element('td', {}, levelEnergy(report)),
          element('td', {}, integer(report.evaluations)),
          element('td', {}, metricWords[report.metric]),
          element('td', {}, stopWords[report.stop] ?? report.stop),
        );
      }),
    );
  });

  return {
    /** @param {State} state */
    update: (state) => show(state.document.result.levels),
    dispose: () => root.replaceChildren(),
  };
}
