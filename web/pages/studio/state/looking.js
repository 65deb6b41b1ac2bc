// SPDX-License-Identifier: MIT
/**
 * @file How the camera of the studio looks along an axis and back again. Pure.
 */
import { axisViewOf, axisViews } from '../../../address/camera.js';

/** @import {AxisView} from '../../../address/camera.js' */
/** @import {View} from './types.js' */

/**
 * Looks along an axis. What looks along it already looks again as it did before; without a before, nothing changes.
 * @param {View} view
 * @param {AxisView} axis
 * @returns {Partial<View>}
 */
export function alongAxis({ camera, returnTo }, axis) {
  if (axisViewOf(camera) !== axis) {
    return { camera: { ...camera, ...axisViews[axis] }, returnTo: returnTo ?? camera };
  }
  if (!returnTo) return {};
  const { azimuth, elevation } = returnTo;
  return { camera: { ...camera, azimuth, elevation }, returnTo: null };
}

/**
 * A change of what is looked at. A camera that looks in no axis' direction has nothing to return to.
 * @param {Partial<View>} change
 * @returns {Partial<View>}
 */
export const looked = (change) =>
  change.camera && !axisViewOf(change.camera) ? { ...change, returnTo: null } : change;
