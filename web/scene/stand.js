// SPDX-License-Identifier: MIT
/**
 * @file Where a surface stands in the world: about the origin and of radius 1, wherever its file has put it and however large it is.
 * Cameras and addresses count from the origin, in radii, and need to know neither.
 */
import { Group } from 'three';

/** @import {Vector3Tuple} from 'three' */

/**
 * The centre and radius of a mesh in its own coordinates, as `extent` finds them.
 * @typedef {{centre: Vector3Tuple, radius: number}} Extent
 */

export function createStand() {
  const turned = new Group(); // about the origin
  const model = new Group(); // what has the mesh's own coordinates
  turned.add(model);
  return {
    /** To be put into the scene. */
    object: turned,
    model,

    /** Which axis of the model points upwards on the screen. @param {'y' | 'z'} axis */
    setUp(axis) {
      turned.rotation.x = axis === 'z' ? -Math.PI / 2 : 0;
    },

    /**
     * Energies depend on neither size nor place, so both drift while they are minimized: told each time that the surface has changed,
     * the picture keeps them.
     * @param {Extent} extent
     */
    centre({ centre, radius }) {
      const scale = radius > 0 && Number.isFinite(radius) ? 1 / radius : 1;
      model.scale.setScalar(scale);
      model.position.set(...centre).multiplyScalar(-scale);
    },
  };
}
