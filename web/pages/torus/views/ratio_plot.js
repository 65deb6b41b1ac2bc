// SPDX-License-Identifier: MIT
/**
 * @file The plot of the minimizing ratio over the blend, above the slider, with the ratios that the paper prints.
 */
import { linePath } from '../../../plot/curves.js';
import { linearScale } from '../../../plot/scales.js';
import { whenChanged } from '../../../views/dom.js';
import { svg, valueTicks } from '../../../views/svg.js';
import { functionalWords } from '../../../words/functionals.js';
import { compact, significant } from '../../../words/numbers.js';
import { CLIFFORD, isThePapers, printed, shareOf, shares } from '../family.js';

/** @import {Box} from '../../../plot/curves.js' */
/** @import {Scale} from '../../../plot/scales.js' */
/** @import {Blend, Least, State} from '../types.js' */

const HEIGHT = 250;
const MARGIN = { left: 46, right: 10, top: 22, bottom: 40 };

/** @param {number} x @param {number} y @param {number} size */
const diamond = (x, y, size) => `M${x} ${y - size}l${size} ${size}l${-size} ${size}l${-size} ${-size}z`;

/**
 * The paper's ratios as diamonds, the exact ones as dots.
 * @param {State['path']} path
 * @param {(share: number, ratio: number) => [number, number]} place
 */
function paperMarks(path, place) {
  return printed.flatMap(({ weights, ratio }) => {
    const share = shareOf(weights);
    const exact = path[shares.indexOf(share)].ratio;
    const [x, y] = place(share, ratio);
    const [, exactY] = place(share, exact);
    return [
      svg('circle', { class: 'exact', cx: x, cy: exactY, r: 3 }),
      svg('path', { class: 'printed', d: diamond(x, y, 4.5) }),
      svg('text', { x: x + 10, y: Math.min(y, exactY) - 9, class: 'tick' }, `${significant(exact, 4)}, paper ${ratio}`),
    ];
  });
}

/** @param {Blend} blend @param {State['path']} path @param {Least | null} least @param {number} width */
function draw(blend, path, least, width) {
  const { left, right, top, bottom } = MARGIN;
  /** @type {Box} */
  const box = { x: left, y: top, width: width - left - right, height: HEIGHT - top - bottom };
  const across = linearScale(0, 1, 5, false);
  const up = linearScale(0, 0.8, 4, true);
  /** @param {number} share @param {number} ratio @returns {[number, number]} */
  const place = (share, ratio) => [
    box.x + across.position(share) * box.width,
    box.y + (1 - up.position(ratio)) * box.height,
  ];
  const points = path.map(({ ratio }, i) => /** @type {[number, number]} */ ([shares[i], ratio]));
  const foot = box.y + box.height;
  const [, clifford] = place(0, CLIFFORD);
  const marks = isThePapers(blend) ? paperMarks(path, place) : [];
  if (least?.minimizer.attained && least.minimizer.ratio > 0) {
    const [x, y] = place(shareOf(blend.weights), least.minimizer.ratio);
    marks.push(
      svg('line', { class: 'mark least', x1: x, x2: x, y1: y, y2: foot }),
      svg('circle', { class: 'dot', cx: x, cy: y, r: 4.5 }),
    );
  }
  return [
    svg('text', { x: 0, y: 10, class: 'axis' }, 'Minimizing ratio a'),
    ...valueTicks(up, box),
    svg('line', { class: 'mark', x1: box.x, x2: box.x + box.width, y1: clifford, y2: clifford }),
    svg('text', { x: box.x + box.width, y: clifford - 6, class: 'tick end' }, 'Clifford 1⁄√2'),
    svg('path', { class: 'curve', d: linePath(points, across, up, box) }),
    ...marks,
    ...across.ticks.map((tick) =>
      svg('text', { x: place(tick, 0)[0], y: foot + 15, class: 'tick middle' }, compact(tick)),
    ),
    svg(
      'text',
      { x: box.x + box.width, y: foot + 33, class: 'axis end' },
      `share of ${functionalWords(blend.names[1]).short}: w₂ ⁄ (w₁ + w₂)`,
    ),
  ];
}

/** @param {HTMLElement} root */
export function createRatioPlotView(root) {
  const picture = svg('svg', { role: 'img', height: HEIGHT, 'aria-label': 'The minimizing ratio over the blend' });
  root.append(picture);
  const show = whenChanged(
    (
      /** @type {Blend} */ blend,
      /** @type {State['path']} */ path,
      /** @type {Least | null} */ least,
      /** @type {number} */ width,
    ) => {
      picture.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
      picture.setAttribute('width', String(width));
      picture.replaceChildren(...(path.length && width ? draw(blend, path, least, width) : []));
    },
  );
  /** @type {State | null} */
  let last = null;
  const observer = new ResizeObserver(() => last && show(last.blend, last.path, last.least, root.clientWidth));
  observer.observe(root);
  return {
    /** @param {State} state */
    update(state) {
      last = state;
      show(state.blend, state.path, state.least, root.clientWidth);
    },
    dispose() {
      observer.disconnect();
      root.replaceChildren();
    },
  };
}
