// SPDX-License-Identifier: MIT
/**
 * @file The three.js scene: surface, lines over it, light and camera. Draws only when something has changed.
 */
import { BufferGeometry, Mesh, Plane, Scene } from 'three';
import { extent, setComputed, setParts, setSurface } from './geometry.js';
import { createGlide, timingOf } from './glide.js';
import { addLights } from './lights.js';
import { createEdited } from './edited.js';
import { createHandle } from './handle.js';
import { createMarks } from './marks.js';
import { createSurfaceMaterial } from './material.js';
import { createOrbit } from './orbit.js';
import { createOverlays } from './overlays.js';
import { createPainter } from './painter.js';
import { createPointing } from './pointing.js';
import { createSectionLines } from './section_lines.js';
import { createStand } from './stand.js';

/** @import * as core from '../../wasm/types.js' */
/** @import {Camera, Projection} from '../address/camera.js' */
/** @import {Motion} from './glide.js' */
/** @import {Shade} from './material.js' */
/** @import {Cut} from './section_lines.js' */

/** The surface is raised above the middle by this fraction of the height, clear of the legend. */
const RAISE = 0.035;

/**
 * @param {HTMLCanvasElement} canvas fills its parent
 * @param {object} options
 * @param {boolean} options.calm no inertia, and no motion of the surface between two meshes
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(camera: Camera) => void} options.rested called when the user has moved the camera
 * @param {() => void} [options.drawn] called after each picture
 * @param {(at: import('three').Vector3Tuple, moving: boolean) => void} [options.dragged] called with the place of the handle, in
 *   the coordinates of the file, when the user moves it; `moving` while the hand still moves
 * @param {(normal: import('three').Vector3Tuple, moving: boolean) => void} [options.turned] called with the normal that its rings turn
 */
