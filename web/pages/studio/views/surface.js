// SPDX-License-Identifier: MIT
/**
 * @file The picture of the surface: passes meshes and colours to the scene, and reports the camera.
 */
import { computedOf, patternOf, quantityOf } from '../../../colour/quantities.js';
import { drawing } from '../../../scene/drawing.js';
import { createScene } from '../../../scene/scene.js';
import { editingOn } from '../state/editing.js';
import { heldWithCopies, shownHeld } from '../state/hold.js';
import { cageOnScreen } from '../state/taken.js';
import { heldNormal } from '../state/normals.js';
import { computedValues } from '../state/wish.js';
import { createBoundaryEdges } from './boundary_edges.js';
import { listenToBrush } from './brush.js';
import { cameraKeys } from './camera.js';
import { createEditedPicture, handleOf } from './edited.js';
import { createProbe } from './probe.js';
import { createUndrawnView } from './undrawn.js';
import { find, whenChanged } from '../../../views/dom.js';
import { listenToKeys } from '../../../views/keys.js';

/** @import {Camera, Projection} from '../../../address/camera.js' */
/** @import {Computed, Pattern, Quantity} from '../../../colour/quantities.js' */
/** @import {Range} from '../../../colour/range.js' */
/** @import {Motion} from '../../../scene/glide.js' */
/** @import {Reading} from '../../../scene/reading.js' */
/** @import {CutFound} from '../../../scene/section_lines.js' */
/** @import {Constraints, Mesh} from '../../../../wasm/types.js' */
/** @import {Section} from '../state/section.js' */
/** @import {Action, CageFaces, Document, Editing, OpenCage, Pointer, Settings, State, Surface, TakenCage} from '../state/types.js' */

/**
 * Whether a surface stays where its cage is because parts of it are held; others are shown in one place and size.
 * @param {Document} document
 */
const staysInPlace = ({ cage, result }) =>
  Object.keys(result.settings.constraints).length > 0 || (cage?.counts.boundaries.length ?? 0) > 0;

/** How near to a pin's dot a press takes it, in CSS pixels. */
const PIN_REACH = 14;

/**
 * Where a pin is to be moved: `place` has NaN for coordinates that stay free, and `surface` is where its point lies now, in the
 * coordinates of the file. `normal` is the one that it holds, of length 1.
 * @typedef {{index: number, place: number[], surface: number[], normal: [number, number, number] | null}} Handled
 *
 * @param {Document} document
 * @param {Mesh} mesh of the surface
 * @param {number} index of the pin
 * @returns {Handled | null} null if there is no such pin, or nobody knows where it lies
 */
function handledPin({ settings, result }, mesh, index) {
  const { positions, centre } = mesh;
  const pin = settings.constraints.pins?.[index];
  const normal = pin ? heldNormal(pin, mesh) : null;
  if (!pin || (pin.position === false && !normal)) return null;
  const reported = result.constrained?.pins.find((one) => one.pin === index + 1 && !one.copy)?.position;
  const first = 3 * ((pin.vertex ?? 0) - 1);
  const known = first >= 0 && first + 2 < positions.length;
  const own = known ? [0, 1, 2].map((axis) => positions[first + axis] + centre[axis]) : reported;
  const place = pin.at ?? own;
  if (!place) return null;
  return { index, place: pin.position === false ? [NaN, NaN, NaN] : [...place], surface: [...(own ?? place)], normal };
}

/**
 * @param {HTMLElement} root
 * @param {(action: Action) => void} dispatch
 * @param {(reading: Reading | null) => void} pointed called with the values of the point that is pointed at
 * @param {(cut: CutFound | null) => void} [found] called with what the section has cut
 */
