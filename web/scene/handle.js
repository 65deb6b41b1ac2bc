// SPDX-License-Identifier: MIT
/**
 * @file The handle that moves a point: arrows along the axes of the file, squares for two of them, and a middle that moves
 * parallel to the screen; and, around it, two rings that turn a normal, which is an arrow.
 */
import { ArrowHelper, Object3D, Quaternion, Vector3 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';

/** @import {Camera, ColorRepresentation, Scene, Vector3Tuple} from 'three' */

/** Of three.js' own size. */
const SIZE = 0.7;
/** The rings lie around the arrows. */
const RINGS = 1.9 * SIZE;
/** Of the normal's arrow; the rings have a radius of 0.5. */
const LENGTH = 0.62;
/** The direction that is turned to the normal. */
const UP = new Vector3(0, 0, 1);
/** An arrow of three.js points along y. */
const alongY = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), UP);

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{scene: Scene, model: Object3D, lens: () => Camera}} place the handle moves in the model's coordinates
 * @param {object} listeners
 * @param {() => void} listeners.changed called when there is another picture to draw
 * @param {(held: boolean) => void} listeners.gripped called when it is taken, and when it is let go
 * @param {(position: Vector3Tuple, moving: boolean) => void} listeners.moved `moving` while the hand still moves
 * @param {(normal: Vector3Tuple, moving: boolean) => void} listeners.turned
 */
export function createHandle(canvas, { scene, model, lens }, { changed, gripped, moved, turned }) {
  const point = new Object3D();
  /** At the point; its UP is the normal. */
  const tip = new Object3D();
  point.add(tip);
  model.add(point);
  const arrow = new ArrowHelper(undefined, undefined, LENGTH, undefined, 0.12, 0.07);
  arrow.visible = false;
  scene.add(arrow);
  const controls = new TransformControls(lens(), canvas);
  controls.size = SIZE;
  const rings = new TransformControls(lens(), canvas);
  rings.setMode('rotate');
  rings.size = RINGS;
  rings.showZ = false; // about the normal there is nothing to turn
  const both = [controls, rings];
  for (const one of both) {
    one.setSpace('local');
    one.enabled = false;
    scene.add(one.getHelper());
    one.addEventListener('change', () => {
      if (both.some(({ axis }) => axis)) canvas.dataset.handle = '';
      else delete canvas.dataset.handle;
      changed();
    });
    one.addEventListener('dragging-changed', ({ value }) => gripped(Boolean(value)));
  }
  const isHeld = () => both.some(({ dragging }) => dragging);
  const normal = () => UP.clone().applyQuaternion(tip.quaternion);
  controls.addEventListener('objectChange', () => moved(point.position.toArray(), true));
  controls.addEventListener('mouseUp', () => moved(point.position.toArray(), false));
  rings.addEventListener('objectChange', () => turned(normal().toArray(), true));
  rings.addEventListener('mouseUp', () => turned(normal().toArray(), false));

  /** Shows the rings around a normal of length 1, or hides them. @param {Vector3Tuple | null} next */
  function turnTo(next) {
    const stays = rings.enabled === Boolean(next) && (!next || normal().distanceTo(new Vector3(...next)) < 1e-6);
    rings.enabled = arrow.visible = next !== null;
    if (next) {
      if (!stays) tip.quaternion.setFromUnitVectors(UP, new Vector3(...next));
      rings.attach(tip);
    } else rings.detach();
    return stays;
  }

  return {
    /** Whether a hand holds it. */
    isHeld,

    /** Whether it is under a point of the picture, from 0 to 1 as in pointing.js. @param {number} x @param {number} y */
    isAt(x, y) {
      return both.some((one) => {
        if (!one.enabled) return false;
        one.camera = lens();
        // three.js reads no more of a pointer than these.
        one.pointerHover(/** @type {PointerEvent} */ ({ x: 2 * x - 1, y: 1 - 2 * y, button: 0 }));
        return one.axis !== null;
      });
    },

    /**
     * Shows it at a position, or hides it. A hand that holds it has its own way.
     * @param {Vector3Tuple | null} position
     * @param {readonly boolean[]} [free] whether each coordinate may change
     * @param {Vector3Tuple | null} [held] the normal, of length 1, if it may be turned
     */
    set(position, free = [true, true, true], held = null) {
      if (isHeld() && position) return;
      if (!position && !controls.enabled) return;
      const points = turnTo(position && held);
      const stays = points && controls.enabled && position?.every((x, axis) => x === point.position.getComponent(axis));
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
      for (const one of both) one.camera = lens();
      if (!arrow.visible) return;
      tip.getWorldPosition(arrow.position);
      tip.getWorldQuaternion(arrow.quaternion);
      arrow.quaternion.multiply(alongY);
      // As large as three.js draws the rings, at any distance.
      const camera = /** @type {any} */ (lens());
      const extent = camera.isOrthographicCamera
        ? (camera.top - camera.bottom) / camera.zoom
        : arrow.position.distanceTo(camera.position) *
          Math.min((1.9 * Math.tan((Math.PI * camera.fov) / 360)) / camera.zoom, 7);
      arrow.scale.setScalar((extent * RINGS) / 4);
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} accent of the part that is pointed at */
    setColours(line, accent) {
      for (const one of both) one.setColors(line, line, line, accent);
      arrow.setColor(accent);
    },

    dispose() {
      for (const one of both) {
        one.dispose();
        one.getHelper().removeFromParent();
      }
      arrow.dispose();
      arrow.removeFromParent();
      point.removeFromParent();
    },
  };
}
