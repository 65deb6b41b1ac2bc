// SPDX-License-Identifier: MIT
/**
 * @file The handle that moves a point: arrows along the axes of the file, squares for two of them, and a middle that moves
 * parallel to the screen.
 */
import { Object3D } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';

/** @import {Camera, ColorRepresentation, Scene, Vector3Tuple} from 'three' */

/** Of three.js' own size. */
const SIZE = 0.7;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{scene: Scene, model: Object3D, lens: () => Camera}} place the handle moves in the model's coordinates
 * @param {object} listeners
 * @param {() => void} listeners.changed called when there is another picture to draw
 * @param {(held: boolean) => void} listeners.gripped called when it is taken, and when it is let go
 * @param {(position: Vector3Tuple, moving: boolean) => void} listeners.moved `moving` while the hand still moves
 */
export function createHandle(canvas, { scene, model, lens }, { changed, gripped, moved }) {
  const point = new Object3D();
  model.add(point);
  const controls = new TransformControls(lens(), canvas);
  controls.setSpace('local');
  controls.size = SIZE;
  const helper = controls.getHelper();
  scene.add(helper);
  controls.enabled = false;

  controls.addEventListener('change', () => {
    if (controls.axis) canvas.dataset.handle = '';
    else delete canvas.dataset.handle;
    changed();
  });
  controls.addEventListener('dragging-changed', ({ value }) => gripped(Boolean(value)));
  controls.addEventListener('objectChange', () => moved(point.position.toArray(), true));
  controls.addEventListener('mouseUp', () => moved(point.position.toArray(), false));

  return {
    /** Whether a hand holds it. */
    isHeld: () => controls.dragging,

    /** Whether it is under a point of the picture, from 0 to 1 as in pointing.js. @param {number} x @param {number} y */
    isAt(x, y) {
      if (!controls.enabled) return false;
      controls.camera = lens();
      // three.js reads no more of a pointer than these.
      controls.pointerHover(/** @type {PointerEvent} */ ({ x: 2 * x - 1, y: 1 - 2 * y, button: 0 }));
      return controls.axis !== null;
    },

    /**
     * Shows it at a position, or hides it. A hand that holds it has its own way.
     * @param {Vector3Tuple | null} position
     * @param {readonly boolean[]} [free] whether each coordinate may change
     */
    set(position, free = [true, true, true]) {
      if (controls.dragging && position) return;
      if (!position && !controls.enabled) return;
      const stays = controls.enabled && position?.every((x, axis) => x === point.position.getComponent(axis));
      controls.enabled = position !== null;
      if (position) {
        point.position.set(...position);
        controls.attach(point);
        [controls.showX, controls.showY, controls.showZ] = free;
      } else {
        controls.detach();
        delete canvas.dataset.handle;
      }
      if (!stays) changed();
    },

    /** Before each picture. */
    prepare() {
      controls.camera = lens();
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} accent of the part that is pointed at */
    setColours(line, accent) {
      controls.setColors(line, line, line, accent);
    },

    dispose() {
      controls.dispose();
      helper.removeFromParent();
      point.removeFromParent();
    },
  };
}
