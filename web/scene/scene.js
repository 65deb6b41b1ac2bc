// SPDX-License-Identifier: MIT
/**
 * @file The three.js scene: surface, control cage, light and camera. Draws when something has changed and at no other
 * time.
 */
import {
  BufferGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  NeutralToneMapping,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { extent, setEdges, setSurface } from './geometry.js';
import { createSurfaceMaterial } from './material.js';
import { createPace } from './pace.js';

/** @import * as core from '../../wasm/types.js' */
/** @import {Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/** More pixels than this per CSS pixel cost time and are not seen. */
const MAX_PIXEL_RATIO = 2;
/** Milliseconds of rest after which a slow machine draws once more, finely. */
const REFINE_AFTER = 350;
const FIELD_OF_VIEW = 28;
/** Free room around a fitted surface, as a factor of its radius. */
const FIT_MARGIN = 1.16;
/** The surface stands this part of the height above the middle, clear of the legend. */
const RAISE = 0.035;
const FIRST_DIRECTION = new Vector3(0.8, 0.52, 1).normalize();

/**
 * Light that reads form: a bright sky, a warm ground, and a key that stays at the viewer's upper left.
 * @param {PerspectiveCamera} camera
 */
function createLights(camera) {
  const sky = new HemisphereLight(0xffffff, 0xe2ddd6, 2.3);
  const rig = new Group();
  const key = new DirectionalLight(0xffffff, 1.8);
  key.position.set(-0.9, 1.1, 1.2);
  const fill = new DirectionalLight(0xf2f4ff, 0.7);
  fill.position.set(1.4, -0.3, 0.6);
  rig.add(key, key.target, fill, fill.target);
  camera.add(rig);
  return sky;
}

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
 * @param {{calm: boolean, slow: boolean}} options `calm`: without inertia; `slow`: drawn without graphics hardware
 */
export function createScene(canvas, { calm, slow }) {
  const renderer = new WebGLRenderer({ canvas, antialias: !slow, alpha: true, powerPreference: 'high-performance' });
  renderer.toneMapping = NeutralToneMapping;
  const pixelRatio = Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO);
  renderer.setPixelRatio(pixelRatio);
  const scene = new Scene();
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  scene.add(camera, createLights(camera));

  const surfaceMaterial = createSurfaceMaterial();
  const surfaceGeometry = new BufferGeometry();
  const surface = new Mesh(surfaceGeometry, surfaceMaterial.material);
  surface.visible = false;
  const cageGeometry = new BufferGeometry();
  const cage = createCageLines(cageGeometry);
  const model = new Group();
  model.add(surface, cage.group);
  scene.add(model);

  const controls = new OrbitControls(camera, canvas);
  controls.dampingFactor = 0.12;
  controls.zoomToCursor = true;
  controls.addEventListener('change', () => requestRender());

  /** Where the surface was and how large, in the world, when it was fitted. */
  let size = { centre: new Vector3(), radius: 1 };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let refining;
  const pace = createPace(() => {
    canvas.dataset.picture = slow ? 'coarse' : 'fine';
    // With inertia the update asks for the next frame itself, until it has come to rest; slow frames would make that long.
    controls.enableDamping = !calm && !slow && !pace.isSlow();
    controls.update();
    render();
    if (!slow) return;
    clearTimeout(refining);
    refining = setTimeout(() => {
      if (canvas.dataset.picture !== 'coarse') return;
      render(2);
      canvas.dataset.picture = 'fine';
    }, REFINE_AFTER);
  });

  function requestRender() {
    canvas.dataset.picture = 'old';
    pace.request();
  }

  /** @param {number} [fineness] */
  function render(fineness = 1) {
    if (renderer.getPixelRatio() !== fineness * pixelRatio) renderer.setPixelRatio(fineness * pixelRatio);
    const distance = camera.position.distanceTo(size.centre);
    camera.near = Math.max(distance - 8 * size.radius, distance / 200);
    camera.far = distance + 8 * size.radius;
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  }

  /**
   * Energies depend on neither size nor place, so both drift while they are minimized; the picture keeps them.
   * @param {Float32Array} positions
   */
  function hold(positions) {
    const { centre, radius } = extent(positions);
    const scale = size.radius / radius;
    model.scale.setScalar(Number.isFinite(scale) && scale > 0 ? scale : 1);
    model.position.set(0, 0, 0);
    model.updateMatrixWorld();
    model.position.copy(size.centre).sub(model.localToWorld(new Vector3(...centre)));
    model.updateMatrixWorld();
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas.parentElement ?? canvas;
    if (!clientWidth || !clientHeight) return;
    renderer.setSize(clientWidth, clientHeight, false);
    camera.aspect = clientWidth / clientHeight;
    camera.setViewOffset(clientWidth, clientHeight, 0, RAISE * clientHeight, clientWidth, clientHeight);
    // At once: a canvas that has been resized is blank until it is drawn.
    render();
    requestRender();
  }

  const observer = new ResizeObserver(resize);
  observer.observe(canvas.parentElement ?? canvas);
  canvas.addEventListener('webglcontextrestored', requestRender);

  return {
    controls,
    requestRender,

    /**
     * Which axis of the model points upwards on the screen.
     * @param {'y' | 'z'} axis
     */
    setUp(axis) {
      model.rotation.x = axis === 'z' ? -Math.PI / 2 : 0;
      model.updateMatrixWorld();
      requestRender();
    },

    /** @param {core.Mesh} mesh */
    setSurface(mesh) {
      setSurface(surfaceGeometry, mesh);
      hold(mesh.positions);
      surface.visible = true;
      requestRender();
    },

    /** @param {core.Mesh} mesh */
    setCage(mesh) {
      setEdges(cageGeometry, mesh);
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

    /**
     * Moves the camera so that the surface fills the view; keeps its direction unless `fresh`.
     * @param {Float32Array} positions
     * @param {boolean} fresh
     */
    fit(positions, fresh) {
      const { centre, radius } = extent(positions);
      model.scale.setScalar(1);
      model.position.set(0, 0, 0);
      model.updateMatrixWorld();
      size = { centre: model.localToWorld(new Vector3(...centre)), radius: radius || 1 };
      const halfHeight = (FIELD_OF_VIEW * Math.PI) / 360;
      const halfWidth = Math.atan(Math.tan(halfHeight) * camera.aspect);
      const distance = (FIT_MARGIN * size.radius) / Math.sin(Math.min(halfHeight, halfWidth));
      const direction = fresh ? FIRST_DIRECTION : camera.position.clone().sub(controls.target).normalize();
      controls.target.copy(size.centre);
      controls.minDistance = 0.2 * size.radius;
      controls.maxDistance = 30 * size.radius;
      camera.position.copy(size.centre).addScaledVector(direction, distance);
      controls.update();
      requestRender();
    },

    dispose() {
      clearTimeout(refining);
      pace.dispose();
      observer.disconnect();
      controls.dispose();
      surfaceGeometry.dispose();
      cageGeometry.dispose();
      cage.materials.forEach((material) => material.dispose());
      surfaceMaterial.dispose();
      renderer.dispose();
    },
  };
}
