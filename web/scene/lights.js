// SPDX-License-Identifier: MIT
/**
 * @file The lights: a bright sky, a warm ground, and a key light at the viewer's upper left, so that the shape is easy
 * to see.
 */
import { DirectionalLight, Group, HemisphereLight } from 'three';

/** @import {PerspectiveCamera, Scene} from 'three' */

/** @param {Scene} scene @param {PerspectiveCamera} camera carries the key light */
export function addLights(scene, camera) {
  const sky = new HemisphereLight(0xffffff, 0xe2ddd6, 2.3);
  const rig = new Group();
  const key = new DirectionalLight(0xffffff, 1.8);
  key.position.set(-0.9, 1.1, 1.2);
  const fill = new DirectionalLight(0xf2f4ff, 0.7);
  fill.position.set(1.4, -0.3, 0.6);
  rig.add(key, key.target, fill, fill.target);
  camera.add(rig);
  scene.add(camera, sky);
}
