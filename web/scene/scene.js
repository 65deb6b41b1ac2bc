// SPDX-License-Identifier: MIT
/**
 * @file The three.js scene: surface, control cage, light and camera. Draws when something has changed and at no other
 * time.
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

/** The surface stands this part of the height above the middle, clear of the legend. */
const RAISE = 0.035;

/**
 * The cage's edges, plain where they are seen and faint where the surface hides them.
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
 * @param {boolean} options.calm without inertia
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(camera: Camera) => void} options.rested is called when the camera has been moved
 * @param {() => void} [options.drawn] is called after each picture
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
      // With inertia the update asks for the next frame itself, until it has come to rest; slow frames would make that long.
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

  /** Where the surface's positions are measured from. @type {Float64Array} */
  let origin = new Float64Array(3);

  rehearse();

  function requestRender() {
    if (surface.visible) painter.request();
  }

  /** Draws a triangle without size as the surface will be drawn. */
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

    /** Where the surface is looked at from. @param {Camera} next */
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

    /** That of the surface which was set last. @param {core.Mesh} mesh */
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
