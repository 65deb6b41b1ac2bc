// SPDX-License-Identifier: MIT
/**
 * @file The plot of energies over the ratio of radii: the two functionals and their blend, with marks for the torus of
 * least energy, Clifford's torus and the limit of thin tori, and the values under a crosshair.
 */
import { linePath } from '../../../plot/curves.js';
import { linearScale, logScale } from '../../../plot/scales.js';
import { element, setText, whenChanged } from '../../../views/dom.js';
import { svg, valueTicks } from '../../../views/svg.js';
import { functionalWords } from '../../../words/functionals.js';
import { compact, significant } from '../../../words/numbers.js';
import { CLIFFORD, blendedEnergy, ratios, thinLimits } from '../family.js';

/** @import {Box} from '../../../plot/curves.js' */
/** @import {Scale} from '../../../plot/scales.js' */
/** @import {TorusEnergies} from '../../../worker/tori.js' */
/** @import {Action, Blend, Family, Least, State} from '../types.js' */

const HEIGHT = 300;
const MARGIN = { left: 46, right: 10, top: 26, bottom: 40 };
/** Energies are unbounded at both ends; the plot ends at this multiple of the largest minimum. */
const ROOM = 14;

/** @typedef {{name: string, kind: 'first' | 'second' | 'blend', value: (energies: TorusEnergies) => number}} Curve */

/** The curves that a logarithmic axis can show. @param {Blend} blend @param {Family} family @returns {Curve[]} */
function curvesOf(blend, { energies }) {
  /** @type {Curve[]} */
  const curves = [
    ...blend.names.map((id, i) => ({
      name: functionalWords(id).short,
      kind: /** @type {'first' | 'second'} */ (i ? 'second' : 'first'),
      value: (/** @type {TorusEnergies} */ one) => one[id],
    })),
    { name: 'Blend', kind: 'blend', value: (one) => blendedEnergy(blend, one) },
  ];
  return curves.filter(({ value }) => value(energies[0]) > 0);
}

/** @param {Curve[]} curves @param {Family} family */
function scalesOf(curves, { energies }) {
  const minima = curves.map(({ value }) => energies.reduce((least, one) => Math.min(least, value(one)), Infinity));
  const low = minima.length ? Math.min(...minima) : 1;
  const high = ROOM * (minima.length ? Math.max(...minima) : 1);
  return { across: linearScale(0, 1, 5, false), up: logScale(0.8 * low, high, 5) };
}

/** @param {Scale} across @param {Box} box */
function ratioTicks(across, box) {
  const y = box.y + box.height + 15;
  return [
    ...across.ticks.map((tick) =>
      svg('text', { x: box.x + across.position(tick) * box.width, y, class: 'tick middle' }, compact(tick)),
    ),
    svg('text', { x: box.x + box.width, y: y + 18, class: 'axis end' }, 'a = r ⁄ R'),
  ];
}

/**
 * @param {number} at
 * @param {string} words
 * @param {string} kind
 * @param {Scale} across
 * @param {Box} box
 */
function uprightMark(at, words, kind, across, box) {
  const x = (box.x + across.position(at) * box.width).toFixed(1);
  return [
    svg('line', { class: `mark ${kind}`, x1: x, x2: x, y1: box.y, y2: box.y + box.height }),
    svg('text', { x, y: box.y - 8, class: `tick middle ${kind}` }, words),
  ];
}

/** Marks for the limits of the functionals as the tube becomes thin. @param {Blend} blend @param {Family} family @param {Scale} up @param {Box} box */
function thinMarks({ names }, { alone }, up, box) {
  return names.flatMap((id) => {
    const words = thinLimits[id];
    if (!words) return [];
    const y = box.y + (1 - up.position(alone[id].energy)) * box.height;
    return [
      svg('line', { class: 'mark', x1: box.x, x2: box.x + box.width / 2, y1: y, y2: y }),
      svg('text', { x: box.x + box.width / 2, y: y + 13, class: 'tick end' }, `${words} as a → 0`),
    ];
  });
}

/** @param {Blend} blend @param {Least} least @param {Scale} across @param {Scale} up @param {Box} box */
function leastMarks(blend, { minimizer, energies }, across, up, box) {
  if (!energies || !minimizer.attained) return [];
  const x = box.x + across.position(minimizer.ratio) * box.width;
  const y = box.y + (1 - up.position(blendedEnergy(blend, energies))) * box.height;
  const foot = box.y + box.height;
  return [
    svg('line', { class: 'mark least', x1: x, x2: x, y1: y, y2: foot }),
    ...(Number.isFinite(y) ? [svg('circle', { class: 'dot', cx: x, cy: y, r: 4.5 })] : []),
  ];
}