export function createScene(canvas, { calm, slow, rested, drawn, dragged = () => {}, turned = () => {} }) {
  const scene = new Scene();
  const orbit = createOrbit(canvas, { moved: requestRender, rested });
  const { camera, controls } = orbit;
  controls.zoomToCursor = true;
  addLights(scene, camera);

  const surfaceMaterial = createSurfaceMaterial();
  const surfaceGeometry = new BufferGeometry();
  const surface = new Mesh(surfaceGeometry, [surfaceMaterial.material, surfaceMaterial.held]);
  surface.visible = false;
  surface.frustumCulled = false;
  const overlays = createOverlays(surfaceGeometry);
  const pointing = createPointing(surface, orbit.lens, () => (cutting ? section.plane : null));
  const stand = createStand();
  const glide = createGlide(surfaceGeometry, stand.centre);
  const marks = createMarks();
  const section = createSectionLines();
  const edited = createEdited(canvas, orbit.lens);
  stand.model.add(surface, overlays.group, marks.group, section.group, edited.group);
  scene.add(stand.object);
  const handle = createHandle(
    canvas,
    { scene, model: stand.model, lens: orbit.lens },
    {
      changed: requestRender,
      gripped: (isHeld) => (controls.enabled = !isHeld),
      moved([x, y, z], moving) {
        const [cx, cy, cz] = shown?.centre ?? [0, 0, 0];
        dragged([x + cx, y + cy, z + cz], moving);
      },
      turned,
    },
  );

  /** What is before it is not drawn, in the world. */
  const front = new Plane();
  /** The surface's materials, and the lines on it that are cut with it. */
  const cuttable = [surfaceMaterial.material, surfaceMaterial.held, overlays.patches];
  /** Whether what is before the section is cut away. */
  let cutting = false;
  /** @param {import('three').WebGLRenderer} renderer */
  function cutAway(renderer) {
    renderer.localClippingEnabled = cutting;
    stand.model.updateWorldMatrix(true, false);
    front.copy(section.plane).applyMatrix4(stand.model.matrixWorld);
  }

  const painter = createPainter(canvas, {
    slow,
    drawn,
    prepare() {
      // With inertia, each update requests the next frame until the motion ends; with slow frames that would take long.
      controls.enableDamping = !calm && !painter.isSlow();
      controls.update();
      return glide.advance(performance.now());
    },
    draw(renderer) {
      if (!surface.visible) return;
      orbit.focus();
      handle.prepare();
      cutAway(renderer);
      renderer.render(scene, orbit.lens());
    },
    resized(width, height) {
      orbit.resize(width / height);
      camera.setViewOffset(width, height, 0, RAISE * height, width, height);
    },
  });

  /** The mesh on the screen. @type {core.Mesh | null} */
  let shown = null;
  /** @type {Uint8Array | null} */
  let held = null;
  /** For each pin its vertex of the cage, from 0, or -1 if it lies elsewhere. @type {number[]} */
  let pinned = [];
  /** When the mesh on the screen was set, in milliseconds. */
  let since = 0;

  rehearse();

  function requestRender() {
    if (surface.visible) painter.request();
  }

  /** Puts a dot at each pin of the surface. @param {core.Mesh} mesh */
  function placePins({ positions }) {
    const known = pinned.filter((vertex) => vertex >= 0 && 3 * vertex < positions.length);
    marks.setPins(surfaceGeometry, Uint32Array.from(known));
  }

  /** How the surface moves to the next mesh; null if that is to be shown at once. @param {core.Mesh} next @param {Motion | null} motion */
  function motionTo(next, motion) {
    const now = performance.now();
    const passed = now - since;
    if (next !== shown) since = now;
    if (calm || !motion || next === shown || next.triangles !== shown?.triangles) return null;
    const timing = timingOf(motion, passed, painter.interval());
    return timing && { ...timing, now };
  }

  /** Ends the motion of the surface: what is shown is the newest mesh. */
  function settle() {
    if (glide.settle()) requestRender();
  }

  /** Draws triangles of zero size with the surface's materials, so that their shaders are compiled early. */
  function rehearse() {
    const sizes = { positions: 9, normals: 9, curvatures: 6 };
    const arrays = Object.entries(sizes).map(([name, size]) => [name, new Float32Array(size)]);
    const [triangles, faces, edges] = [new Uint32Array(6), new Uint32Array([0, 1]), new Uint32Array(0)];
    const mesh = { ...Object.fromEntries(arrays), centre: new Float64Array(3), triangles, faces, edges };
    setSurface(surfaceGeometry, mesh, Uint8Array.of(0, 1));
    surface.visible = true;
    painter.rehearse();
    surface.visible = false;
  }

  return {
    controls,
    requestRender,

    /** Sets the camera. @param {Camera} next */
    setCamera: (next) => orbit.set(next),

    /** How points are projected to the picture. @param {Projection} next */
    project: (next) => orbit.project(next),

    /**
     * Which axis of the model points upwards on the screen.
     * @param {'y' | 'z'} axis
     */
    setUp(axis) {
      stand.setUp(axis);
      requestRender();
    },

    /**
     * @param {core.Mesh} mesh
     * @param {Float32Array | null} [computed] a value of each vertex that is no function of curvatures
     * @param {Pick<core.Mesh, 'centre' | 'positions'>} [like] the mesh that is placed in the picture, to which this one keeps its position and size
     * @param {Motion | null} [motion] how it comes from the mesh before to this one, if that has the same topology; null: at once
     */
    setSurface(mesh, computed = null, like = mesh, motion = null) {
      const when = motionTo(mesh, motion);
      // A surface that moved under the hand would take the handle along.
      const stays = handle.isHeld();
      if (when) glide.keep([0, 1, 2].map((axis) => (stays ? 0 : (shown?.centre[axis] ?? 0) - mesh.centre[axis])));
      marks.setRim(surfaceGeometry, setSurface(surfaceGeometry, mesh, held));
      setComputed(surfaceGeometry, computed);
      placePins(mesh);
      shown = mesh;
      pointing.set(mesh, computed);
      const { centre, radius } = extent(like.positions);
      const [x, y, z] = centre.map((value, axis) => value + like.centre[axis] - mesh.centre[axis]);
      const next = stays ? null : { centre: /** @type {[number, number, number]} */ ([x, y, z]), radius };
      const { positions, normals, curvatures } = mesh;
      if (when) glide.begin({ position: positions, normal: normals, curvature: curvatures, computed }, next, when);
      else glide.jump(next);
      overlays.move(mesh.centre);
      edited.move(mesh.centre);
      surface.visible = true;
      requestRender();
    },

    /** Shows the newest mesh as it is, if the surface still moves there. */
    settle,

    /** Which faces of the cage are held: 1 for each, or null if none is. @param {Uint8Array | null} next */
    setHeld(next) {
      held = next;
      if (!shown) return;
      marks.setRim(surfaceGeometry, setParts(surfaceGeometry, shown, held));
      requestRender();
    },

    /** Which edges of the surface that was set last are marked, two vertices for each. @param {Uint32Array} edges */
    setMarked(edges) {
      if (edges.length) settle();
      marks.setBoundary(surfaceGeometry, edges);
      requestRender();
    },

    /** The segments of the surface's crossings with itself, 6 coordinates each; null for none. @param {Float32Array | null} segments */
    setCrossings(segments) {
      if (segments) settle();
      marks.setCrossings(segments ?? new Float32Array(0));
      requestRender();
    },

    /**
     * Cuts the surface that was set last. @param {Cut | null} cut null for no section
     * @returns {import('./section_lines.js').CutFound | null}
     */
    setSection(cut) {
      if (!shown) return null;
      if (cut) settle();
      const found = section.set(shown, cut);
      const cuts = cut?.cut ?? false;
      if (cuts !== cutting) for (const material of cuttable) material.clippingPlanes = cuts ? [front] : null;
      cutting = cuts;
      requestRender();
      return found;
    },

    /** For each pin its vertex of the cage, from 0, or -1 if it lies elsewhere. @param {number[]} next */
    setPins(next) {
      pinned = next;
      if (!shown) return;
      placePins(shown);
      requestRender();
    },

    /**
     * Shows the handle at a place in the coordinates of the file, or hides it.
     * @param {readonly number[] | null} at
     * @param {readonly boolean[]} [free] whether each coordinate may change
     * @param {import('three').Vector3Tuple | null} [normal] of length 1, if it may be turned
     */
    setHandle(at, free, normal) {
      const [cx, cy, cz] = shown?.centre ?? [0, 0, 0];
      handle.set(at && [at[0] - cx, at[1] - cy, at[2] - cz], free, normal);
    },

    /** Whether the handle is under a point of the picture. */
    handleIsAt: handle.isAt,

    /**
     * The pin whose dot is nearest to a point of the picture.
     * @param {number} x
     * @param {number} y
     * @param {number} most distance, in CSS pixels
     * @returns {number} from 0; -1 if there is none so near
     */
    pinAt(x, y, most) {
      if (!shown) return -1;
      const { clientWidth, clientHeight } = canvas;
      const distances = pinned.map((vertex) => {
        const [px, py] = vertex < 0 ? [NaN, NaN] : pointing.place(vertex);
        return Math.hypot((px - x) * clientWidth, (py - y) * clientHeight);
      });
      const nearest = distances.reduce((best, one, i) => (one < (distances[best] ?? Infinity) ? i : best), -1);
      return distances[nearest] <= most ? nearest : -1;
    },

    /** Shows the cage that is edited, or hides it. @param {Parameters<typeof edited.set>[0]} cage */
    setEdited(cage) {
      edited.set(cage);
      requestRender();
    },

    /** What of the cage that is edited is under a point of the picture, or in a box of it; see edited.js. */
    editedAt: edited.at,
    editedInBox: edited.inBox,

    /** What is under a point of the picture; see pointing.js. */
    cell: pointing.cell,
    reading: pointing.reading,

    /**
     * Lines over the surface that was set last; none for null.
     * @param {{control: core.Mesh | null, original: core.Mesh | null, patches: boolean}} lines the control cage, and the
     *   cage that the surface began from
     * @param {number} density quads along each edge of a patch
     */
    setLines({ control, original, patches }, density) {
      if (control) settle();
      overlays.setControl(control);
      overlays.setOriginal(original);
      overlays.setPatches(patches ? shown : null, density);
      requestRender();
    },

    /** @param {Shade} next */
    shade(next) {
      surfaceMaterial.shade(next);
      requestRender();
    },

    /** @param {string} line the colour of lines, as in CSS @param {string} accent of pins and of the cage that the surface began from */
    setColours(line, accent) {
      marks.setColours(line, accent);
      section.setColours(line, accent);
      overlays.setColours(line, accent);
      edited.setColours(line, accent);
      handle.setColours(line, accent);
      requestRender();
    },

    /** Moves the camera so that the surface fills the view; keeps its direction. */
    fit: () => orbit.fit(),

    dispose() {
      painter.dispose();
      handle.dispose();
      orbit.dispose();
      surfaceGeometry.dispose();
      overlays.dispose();
      surfaceMaterial.dispose();
      marks.dispose();
      section.dispose();
      edited.dispose();
    },
  };
}
