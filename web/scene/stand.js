// SPDX-License-Identifier: MIT
/**
 * @file Places a surface in the world, centred at the origin with radius 1, whatever its own position and size. Cameras
 * and addresses count in this unit, from the origin, and need to know neither.
 */
import { Group } from 'three';

/** @import {Vector3Tuple} from 'three' */

/**
 * The centre and radius of a mesh in its own coordinates, as `extent` finds them.
 * @typedef {{centre: Vector3Tuple, radius: number}} Extent
 */

export function createStand() {
  const turned = new Group(); // turns its content about the origin
  const model = new Group(); // its content is in the mesh's own coordinates
  turned.add(model);
  return {
    /** The object to add to the scene. */
    object: turned,
    model,

    /** Which axis of the model points upwards on the screen. @param {'y' | 'z'} axis */
    setUp(axis) {
      turned.rotation.x = axis === 'z' ? -Math.PI / 2 : 0;
    },

    /**
     * Keeps the surface in place. Energies do not depend on size and position, so both drift during a run; call this
     * each time that the surface has changed.
     * @param {Extent} extent
     */
    centre({ centre, radius }) {
      const scale = radius > 0 && Number.isFinite(radius) ? 1 / radius : 1;
      model.scale.setScalar(scale);
      model.position.set(...centre).multiplyScalar(-scale);
    },
  };
}
