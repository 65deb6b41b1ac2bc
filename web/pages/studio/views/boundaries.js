// SPDX-License-Identifier: MIT
/**
 * @file The list of an open cage's boundaries: what is held at each, and a button that fills it. The boundary that has the
 * focus or is under the mouse is marked on the surface.
 */
import { conditionAt, filledBoundaries } from '../state/boundary.js';
import { holdsTheSame } from '../state/hold.js';
import { boundaryOfFile } from '../state/taken.js';
import { conditionWords } from '../../../words/boundaries.js';
import { boundaryPullWords } from '../../../words/holding.js';
import { counted } from '../../../words/numbers.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';

/** @import {BoundaryCondition, CageBoundary, ConstraintsReport} from '../../../../wasm/types.js' */
/** @import {Action, OpenCage, Result, Session, Settings, State} from '../state/types.js' */

/** What a menu shows for a boundary with several conditions, or for boundaries that differ. */
const MIXED = 'mixed';

/**
 * @typedef {object} Row
 * @property {number | null} boundary its number; null for all
 * @property {HTMLElement} element
 * @property {HTMLSelectElement} condition
 * @property {HTMLElement} filled said instead of a condition
 * @property {HTMLButtonElement} fill
 * @property {boolean} isFilled
 * @property {HTMLElement} pull
 * @property {HTMLElement} problem
 */

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createBoundariesView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const list = find(root, '.list');
  const words = find(root, '.words');
  /** @type {Row[]} */
  let rows = [];

  /** @param {CageBoundary | null} boundary null for all @returns {Row} */
  function createRow(boundary) {
    const number = boundary?.number ?? null;
    const name = boundary ? `boundary ${boundary.number}` : 'all boundaries';
    const condition = element(
      'select',
      { 'aria-label': `What is held at ${name}` },
      ...Object.entries(conditionWords).map(([value, { name: word }]) => element('option', { value }, word)),
    );
    condition.addEventListener(
      'change',
      () =>
        condition.value !== MIXED &&
        dispatch({
          type: 'conditionChosen',
          boundary: number,
          condition: /** @type {BoundaryCondition} */ (condition.value),
        }),
      { signal },
    );
    const filled = element('span', { class: 'note' }, 'filled');
    const fill = element('button', { type: 'button' });
    const pull = element('p', { class: 'note' });
    const problem = element('p', { class: 'problem', role: 'alert' });
    const title = boundary
      ? [String(boundary.number), element('span', { class: 'note' }, counted(boundary.vertices, 'vertex', 'vertices'))]
      : ['All'];
    const place = element(
      'li',
      {},
      element('span', { class: 'name' }, ...title),
      condition,
      filled,
      fill,
      pull,
      problem,
    );
    if (boundary) mark(place, boundary.number);
    const row = { boundary: number, element: place, condition, filled, fill, isFilled: false, pull, problem };
    const press = () => dispatch({ type: 'fillPressed', boundary: number, filled: !row.isFilled });
    fill.addEventListener('click', press, { signal });
    return row;
  }

  /** @param {HTMLElement} row @param {number} boundary */
  function mark(row, boundary) {
    /** @param {number | null} next */
    const set = (next) => dispatch({ type: 'viewChanged', change: { boundary: next } });
    for (const type of ['pointerenter', 'focusin']) row.addEventListener(type, () => set(boundary), { signal });
    const leave = () => {
      if (!row.matches(':hover, :focus-within')) set(null);
    };
    row.addEventListener('pointerleave', leave, { signal });
    row.addEventListener('focusout', () => queueMicrotask(leave), { signal });
  }

  const showList = whenChanged((/** @type {OpenCage | null} */ cage) => {
    const boundaries = cage?.counts.boundaries ?? [];
    root.hidden = !boundaries.length;
    rows = [...(boundaries.length > 1 ? [null] : []), ...boundaries].map(createRow);
    list.replaceChildren(...rows.map((row) => row.element));
  });

  /** @param {HTMLSelectElement} select @param {BoundaryCondition | null} condition null for several */
  function choose(select, condition) {
    select.querySelector(`[value=${MIXED}]`)?.remove();
    if (!condition) select.append(element('option', { value: MIXED }, 'several'));
    select.value = condition ?? MIXED;
  }

  const show = whenChanged(
    (
      /** @type {OpenCage | null} */ cage,
      /** @type {Settings} */ settings,
      /** @type {Session['refused']} */ refused,
    ) => {
      const numbers = (cage?.counts.boundaries ?? []).map(({ number }) => number);
      const filled = filledBoundaries(settings.fill, cage);
      const open = numbers.filter((number) => !filled.includes(number));
      const shown = new Set(open.map((number) => conditionAt(settings.constraints, number)));
      const common = shown.size === 1 ? [...shown][0] : null;
      for (const row of rows) {
        const isFilled = row.boundary === null ? !open.length : filled.includes(row.boundary);
        row.isFilled = isFilled;
        const name = row.boundary === null ? 'all boundaries' : `boundary ${row.boundary}`;
        choose(row.condition, row.boundary === null ? common : conditionAt(settings.constraints, row.boundary));
        row.condition.hidden = isFilled;
        row.filled.hidden = !isFilled;
        setText(row.fill, isFilled ? 'Open' : 'Fill');
        row.fill.setAttribute('aria-label', isFilled ? `Open ${name} again` : `Fill ${name}`);
        const here = refused && refused.place !== 'closeness' && placeOf(refused.boundary) === row;
        setText(row.problem, here ? refused.message : '');
      }
      const conditions = [...shown].filter((condition) => condition !== null);
      setText(words, conditions.map((condition) => conditionWords[condition].words).join(' '));
    },
  );

  const showPulls = whenChanged(
    (
      /** @type {ConstraintsReport | null} */ report,
      /** @type {OpenCage | null} */ cage,
      /** @type {Result['taken']} */ taken,
    ) => {
      for (const row of rows) {
        const found = report?.boundaries?.find(
          ({ boundary }) => boundaryOfFile(cage, taken, boundary) === row.boundary,
        );
        setText(row.pull, found ? boundaryPullWords(found) : '');
      }
    },
  );

  /** The row where a refusal is said. @param {number | null} boundary */
  const placeOf = (boundary) => rows.find((row) => row.boundary === boundary) ?? rows[0];

  return {
    /** @param {State} state */
    update(state) {
      const { cage, settings, result } = state.document;
      showList(cage);
      show(cage, settings, state.session.refused);
      showPulls(holdsTheSame(settings, result.settings) ? result.constrained : null, cage, result.taken);
    },
    dispose: () => listening.abort(),
  };
}
