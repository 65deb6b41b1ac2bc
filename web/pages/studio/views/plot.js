// SPDX-License-Identifier: MIT
/**
 * @file The convergence plot: the energy, and below it the norm of its gradient, over the evaluations; thin lines
 * separate the levels.
 */
import { curvePath, pieces } from '../../../plot/curves.js';
import { linearScale, scaleFor, settled } from '../../../plot/scales.js';
import { compact, counted, significant } from '../../../words/numbers.js';
import { element, setText, whenChanged } from '../../../views/dom.js';
import { svg, valueTicks } from '../../../views/svg.js';

/** @import {Box} from '../../../plot/curves.js' */
/** @import {Scale} from '../../../plot/scales.js' */
/** @import {Sample, State} from '../state/types.js' */

const LEFT = 52;
const RIGHT = 8;
const ENERGY = { top: 38, height: 112, value: (/** @type {Sample} */ sample) => sample.energy };
const GRADIENT = { top: 186, height: 84, value: (/** @type {Sample} */ sample) => sample.gradientNorm };
const HEIGHT = 310;

/** @param {Scale} across @param {Box} box */
function evaluationTicks(across, box) {
  const y = box.y + box.height + 15;
  return across.ticks
    .filter((tick) => Number.isInteger(tick))
    .map((tick) =>
      svg(
        'text',
        { x: (box.x + across.position(tick) * box.width).toFixed(1), y, class: 'tick middle' },
        compact(tick, 6),
      ),
    );
}

/** @param {Sample[][]} levels @param {Scale} across @param {Box} top @param {Box} below */
function levelMarks(levels, across, top, below) {
  let free = -Infinity;
  return levels.flatMap((piece) => {
    const x = top.x + across.position(piece[0].evaluation) * top.width;
    const marks = [top, below].map(({ y, height }) =>
      svg('line', { class: 'level', x1: x.toFixed(1), x2: x.toFixed(1), y1: y, y2: y + height }),
    );
    if (x < free) return marks;
    const label = free === -Infinity ? `level ${piece[0].level}` : String(piece[0].level);
    free = x + 8 + 6 * label.length;
    return [...marks, svg('text', { x: x.toFixed(1), y: top.y - 8, class: 'tick' }, label)];
  });
}

/** @param {Sample[]} samples @param {number} width @returns {SVGElement[]} */
function draw(samples, width) {
  const levels = pieces(samples);
  const last = samples[samples.length - 1].evaluation;
  const first = samples[0].evaluation;
  const across = linearScale(first, Math.max(last, first + 4), 5, false);
  const box = { x: LEFT, width: Math.max(50, width - LEFT - RIGHT) };
  const top = { ...box, y: ENERGY.top, height: ENERGY.height };
  const below = { ...box, y: GRADIENT.top, height: GRADIENT.height };
  const bottom = below.y + below.height;
  const energies = scaleFor(settled(samples.map(ENERGY.value)), 4, false);
  const gradients = scaleFor(samples.map(GRADIENT.value), 4, true);
  return [
    ...levelMarks(levels, across, top, below),
    svg('text', { x: 0, y: top.y - 28, class: 'axis' }, energyTitle(samples[0].energy, energies)),
    ...valueTicks(energies, top),
    svg('path', { class: 'curve', d: curvePath(levels, ENERGY.value, across, energies, top) }),
    svg('text', { x: 0, y: below.y - 12, class: 'axis' }, 'Gradient norm, log scale'),
    ...valueTicks(gradients, below),
    svg('path', { class: 'curve', d: curvePath(levels, GRADIENT.value, across, gradients, below) }),
    ...evaluationTicks(across, below),
    svg('text', { x: below.x + below.width, y: bottom + 33, class: 'axis end' }, 'energy evaluations'),
  ];
}

/** The title. It gives the first energy if that lies above the plot. @param {number} first @param {Scale} up */
function energyTitle(first, up) {
  const name = up.logarithmic ? 'Energy, log scale' : 'Energy';
  return first > up.domain[1] ? `${name}; it began at ${compact(first, 4)}` : name;
}

/** @param {Sample[]} samples */
function describe(samples) {
  const first = samples[0];
  const last = samples[samples.length - 1];
  const levels = pieces(samples).length;
  return (
    `Energy from ${significant(first.energy, 5)} to ${significant(last.energy, 5)} in ` +
    `${counted(samples.length, 'evaluation')} over ${counted(levels, 'level')}; ` +
    `gradient norm from ${significant(first.gradientNorm, 3)} to ${significant(last.gradientNorm, 3)}.`
  );
}

/** @param {HTMLElement} root */
export function createPlotView(root) {
  const picture = svg('svg', { role: 'img', 'aria-labelledby': 'plot-description', height: HEIGHT });
  const description = element('p', { id: 'plot-description', class: 'hidden' });
  const empty = element('p', { class: 'note' }, 'Energy and gradient norm appear here while a run goes on.');
  root.append(empty, picture, description);

  const show = whenChanged((/** @type {Sample[]} */ samples, /** @type {number} */ width) => {
    const some = samples.length > 0;
    empty.hidden = some;
    picture.style.display = some ? '' : 'none';
    picture.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
    picture.setAttribute('width', String(width));
    picture.replaceChildren(...(some ? draw(samples, width) : []));
  });
  const updateDescription = whenChanged((/** @type {Sample[]} */ samples) => {
    setText(description, samples.length ? describe(samples) : '');
  });

  /** @type {Sample[]} */
  let samples = [];
  const observer = new ResizeObserver(() => show(samples, root.clientWidth));
  observer.observe(root);

  return {
    /** @param {State} state */
    update(state) {
      ({ samples } = state.document.result);
      show(samples, root.clientWidth);
      if (state.session.phase.name !== 'running') updateDescription(samples);
    },
    dispose() {
      observer.disconnect();
      root.replaceChildren();
    },
  };
}
