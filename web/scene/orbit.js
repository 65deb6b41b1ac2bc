// SPDX-License-Identifier: MIT
/**
 * @file The camera in the viewer's hands: turned, moved and brought closer by mouse, fingers and keys, and told in the numbers of an
 * address when it has come to rest.
 */
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { FARTHEST, NEAREST, firstCamera, sameCamera } from '../address/camera.js';
import { FIELD_OF_VIEW, cameraOf, fittingDistance, placementOf } from './placement.js';

/** @import {Camera} from '../address/camera.js' */
/** @import {Size} from './placement.js' */

/** Milliseconds without a motion after which the camera rests. */
const REST = 200;

/**
 * @param {HTMLElement} element where it is moved
 * @param {{moved: () => void, rested: (camera: Camera) => void}} listeners
 */
export function createOrbit(element, { moved, rested }) {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  const controls = new OrbitControls(camera, element);
  controls.dampingFactor = 0.12;
  /** @type {Size | null} */
  let size = null;
  let wanted = firstCamera;
  let told = firstCamera;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const now = () =>
    size ? cameraOf({ position: camera.position, target: controls.target }, size, camera.aspect) : wanted;

  controls.addEventListener('change', () => {
    moved();
    clearTimeout(timer);
    timer = setTimeout(() => {
      const resting = now();
      if (!sameCamera(resting, told)) rested((told = resting));
    }, REST);
  });

  /** @param {Camera} next */
  function place(next) {
    wanted = next;
    if (!size) return;
    const { position, target } = placementOf(next, size, camera.aspect);
    const fit = fittingDistance(size.radius, camera.aspect);
    controls.minDistance = NEAREST * fit;
    controls.maxDistance = FARTHEST * fit;
    controls.target.copy(target);
    camera.position.copy(position);
    controls.update();
    moved();
  }

  return {
    camera,
    controls,

    /** @param {Camera} next */
    set(next) {
      if (next === told) return;
      told = next;
      place(next);
    },

    /**
     * Brings a surface of this size into the view, from where the camera is; the first one as the camera was set.
     * @param {Size} next
     */
    fit(next) {
      const direction = size ? { ...now(), distance: 1, target: firstCamera.target } : wanted;
      size = next;
      place(direction);
    },

    /** The surface has another size; where the camera is, measured by it, stays. @param {Size} next */
    hold(next) {
      const kept = now();
      size = next;
      place(kept);
    },

    /** A picture of another shape; what fits it stays fitted. @param {number} aspect width / height */
    resize(aspect) {
      if (aspect === camera.aspect) return;
      const kept = now();
      camera.aspect = aspect;
      place(kept);
    },

    /** Before each picture: how near and how far there is something to see. */
    focus() {
      const { centre, radius } = size ?? { centre: new Vector3(), radius: 1 };
      const distance = camera.position.distanceTo(centre);
      camera.near = Math.max(distance - 8 * radius, distance / 200);
      camera.far = distance + 8 * radius;
      camera.updateProjectionMatrix();
    },

    dispose() {
      clearTimeout(timer);
      controls.dispose();
    },
  };
}
