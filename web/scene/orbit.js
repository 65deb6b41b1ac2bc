// SPDX-License-Identifier: MIT
/**
 * @file The camera in the viewer's hands: turned, moved and brought closer by mouse, fingers and keys, and told in the numbers of an
 * address when it has come to rest.
 */
import { PerspectiveCamera } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { FARTHEST, NEAREST, firstCamera, sameCamera } from '../address/camera.js';
import { FIELD_OF_VIEW, cameraOf, fittingDistance, placementOf } from './placement.js';

/** @import {Camera} from '../address/camera.js' */

/** Milliseconds without a motion after which the camera rests. */
const REST = 200;
/** How far before and behind the surface's centre there is something to see, in its radii: cages are larger than their surfaces. */
const SEEN = 8;

/**
 * @param {HTMLElement} element where it is moved
 * @param {{moved: () => void, rested: (camera: Camera) => void}} listeners
 */
export function createOrbit(element, { moved, rested }) {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  camera.position.copy(placementOf(firstCamera, camera.aspect).position);
  const controls = new OrbitControls(camera, element);
  controls.dampingFactor = 0.12;
  let told = firstCamera;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const now = () => cameraOf({ position: camera.position, target: controls.target }, camera.aspect);

  controls.addEventListener('change', () => {
    moved();
    clearTimeout(timer);
    timer = setTimeout(() => {
      const resting = now();
      if (!sameCamera(resting, told)) rested((told = resting));
    }, REST);
  });

  function limitDistance() {
    const fit = fittingDistance(camera.aspect);
    controls.minDistance = NEAREST * fit;
    controls.maxDistance = FARTHEST * fit;
  }

  /** @param {Camera} next */
  function place(next) {
    const { position, target } = placementOf(next, camera.aspect);
    limitDistance();
    controls.target.copy(target);
    camera.position.copy(position);
    controls.update();
    moved();
  }

  limitDistance();

  return {
    camera,
    controls,

    /** @param {Camera} next */
    set(next) {
      if (next === told) return;
      told = next;
      place(next);
    },

    /** Brings the whole surface into the view, from where the camera is. */
    fit: () => place({ ...now(), distance: 1, target: firstCamera.target }),

    /** A picture of another shape; what fits it stays fitted. @param {number} aspect width / height */
    resize(aspect) {
      if (aspect === camera.aspect) return;
      const kept = now();
      camera.aspect = aspect;
      place(kept);
    },

    /** Before each picture: how near and how far there is something to see. */
    focus() {
      const distance = camera.position.length();
      camera.near = Math.max(distance - SEEN, distance / 200);
      camera.far = distance + SEEN;
      camera.updateProjectionMatrix();
    },

    dispose() {
      clearTimeout(timer);
      controls.dispose();
    },
  };
}
