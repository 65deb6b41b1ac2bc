// SPDX-License-Identifier: MIT
/**
 * @file Converts the camera numbers of an address to a position in the world and back. In the world, y points up on the
 * screen and the surface lies about the origin with radius 1.
 */
import { MathUtils, Vector3 } from 'three';
import { roundCamera } from '../address/camera.js';

/** @import {Camera} from '../address/camera.js' */

/** Vertical field of view in degrees. */
export const FIELD_OF_VIEW = 28;
/** Factor of the radius that leaves some room around a surface that fits the view. */
const FIT_MARGIN = 1.16;

/** Smallest angle between the camera and the axis, in radians; on the axis the azimuth would be lost. */
const OFF_AXIS = 1e-4;

/**
 * The distance from which the unit ball fits the picture.
 * @param {number} aspect width / height of the picture
 */
export function fittingDistance(aspect) {
  const halfHeight = MathUtils.degToRad(FIELD_OF_VIEW) / 2;
  const halfWidth = Math.atan(Math.tan(halfHeight) * aspect);
  return FIT_MARGIN / Math.sin(Math.min(halfHeight, halfWidth));
}

/**
 * @param {Camera} camera
 * @param {number} aspect
 * @returns {{position: Vector3, target: Vector3}}
 */
export function placementOf({ azimuth, elevation, distance, target }, aspect) {
  const at = new Vector3(...target);
  const polar = MathUtils.clamp(MathUtils.degToRad(90 - elevation), OFF_AXIS, Math.PI - OFF_AXIS);
  const position = new Vector3().setFromSphericalCoords(
    distance * fittingDistance(aspect),
    polar,
    MathUtils.degToRad(azimuth),
  );
  return { position: position.add(at), target: at };
}

/**
 * The inverse of `placementOf`, rounded.
 * @param {{position: Vector3, target: Vector3}} placement
 * @param {number} aspect
 * @returns {Camera}
 */
export function cameraOf({ position, target }, aspect) {
  const from = position.clone().sub(target);
  return roundCamera({
    azimuth: MathUtils.radToDeg(Math.atan2(from.x, from.z)),
    elevation: MathUtils.radToDeg(Math.atan2(from.y, Math.hypot(from.x, from.z))),
    distance: from.length() / fittingDistance(aspect),
    target: target.toArray(),
  });
}
