// SPDX-License-Identifier: MIT
/**
 * @file Draws catalog entries with the page's renderer. All entries of a row share the lights, the camera's direction
 * and the colour scale; each surface fills the canvas.
 */
import { Vector3 } from 'three';
import { Minimizer, load } from '../../../wasm/umbilic.js';
import { quantityOf, sampleValues } from '../../../web/colour/quantities.js';
import { robustRange } from '../../../web/colour/range.js';
import { extent } from '../../../web/scene/geometry.js';
import { createScene } from '../../../web/scene/scene.js';

/** @import {Mesh, Report} from '../../../wasm/types.js' */

const QUADS = 60_000;
/** The fraction of the canvas, across or up, that a surface fills. */
const FILLED = 0.94;

/**
 * The smallest range of K, in 1/radius², of a row's colours; a sphere has K = 1. The range is the median of the
 * surfaces' own ranges, unless that is smaller.
 */
const LEAST_RANGE = 3;

/**
 * The direction from which each shape is seen: the azimuth about its symmetry axis and the elevation, in degrees,
 * chosen so that its junctions and its holes are visible.
 * @type {Record<string, [azimuth: number, elevation: number]>}
 */
const views = {
  'two-3': [45, 24],
  'two-12': [75, 22],
  'tetrahedron-frame': [100, 25],
  'cube-frame': [30, 33],
  'octahedron-frame': [100, 25],
  'dodecahedron-frame': [30, 35],
  'icosahedron-frame': [30, 33],
  'cuboctahedron-frame': [30, 33],
  'triangular-prism-frame': [30, 30],
  'pentagonal-prism-frame': [30, 30],
  'hexagonal-prism-frame': [30, 30],
  'truncated-tetrahedron-frame': [100, 25],
};
/** @type {[number, number]} */
const usualView = [70, 26];
/** Of holes: from above, so that the whole surface is visible. @type {[number, number]} */
const holeView = [70, 40];

const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas'));
const scene = createScene(canvas, { calm: true, slow: true, rested: () => {} });
scene.setUp('z');

/** Moves the mesh to the origin and scales it to unit size, so that curvatures in a row can be compared. @param {Mesh} mesh */
function normalize(mesh) {
  const { centre, radius } = extent(mesh.positions);
  mesh.positions.forEach((value, i) => (mesh.positions[i] = (value - centre[i % 3]) / radius));
  mesh.curvatures.forEach((value, i) => (mesh.curvatures[i] = value * radius));
  return mesh;
}

/** @param {Report} report @returns {Mesh} */
function limitMesh(report) {
  const minimizer = new Minimizer(report);
  const faces = minimizer.controlMesh().edges.length / 4;
  const density = Math.max(1, Math.min(24, Math.round(Math.sqrt(QUADS / faces))));
  const mesh = minimizer.limitMesh(density);
  minimizer.dispose();
  return normalize(mesh);
}

/** Moves the camera so that the surface fills the canvas and is centred. @param {Float32Array} positions */
function frame(positions) {
  const { controls } = scene;
  const camera = /** @type {import('three').PerspectiveCamera} */ (controls.object);
  const point = new Vector3();
  // The scene sets these only when it draws, but the projection below needs them now.
  [camera.near, camera.far] = [0.1, 100];
  camera.updateProjectionMatrix();
  for (let round = 0; round < 6; round++) {
    camera.updateMatrixWorld();
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    for (let i = 0; i < positions.length; i += 3) {
      point.set(positions[i], positions[i + 2], -positions[i + 1]).project(camera);
      [point.x, point.y].forEach((value, axis) => {
        low[axis] = Math.min(low[axis], value);
        high[axis] = Math.max(high[axis], value);
      });
    }
    const away = camera.position.clone().sub(controls.target);
    const halfHeight = away.length() * Math.tan((camera.fov * Math.PI) / 360);
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
    controls.target
      .addScaledVector(right, ((low[0] + high[0]) / 2) * halfHeight * camera.aspect)
      .addScaledVector(up, ((low[1] + high[1]) / 2) * halfHeight);
    away.multiplyScalar(Math.max(high[0] - low[0], high[1] - low[1]) / 2 / FILLED);
    camera.position.copy(controls.target).add(away);
    controls.update();
  }
}

/** @type {Mesh[]} */
let meshes = [];
let shape = '';

/** The functions that `npm run pictures` calls in the page. */
const thumbnails = {
  /** @param {string} name the row's shape @param {Report[]} reports the reports of its entries */
  async open(name, reports) {
    await load();
    meshes = reports.map(limitMesh);
    shape = name;
    const quantity = quantityOf('gaussian');
    if (!quantity) throw new Error('Gaussian curvature is not there');
    const ranges = meshes.map(({ curvatures }) => robustRange(sampleValues(quantity, curvatures), quantity.signed));
    const middle = ranges.map(({ high }) => high).sort((a, b) => a - b)[meshes.length >> 1];
    const high = Math.max(middle, LEAST_RANGE);
    scene.shade({ quantity, range: { low: -high, high, ticks: [] } });
  },

  /** @param {number} index in the row */
  show(index) {
    const { positions } = meshes[index];
    scene.setSurface(meshes[index]);
    const [azimuth, elevation] = views[shape] ?? (shape.startsWith('hole-') ? holeView : usualView);
    scene.setCamera({ azimuth, elevation, distance: 1, target: [0, 0, 0] });
    frame(positions);
    scene.requestRender();
  },
};

Object.assign(window, { thumbnails });
