// SPDX-License-Identifier: MIT
/**
 * @file The three.js scene: surface, control cage, light and camera. Draws only when something has changed.
 */
import { BufferGeometry, Color, Group, LineBasicMaterial, LineSegments, Mesh, Scene } from 'three';
import { extent, setEdges, setSurface } from './geometry.js';
import { addLights } from './lights.js';
import { createSurfaceMaterial } from './material.js';
import { createOrbit } from './orbit.js';
import { createPainter } from './painter.js';
import { createStand } from './stand.js';

/** @import * as core from '../../wasm/types.js' */
/** @import {Camera} from '../address/camera.js' */
/** @import {Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/** The surface is raised above the middle by this fraction of the height, clear of the legend. */
const RAISE = 0.035;

/**
 * The cage's edges: plain where visible, faint where the surface hides them.
 * @param {BufferGeometry} geometry
 */
function createCageLines(geometry) {
  const seen = new LineBasicMaterial({ transparent: true, opacity: 0.85 });
  const hidden = new LineBasicMaterial({ transparent: true, opacity: 0.16, depthTest: false });
  const group = new Group();
  group.add(new LineSegments(geometry, hidden), new LineSegments(geometry, seen));
  group.visible = false;
  return { group, materials: [seen, hidden] };
}

/**
 * @param {HTMLCanvasElement} canvas fills its parent
 * @param {object} options
 * @param {boolean} options.calm no inertia
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(camera: Camera) => void} options.rested called when the user has moved the camera
 * @param {() => void} [options.drawn] called after each picture
 */
export function createScene(canvas, { calm, slow, rested, drawn }) {
  const scene = new Scene();
  const orbit = createOrbit(canvas, { moved: requestRender, rested });
  const { camera, controls } = orbit;
  controls.zoomToCursor = true;
  addLights(scene, camera);

  const surfaceMaterial = createSurfaceMaterial();
  const surfaceGeometry = new BufferGeometry();
  const surface = new Mesh(surfaceGeometry, surfaceMaterial.material);
  surface.visible = false;
  surface.frustumCulled = false;
  const cageGeometry = new BufferGeometry();
  const cage = createCageLines(cageGeometry);
  const stand = createStand();
  stand.model.add(surface, cage.group);
  scene.add(stand.object);

  const painter = createPainter(canvas, {
    slow,
    drawn,
    prepare() {
      // With inertia, each update requests the next frame until the motion ends; with slow frames that would take long.
      controls.enableDamping = !calm && !painter.isSlow();
      controls.update();
    },
    draw(renderer) {
      if (!surface.visible) return;
      orbit.focus();
      renderer.render(scene, camera);
    },
    resized(width, height) {
      orbit.resize(width / height);
      camera.setViewOffset(width, height, 0, RAISE * height, width, height);
    },
  });

  /** Origin of the surface's positions, in the cage's coordinates. @type {Float64Array} */
  let origin = new Float64Array(3);

  rehearse();

  function requestRender() {
    if (surface.visible) painter.request();
  }

  /** Draws a triangle of zero size with the surface's material, so that its shaders are compiled early. */
  function rehearse() {
    const sizes = { positions: 9, normals: 9, curvatures: 6 };
    const arrays = Object.entries(sizes).map(([name, size]) => [name, new Float32Array(size)]);
    const [triangles, edges] = [new Uint32Array(3), new Uint32Array(0)];
    setSurface(surfaceGeometry, { ...Object.fromEntries(arrays), centre: origin, triangles, edges });
    surface.visible = true;
    painter.rehearse();
    surface.visible = false;
  }

  return {
    controls,
    requestRender,

    /** Sets the camera. @param {Camera} next */
    setCamera: (next) => orbit.set(next),

    /**
     * Which axis of the model points upwards on the screen.
     * @param {'y' | 'z'} axis
     */
    setUp(axis) {
      stand.setUp(axis);
      requestRender();
    },

    /** @param {core.Mesh} mesh */
    setSurface(mesh) {
      setSurface(surfaceGeometry, mesh);
      stand.centre(extent(mesh.positions));
      origin = mesh.centre;
      surface.visible = true;
      requestRender();
    },

    /** Sets the control cage of the surface that was set last. @param {core.Mesh} mesh */
    setCage(mesh) {
      setEdges(cageGeometry, mesh);
      const [x, y, z] = mesh.centre.map((value, axis) => value - origin[axis]);
      cage.group.position.set(x, y, z);
      requestRender();
    },

    /** @param {boolean} visible */
    showCage(visible) {
      cage.group.visible = visible;
      requestRender();
    },

    /** @param {Quantity | null} quantity @param {Range | null} range */
    shade(quantity, range) {
      surfaceMaterial.shade(quantity, range);
      requestRender();
    },

    /** @param {string} colour of the cage's lines, as in CSS */
    setLineColour(colour) {
      cage.materials.forEach((material) => material.color.set(new Color(colour)));
      requestRender();
    },

    /** Moves the camera so that the surface fills the view; keeps its direction. */
    fit: () => orbit.fit(),

    dispose() {
      painter.dispose();
      orbit.dispose();
      surfaceGeometry.dispose();
      cageGeometry.dispose();
      cage.materials.forEach((material) => material.dispose());
      surfaceMaterial.dispose();
    },
  };
}
