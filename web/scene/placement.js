// SPDX-License-Identifier: MIT
/**
 * @file Where a perspective camera stands for the numbers of an address, and the numbers for where it stands.
 */
import { MathUtils, Vector3 } from 'three';
import { roundCamera } from '../address/camera.js';

/** @import {Camera} from '../address/camera.js' */

/** Degrees, from the bottom of the picture to its top. */
export const FIELD_OF_VIEW = 28;
/** Free room around a surface that fits, as a factor of its radius. */
const FIT_MARGIN = 1.16;

/** Radians from the axis that a camera on it keeps, so that it does not lose its azimuth. */
const OFF_AXIS = 1e-4;

/** What is looked at: in the world, whose y points up on the screen. @typedef {{centre: Vector3, radius: number}} Size */

/**
 * The distance from which a ball fits the picture.
 * @param {number} radius
 * @param {number} aspect width / height of the picture
 */
export function fittingDistance(radius, aspect) {
  const halfHeight = MathUtils.degToRad(FIELD_OF_VIEW) / 2;
  const halfWidth = Math.atan(Math.tan(halfHeight) * aspect);
  return (FIT_MARGIN * radius) / Math.sin(Math.min(halfHeight, halfWidth));
}

/**
 * @param {Camera} camera
 * @param {Size} size
 * @param {number} aspect
 * @returns {{position: Vector3, target: Vector3}}
 */
export function placementOf({ azimuth, elevation, distance, target }, { centre, radius }, aspect) {
  const at = new Vector3(...target).multiplyScalar(radius).add(centre);
  const polar = MathUtils.clamp(MathUtils.degToRad(90 - elevation), OFF_AXIS, Math.PI - OFF_AXIS);
  const position = new Vector3().setFromSphericalCoords(
    distance * fittingDistance(radius, aspect),
    polar,
    MathUtils.degToRad(azimuth),
  );
  return { position: position.add(at), target: at };
}

/**
 * The inverse of `placementOf`, rounded.
 * @param {{position: Vector3, target: Vector3}} placement
 * @param {Size} size
 * @param {number} aspect
 * @returns {Camera}
 */
export function cameraOf({ position, target }, { centre, radius }, aspect) {
  const from = position.clone().sub(target);
  const [x, y, z] = target.clone().sub(centre).divideScalar(radius).toArray();
  return roundCamera({
    azimuth: MathUtils.radToDeg(Math.atan2(from.x, from.z)),
    elevation: MathUtils.radToDeg(Math.atan2(from.y, Math.hypot(from.x, from.z))),
    distance: from.length() / fittingDistance(radius, aspect),
    target: [x, y, z],
  });
}
