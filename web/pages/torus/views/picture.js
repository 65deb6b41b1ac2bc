// SPDX-License-Identifier: MIT
/**
 * @file The picture of the torus that minimizes the blend, coloured by curvature; if the browser cannot draw it, its
 * cross-section.
 */
import { patternOf, quantityOf } from '../../../colour/quantities.js';
import { drawing } from '../../../scene/drawing.js';
import { createScene } from '../../../scene/scene.js';
import { find, whenChanged } from '../../../views/dom.js';
import { listenToKeys } from '../../../views/keys.js';
import { createLegendView } from '../../../views/legend.js';
import { svg } from '../../../views/svg.js';
import { drawnRatio } from '../family.js';
import { torusMesh } from '../mesh.js';

/** @import {Mesh} from '../../../../wasm/types.js' */
/** @import {Camera} from '../../../address/camera.js' */
/** @import {Pattern, Quantity, Shading} from '../../../colour/quantities.js' */
/** @import {Range} from '../../../colour/range.js' */
/** @import {Action, State} from '../types.js' */

/** The cross-section: the two circles of the tube, and the axis. @param {number} ratio */
function section(ratio) {
  const outer = 1 + ratio;
  const circles = [-1, 1].map((side) => svg('circle', { cx: side / outer, cy: 0, r: ratio / outer }));
  return svg(
    'svg',
    { viewBox: '-1.05 -0.6 2.1 1.2', class: 'section', 'aria-hidden': 'true' },
    svg('line', { x1: 0, x2: 0, y1: -0.6, y2: 0.6 }),
    ...circles,
  );
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 */
export function createPictureView(root, dispatch) {
  const listening = new AbortController();
  const canvas = /** @type {HTMLCanvasElement} */ (find(root, 'canvas'));
  const instead = find(root, '.no-webgl');
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const speed = drawing();
  /** @param {Camera} camera */
  const rested = (camera) => dispatch({ type: 'cameraMoved', camera });
  const scene = speed === 'never' ? null : createScene(canvas, { calm, slow: speed === 'slow', rested });
  canvas.hidden = !scene;
  instead.hidden = Boolean(scene);
  find(root, '#legend').hidden = !scene;
  find(root, '#fit').hidden = !scene;
  const fitPressed = () => dispatch({ type: 'fitPressed' });
  listenToKeys(canvas, scene?.controls, fitPressed, listening.signal);
  find(root, '#fit').addEventListener('click', fitPressed, { signal: listening.signal });
  const legend = createLegendView(find(root, '#legend'), {
    choose: (/** @type {Shading} */ shading) => dispatch({ type: 'shadingChosen', shading }),
    unit: () => '1 on a sphere of equal area',
  });
  scene?.setUp('z');

  /** @type {Mesh | null} */
  let mesh = null;
  const setRatio = whenChanged((/** @type {number} */ ratio) => {
    if (!scene) return instead.querySelector('.section')?.replaceWith(section(ratio));
    mesh = torusMesh(ratio);
    scene.setSurface(mesh);
  });
  const setCamera = whenChanged((/** @type {Camera} */ camera) => scene?.setCamera(camera));
  const shade = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {Range | null} */ range,
      /** @type {Pattern | null} */ pattern,
    ) => scene?.shade({ quantity, range, pattern }),
  );
  const fit = whenChanged((/** @type {number} */ fits) => fits && scene?.fit());

  return {
    /** @param {State} state */
    update({ least, camera, shading, fits }) {
      setCamera(camera);
      if (least) setRatio(drawnRatio(least.minimizer.ratio));
      const range = legend.update({ shading, curvatures: mesh ? [mesh.curvatures] : [], mesh, occasion: '' });
      shade(quantityOf(shading), range, patternOf(shading));
      fit(fits);
    },
    dispose() {
      listening.abort();
      legend.dispose();
      scene?.dispose();
    },
  };
}