/** @param {Blend} blend @param {Family} family @param {Least | null} least @param {number} width */
function draw(blend, family, least, width) {
  const { left, right, top, bottom } = MARGIN;
  const box = { x: left, y: top, width: width - left - right, height: HEIGHT - top - bottom };
  const curves = curvesOf(blend, family);
  const { across, up } = scalesOf(curves, family);
  const clip = svg('clipPath', { id: 'energies-box' }, svg('rect', { ...box }));
  const paths = curves.map(({ kind, value }) => {
    const points = family.energies.map((one, i) => /** @type {[number, number]} */ ([ratios[i], value(one)]));
    return svg('path', { class: `curve ${kind}`, d: linePath(points, across, up, box) });
  });
  return [
    clip,
    ...valueTicks(up, box),
    ...ratioTicks(across, box),
    ...uprightMark(CLIFFORD, 'Clifford 1⁄√2', 'clifford', across, box),
    ...thinMarks(blend, family, up, box),
    svg('g', { 'clip-path': 'url(#energies-box)' }, ...paths),
    ...(least ? leastMarks(blend, least, across, up, box) : []),
  ];
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createEnergiesPlotView(root, dispatch) {
  const listening = new AbortController();
  const { signal } = listening;
  const picture = svg('svg', { role: 'img', tabindex: 0, height: HEIGHT, 'aria-describedby': 'energies-values' });
  picture.setAttribute('aria-label', 'Energies over the ratio of radii; use the arrow keys to read them');
  const drawn = svg('g', {});
  const hair = svg('line', { class: 'hair', y1: MARGIN.top, y2: HEIGHT - MARGIN.bottom });
  picture.append(drawn, hair);
  const key = element('p', { class: 'key' });
  const values = element('p', { class: 'values', id: 'energies-values', 'aria-live': 'polite' });
  root.append(key, picture, values);

  /** @param {MouseEvent} event */
  function point({ clientX }) {
    const { left } = picture.getBoundingClientRect();
    const inside = root.clientWidth - MARGIN.left - MARGIN.right;
    const part = (clientX - left - MARGIN.left) / inside;
    dispatch({ type: 'ratioPointed', index: Math.round(part * (ratios.length + 1)) - 1 });
  }
  picture.addEventListener('pointermove', (event) => point(/** @type {PointerEvent} */ (event)), { signal });
  picture.addEventListener('pointerleave', () => dispatch({ type: 'ratioPointed', index: null }), { signal });
  picture.addEventListener('blur', () => dispatch({ type: 'ratioPointed', index: null }), { signal });
  let pointed = /** @type {number | null} */ (null);
  picture.addEventListener(
    'keydown',
    (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[/** @type {KeyboardEvent} */ (event).key];
      if (!step) return;
      event.preventDefault();
      dispatch({ type: 'ratioPointed', index: (pointed ?? Math.round(ratios.length / 2)) + step });
    },
    { signal },
  );

  const show = whenChanged(
    (
      /** @type {Blend} */ blend,
      /** @type {Family | null} */ family,
      /** @type {Least | null} */ least,
      /** @type {number} */ width,
    ) => {
      picture.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
      picture.setAttribute('width', String(width));
      if (!family || !width) return drawn.replaceChildren();
      drawn.replaceChildren(...draw(blend, family, least, width));
      key.replaceChildren(
        ...curvesOf(blend, family).map(({ name, kind }) =>
          element('span', { class: kind }, element('i', {}), kind === 'blend' ? blendName(blend) : name),
        ),
      );
    },
  );
  const showValues = whenChanged(
    (/** @type {Blend} */ blend, /** @type {Family | null} */ family, /** @type {number | null} */ index) => {
      hair.style.display = index === null ? 'none' : '';
      if (index === null || !family) return setText(values, 'Point at the plot, or use the arrow keys, to read it.');
      const x = MARGIN.left + ratios[index] * (root.clientWidth - MARGIN.left - MARGIN.right);
      hair.setAttribute('x1', x.toFixed(1));
      hair.setAttribute('x2', x.toFixed(1));
      const texts = curvesOf(blend, family).map(
        ({ name, value }) => `${name} ${significant(value(family.energies[index]), 5)}`,
      );
      setText(values, [`a = ${compact(ratios[index], 4)}`, ...texts].join(' · '));
    },
  );

  /** @type {State | null} */
  let last = null;
  const observer = new ResizeObserver(() => last && show(last.blend, last.family, last.least, root.clientWidth));
  observer.observe(root);

  return {
    /** @param {State} state */
    update(state) {
      last = state;
      ({ pointed } = state);
      show(state.blend, state.family, state.least, root.clientWidth);
      showValues(state.blend, state.family, state.pointed);
    },
    dispose() {
      listening.abort();
      observer.disconnect();
      root.replaceChildren();
    },
  };
}

/** @param {Blend} blend */
function blendName({ weights }) {
  return `${compact(weights[0], 4)} : ${compact(weights[1], 4)} blend`;
}