export function createSurfaceView(root, dispatch, pointed, found = () => {}) {
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
  /** The pin that has the handle, as the handle finds it. @type {Handled | null} */
  let handled = null;
  /** @param {[number, number, number]} at @param {boolean} moving */
  function dragged(at, moving) {
    if (edited.dragged(at, moving) || !handled) return;
    const { index, place } = handled;
    // A coordinate that the pin leaves free stays so.
    const [x, y, z] = at.map((value, axis) => (Number.isFinite(place[axis]) ? value : NaN));
    dispatch({ type: 'pinMoved', index, at: [x, y, z], moving });
  }
  /** @param {[number, number, number]} normal @param {boolean} moving */
  const turned = (normal, moving) => handled && dispatch({ type: 'pinTurned', index: handled.index, normal, moving });
  const scene =
    speed === 'never' ? null : createScene(canvas, { calm, slow: speed === 'slow', rested, drawn, dragged, turned });
  find(root, '.no-webgl').hidden = Boolean(scene);
  canvas.hidden = !scene;

  find(root, '#fit').addEventListener('click', () => dispatch({ type: 'fitPressed' }), { signal });

  const undrawn = createUndrawnView(root);
  canvas.addEventListener('webglcontextlost', () => undrawn.tell('lost'), { signal });
  canvas.addEventListener('webglcontextrestored', () => undrawn.tell(null), { signal });

  /** What is computed at each point of the surface on the screen. @type {Computed | null} */
  let computed = null;
  const probe = createProbe(root, canvas, {
    read: (x, y) => scene?.reading(x, y) ?? null,
    computed: () => computed,
    pointed,
  });
  /** @type {Projection} */
  let projection = 'perspective';
  function letGo() {
    dispatch({ type: 'viewChanged', change: { pin: null } });
    dispatch({ type: 'cageSelectionChanged', how: 'none' });
  }
  const keys = { v: probe.toggle, Escape: letGo, ...cameraKeys(dispatch, () => projection) };
  listenToKeys(canvas, scene?.controls, () => dispatch({ type: 'fitPressed' }), signal, keys);
  /** @type {Pointer} */
  let pointer = 'turn';
  let vertices = 0;
  const brush = {
    pointer: () => pointer,
    /** @param {number} x @param {number} y */
    pick: (x, y) => scene?.cell(x, y, vertices) ?? null,
    /** @param {number} x @param {number} y */
    isHandle: (x, y) => scene?.handleIsAt(x, y) ?? false,
    /** @param {number} x @param {number} y */
    pinAt: (x, y) => scene?.pinAt(x, y, PIN_REACH) ?? -1,
  };
  listenToBrush(canvas, brush, dispatch, signal);

  const edited = createEditedPicture(canvas, scene, dispatch, signal);

  const setCamera = whenChanged((/** @type {Camera} */ camera) => scene?.setCamera(camera));
  const project = whenChanged((/** @type {Projection} */ next) => scene?.project((projection = next)));
  const setHeld = whenChanged((/** @type {Parameters<typeof shownHeld>} */ ...asked) => {
    const held = shownHeld(...asked);
    scene?.setHeld(held.some(Boolean) ? held : null);
    scene?.setPins((asked[0].pins ?? []).map(({ vertex }) => (vertex ?? 0) - 1));
  });
  /** Those of the run; others than with the surface that was shown last if it was told to follow the hand since. @type {Settings | null} */
  let runSettings = null;
  /** @type {Settings | null} */
  let shownSettings = null;
  /** How the next surface comes after the one that is shown. @type {Motion | null} */
  let motion = null;
  const setSurface = whenChanged(
    (
      /** @type {Mesh} */ mesh,
      /** @type {Float32Array | null} */ values,
      /** @type {Pick<Mesh, 'centre' | 'positions'>} */ like,
    ) => {
      scene?.setSurface(mesh, values, like, motion);
      shownSettings = runSettings;
    },
  );
  const settleAtRest = whenChanged((/** @type {boolean} */ runs) => runs || scene?.settle());
  const setHandle = whenChanged(
    (
      /** @type {number | null} */ index,
      /** @type {Document} */ document,
      /** @type {Surface} */ { limit },
      /** @type {Editing | null} */ editing,
    ) => {
      if (editing) return scene?.setHandle(handleOf(editing));
      handled = index === null ? null : handledPin(document, limit, index);
      const free = handled?.place.map((x) => Number.isFinite(x));
      const where = handled?.place.map((x, axis) => (Number.isFinite(x) ? x : (handled?.surface[axis] ?? 0)));
      scene?.setHandle(where ?? null, free, handled?.normal);
    },
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
  const setSection = whenChanged((/** @type {Section} */ { shown: isShown, ...cut }, /** @type {Mesh} */ _) => {
    found(scene?.setSection(isShown ? cut : null) ?? null);
  });
  const setCrossings = whenChanged((/** @type {Float32Array | null} */ segments) => scene?.setCrossings(segments));
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
      const { limit, density } = view.before && start ? start : view.surface;
      const values = limit === view.surface.limit ? computedValues(state) : null;
      computed = values && computedOf(view.shading);
      edited.update(state);
      const like = edited.frame ?? (staysInPlace(document) ? view.surface.limit : limit);
      const runs = state.session.phase.name === 'running';
      runSettings = document.result.settings;
      motion = null;
      if (runs && limit === view.surface.limit) motion = runSettings === shownSettings ? 'even' : 'prompt';
      setSurface(limit, values, like);
      settleAtRest(runs);
      setHandle(view.pin, document, view.surface, editingOn(state));
      setMarked(view.boundary, document.cage, document.result.taken, limit);
      const crossings = view.crossings && limit === view.surface.limit ? view.surface.crossings : null;
      setSection(view.section, limit);
      setCrossings(crossings?.segments ?? null);
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
