// SPDX-License-Identifier: MIT
/**
 * @file The picture of the surface: passes meshes and colours to the scene, and reports the camera.
 */
import { patternOf, quantityOf } from '../../../colour/quantities.js';
import { drawing } from '../../../scene/drawing.js';
import { createScene } from '../../../scene/scene.js';
import { heldWithCopies, shownHeld } from '../state/hold.js';
import { cageOnScreen } from '../state/taken.js';
import { createBoundaryEdges } from './boundary_edges.js';
import { listenToBrush } from './brush.js';
import { cameraKeys } from './camera.js';
import { createProbe } from './probe.js';
import { createUndrawnView } from './undrawn.js';
import { find, whenChanged } from '../../../views/dom.js';
import { listenToKeys } from '../../../views/keys.js';

/** @import {Camera, Projection} from '../../../address/camera.js' */
/** @import {Pattern, Quantity} from '../../../colour/quantities.js' */
/** @import {Range} from '../../../colour/range.js' */
/** @import {Reading} from '../../../scene/reading.js' */
/** @import {Constraints, Mesh} from '../../../../wasm/types.js' */
/** @import {Action, CageFaces, Document, OpenCage, Pointer, State, Surface, TakenCage} from '../state/types.js' */

/**
 * Whether a surface stays where its cage is because parts of it are held; others are shown in one place and size.
 * @param {Document} document
 */
const staysInPlace = ({ cage, result }) =>
  Object.keys(result.settings.constraints).length > 0 || (cage?.counts.boundaries.length ?? 0) > 0;

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {(reading: Reading | null) => void} pointed called with the values of the point that is pointed at
 */
export function createSurfaceView(root, dispatch, pointed) {
  const canvas = /** @type {HTMLCanvasElement} */ (find(root, 'canvas'));
  const listening = new AbortController();
  const { signal } = listening;
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const speed = drawing();
  /** @param {Camera} camera */
  const rested = (camera) => dispatch({ type: 'viewChanged', change: { camera } });
  /** Whether the worker waits for this picture before it continues. */
  let awaited = false;
  function drawn() {
    probe.refresh();
    if (!awaited) return;
    awaited = false;
    dispatch({ type: 'surfaceDrawn' });
  }
  const scene = speed === 'never' ? null : createScene(canvas, { calm, slow: speed === 'slow', rested, drawn });
  find(root, '.no-webgl').hidden = Boolean(scene);
  canvas.hidden = !scene;

  find(root, '#fit').addEventListener('click', () => dispatch({ type: 'fitPressed' }), { signal });

  const undrawn = createUndrawnView(root);
  canvas.addEventListener('webglcontextlost', () => undrawn.tell('lost'), { signal });
  canvas.addEventListener('webglcontextrestored', () => undrawn.tell(null), { signal });

  const probe = createProbe(root, canvas, { read: (x, y) => scene?.reading(x, y) ?? null, pointed });
  /** @type {Projection} */
  let projection = 'perspective';
  const keys = { v: probe.toggle, ...cameraKeys(dispatch, () => projection) };
  listenToKeys(canvas, scene?.controls, () => dispatch({ type: 'fitPressed' }), signal, keys);
  /** @type {Pointer} */
  let pointer = 'turn';
  let vertices = 0;
  const brush = {
    pointer: () => pointer,
    /** @param {number} x @param {number} y */
    pick: (x, y) => scene?.cell(x, y, vertices) ?? null,
  };
  listenToBrush(canvas, brush, dispatch, signal);

  const setCamera = whenChanged((/** @type {Camera} */ camera) => scene?.setCamera(camera));
  const project = whenChanged((/** @type {Projection} */ next) => scene?.project((projection = next)));
  const setHeld = whenChanged((/** @type {Parameters<typeof shownHeld>} */ ...asked) => {
    const held = shownHeld(...asked);
    scene?.setHeld(held.some(Boolean) ? held : null);
    scene?.setPins((asked[0].pins ?? []).flatMap(({ vertex }) => (vertex ? [vertex - 1] : [])));
  });
  const setSurface = whenChanged(
    (/** @type {Mesh} */ mesh, /** @type {Float32Array | null} */ deviations, /** @type {Mesh} */ like) =>
      scene?.setSurface(mesh, deviations, like),
  );
  const boundaryEdges = createBoundaryEdges();
  const setMarked = whenChanged(
    (
      /** @type {number | null} */ boundary,
      /** @type {OpenCage | null} */ cage,
      /** @type {TakenCage | null} */ taken,
      /** @type {Mesh} */ mesh,
    ) => scene?.setMarked(boundaryEdges(boundary, cage, taken, mesh)),
  );
  const awaitPicture = whenChanged((/** @type {Surface} */ surface, /** @type {boolean} */ coarse) => {
    awaited = coarse;
    if (!scene) queueMicrotask(drawn);
  });
  const setLines = whenChanged(
    (
      /** @type {Mesh} */ mesh,
      /** @type {number} */ density,
      /** @type {Mesh | null} */ control,
      /** @type {Mesh | null} */ original,
      /** @type {boolean} */ patches,
    ) => scene?.setLines({ control, original, patches }, density),
  );
  // The symmetry axis of generated shapes is z; modelling programs usually write y upwards.
  const setUp = whenChanged((/** @type {boolean} */ generated) => scene?.setUp(generated ? 'z' : 'y'));
  const shade = whenChanged(
    (
      /** @type {Quantity | null} */ quantity,
      /** @type {Range | null} */ range,
      /** @type {Pattern | null} */ pattern,
      /** @type {boolean} */ isolines,
    ) => scene?.shade({ quantity, range, pattern, isolines }),
  );
  const recolour = whenChanged((/** @type {boolean} */ dark) => {
    // A colour of the style sheet, whatever form it is given in there, as the browser computes it.
    const computed = getComputedStyle(root);
    scene?.setColours(computed.getPropertyValue('color'), computed.getPropertyValue('outline-color'));
  });
  let shown = false;
  // The camera of the first surface comes from the address.
  const fit = whenChanged((/** @type {number} */ fits) => shown && scene?.fit());

  return {
    /**
     * @param {State} state
     * @param {Range | null} range range of the quantity that colours the surface
     * @param {boolean} dark
     */
    update(state, range, dark) {
      recolour(dark);
      const { view, document } = state;
      if (!view.surface) return;
      const start = view.start?.run === state.session.run ? view.start : null;
      setCamera(view.camera);
      project(view.projection);
      setUp(document.cage?.source.kind === 'generated');
      ({ pointer } = view);
      vertices = document.cage?.counts.vertices ?? 0;
      canvas.dataset.pointer = pointer;
      setHeld(document.settings.constraints, cageOnScreen(document), heldWithCopies(document));
      const { limit, density, deviations } = view.before && start ? { ...start, deviations: null } : view.surface;
      setSurface(limit, deviations, staysInPlace(document) ? view.surface.limit : limit);
      setMarked(view.boundary, document.cage, document.result.taken, limit);
      awaitPicture(view.surface, view.coarse);
      const control = view.cage && limit === view.surface.limit ? view.surface.control : null;
      setLines(limit, density, control, view.original ? (start?.cage ?? null) : null, view.patches);
      shade(quantityOf(view.shading), range, patternOf(view.shading), view.isolines);
      fit(view.fits);
      shown = true;
    },
    dispose() {
      listening.abort();
      probe.dispose();
      scene?.dispose();
    },
  };
}
