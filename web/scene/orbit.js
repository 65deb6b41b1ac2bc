// SPDX-License-Identifier: MIT
/**
 * @file Camera controls: mouse, touch and keys turn, move and zoom the camera. Reports its position in the numbers of
 * an address when it comes to rest.
 */
import { MathUtils, OrthographicCamera, PerspectiveCamera } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { FARTHEST, NEAREST, firstCamera, sameCamera } from '../address/camera.js';
import { FIELD_OF_VIEW, cameraOf, fittingDistance, placementOf } from './placement.js';

/** @import {Camera, Projection} from '../address/camera.js' */

/** The camera rests if it has not moved for this many milliseconds. */
const REST = 200;
/**
 * Something may be visible up to this distance before and behind the surface's centre, in radii of the surface; cages
 * are larger than their surfaces.
 */
const SEEN = 8;

/**
 * @param {HTMLElement} element receives the mouse, touch and key events
 * @param {{moved: () => void, rested: (camera: Camera) => void}} listeners
 */
export function createOrbit(element, { moved, rested }) {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  /** Shows what is at the target in the same size. */
  const parallel = new OrthographicCamera();
  /** @type {Projection} */
  let projection = 'perspective';
  camera.position.copy(placementOf(firstCamera, camera.aspect).position);
  const controls = new OrbitControls(camera, element);
  element.style.cursor = ''; // OrbitControls sets one, over those of the style sheet
  controls.dampingFactor = 0.12;
  let reported = firstCamera;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const now = () => cameraOf({ position: camera.position, target: controls.target }, camera.aspect);

  controls.addEventListener('change', () => {
    moved();
    clearTimeout(timer);
    timer = setTimeout(() => {
      const resting = now();
      if (!sameCamera(resting, reported)) rested((reported = resting));
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
    // What is left of a motion would lead away from there.
    const { enableDamping } = controls;
    controls.enableDamping = false;
    controls.update();
    controls.enableDamping = enableDamping;
    limitDistance();
    controls.target.copy(target);
    camera.position.copy(position);
    controls.update();
    moved();
  }

  limitDistance();

  return {
    /** Moved by the controls. */
    camera,
    controls,

    /** @param {Camera} next */
    set(next) {
      if (next === reported) return;
      reported = next;
      place(next);
    },

    /** Fits the surface into the view; keeps the camera's direction. */
    fit: () => place({ ...now(), distance: 1, target: firstCamera.target }),

    /** Sets the aspect ratio of the picture; a surface that fits it still does. @param {number} aspect width / height */
    resize(aspect) {
      if (aspect === camera.aspect) return;
      const kept = now();
      camera.aspect = aspect;
      place(kept);
    },

    /** Sets the near and far planes; call before each picture. */
    focus() {
      const distance = camera.position.length();
      camera.near = Math.max(distance - SEEN, distance / 200);
      camera.far = distance + SEEN;
      camera.updateProjectionMatrix();
      if (projection === 'perspective') return;
      parallel.position.copy(camera.position);
      parallel.quaternion.copy(camera.quaternion);
      parallel.top = camera.position.distanceTo(controls.target) * Math.tan(MathUtils.degToRad(FIELD_OF_VIEW) / 2);
      parallel.right = parallel.top * camera.aspect;
      [parallel.bottom, parallel.left] = [-parallel.top, -parallel.right];
      [parallel.near, parallel.far] = [distance - SEEN, distance + SEEN];
      parallel.view = camera.view;
      parallel.updateProjectionMatrix();
    },

    /** The camera to draw with, after `focus`. */
    lens: () => (projection === 'perspective' ? camera : parallel),

    /** @param {Projection} next */
    project(next) {
      projection = next;
      moved();
    },

    dispose() {
      clearTimeout(timer);
      controls.dispose();
    },
  };
}
