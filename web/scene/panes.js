// SPDX-License-Identifier: MIT
/**
 * @file Several surfaces side by side on one canvas, with a common camera: turning one turns all. Draws only when
 * something has changed.
 */
import { BufferGeometry, Mesh, Scene } from 'three';
import { extent, setSurface } from './geometry.js';
import { addLights } from './lights.js';
import { createSurfaceMaterial } from './material.js';
import { createOrbit } from './orbit.js';
import { createPainter } from './painter.js';
import { createStand } from './stand.js';

/** @import * as core from '../../wasm/types.js' */
/** @import {Camera} from '../address/camera.js' */
/** @import {Shade} from './material.js' */
/** @import {Extent} from './stand.js' */

/** A surface, null until it is loaded, and the element that marks where it is drawn on the canvas. @typedef {{mesh: core.Mesh | null, place: Element}} Pane */

/**
 * @param {HTMLCanvasElement} canvas fills its parent, which contains the elements of the panes
 * @param {object} options
 * @param {boolean} options.calm no inertia
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(camera: Camera) => void} options.rested called when the user has moved the camera
 */
export function createPanes(canvas, { calm, slow, rested }) {
  const scene = new Scene();
  const orbit = createOrbit(canvas, { moved: () => painter.request(), rested });
  const { camera, controls } = orbit;
  addLights(scene, camera);
  const surfaceMaterial = createSurfaceMaterial();
  const stand = createStand();
  stand.setUp('z'); // the symmetry axis of generated shapes
  scene.add(stand.object);

  /** @type {Array<Pane & {surface: Mesh | null, extent: Extent | null}>} */
  let panes = [];

  /** Where a pane is on the canvas, in CSS pixels, from its bottom left corner. @param {Pane} pane */
  function boxOf({ place }) {
    const frame = canvas.getBoundingClientRect();
    const { left, bottom, width, height } = place.getBoundingClientRect();
    return { left: left - frame.left, bottom: frame.bottom - bottom, width, height };
  }

  const painter = createPainter(canvas, {
    slow,
    prepare() {
      controls.enableDamping = !calm && !painter.isSlow();
      controls.update();
      return false;
    },
    draw(renderer) {
      renderer.autoClear = false;
      renderer.setClearColor(0, 0);
      renderer.setScissorTest(false);
      renderer.clear();
      renderer.setScissorTest(true);
      orbit.focus();
      for (const pane of panes) {
        if (!pane.surface || !pane.extent) continue;
        stand.centre({ centre: pane.extent.centre, radius: largest() });
        const { left, bottom, width, height } = boxOf(pane);
        renderer.setViewport(left, bottom, width, height);
        renderer.setScissor(left, bottom, width, height);
        for (const { surface } of panes) if (surface) surface.visible = surface === pane.surface;
        renderer.render(scene, camera);
      }
    },
    resized: measure,
  });

  /** All panes have the same size. */
  function measure() {
    if (!panes.length) return;
    const { width, height } = boxOf(panes[0]);
    if (width && height) orbit.resize(width / height);
  }

  /** The radius of the largest surface, which sets the scale of all. */
  const largest = () => Math.max(...panes.map((pane) => pane.extent?.radius ?? 0));

  return {
    controls,
    /** Moves the camera so that the largest surface fills its view. */
    fit: () => orbit.fit(),

    /** Sets the common camera. @param {Camera} next */
    setCamera: (next) => orbit.set(next),

    /** Sets the surfaces, in order. The camera keeps its distance relative to the largest one. @param {Pane[]} next */
    setPanes(next) {
      const before = panes;
      panes = next.map(({ mesh, place }) => {
        const kept = before.find((pane) => pane.mesh === mesh);
        return {
          mesh,
          place,
          surface: kept?.surface ?? (mesh && createSurface(mesh)),
          extent: kept?.extent ?? (mesh && extent(mesh.positions)),
        };
      });
      for (const { surface } of before) {
        if (!surface || panes.some((pane) => pane.surface === surface)) continue;
        stand.model.remove(surface);
        surface.geometry.dispose();
      }
      measure();
      painter.request();
    },

    /** @param {Shade} next */
    shade(next) {
      surfaceMaterial.shade(next);
      painter.request();
    },

    dispose() {
      painter.dispose();
      orbit.dispose();
      for (const { surface } of panes) surface?.geometry.dispose();
      surfaceMaterial.dispose();
    },
  };

  /** @param {core.Mesh} mesh */
  function createSurface(mesh) {
    const geometry = new BufferGeometry();
    setSurface(geometry, mesh);
    const surface = new Mesh(geometry, surfaceMaterial.material);
    stand.model.add(surface);
    return surface;
  }
}
