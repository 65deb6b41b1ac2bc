// SPDX-License-Identifier: MIT
/**
 * @file What is under a point of the picture. Points of the picture go from 0 at the left to 1 at the right, and from 0 at
 * the top to 1 at the bottom.
 */
import { Raycaster, Vector2, Vector3 } from 'three';
import { boxesOf } from './boxes.js';
import { nearestVertex, pick } from './pick.js';
import { readingAt } from './reading.js';

/** @import {Camera, Object3D} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {HalfSpace} from './pick.js' */
/** @import {Reading} from './reading.js' */

/**
 * @param {Object3D} surface drawn with the mesh's own coordinates
 * @param {() => Camera} camera
 * @param {() => HalfSpace | null} [kept] where the mesh is drawn, in its coordinates; null for everywhere
 */
export function createPointing(surface, camera, kept = () => null) {
  const ray = new Raycaster();
  /** @type {Mesh | null} */
  let mesh = null;
  /** @type {Float32Array | null} */
  let computed = null;
  /** Of the mesh, once they are needed. @type {Float64Array | null} */
  let boxes = null;

  /** @param {number} x @param {number} y */
  function hit(x, y) {
    if (!mesh) return null;
    surface.updateWorldMatrix(true, false);
    camera().updateWorldMatrix(true, false);
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), camera());
    ray.ray.applyMatrix4(surface.matrixWorld.clone().invert());
    boxes ??= boxesOf(mesh);
    return pick(mesh, ray.ray.origin.toArray(), ray.ray.direction.toArray(), { boxes, space: kept() });
  }

  return {
    /** @param {Mesh} next @param {Float32Array | null} [values] computed of each vertex */
    set(next, values = null) {
      mesh = next;
      computed = values;
      boxes = null;
    },

    /**
     * @param {number} x
     * @param {number} y
     * @param {number} vertices of the cage
     * @returns {{face: number, vertex: number} | null} the face of the cage, and its vertex nearest to the point, from 0
     */
    cell(x, y, vertices) {
      const found = hit(x, y);
      return found && mesh && { face: found.face, vertex: nearestVertex(mesh, found, vertices) };
    },

    /** Where a vertex of the mesh is in the picture. @param {number} vertex from 0 @returns {[x: number, y: number]} NaN if it has none */
    place(vertex) {
      const [x, y, z] = mesh?.positions.subarray(3 * vertex, 3 * vertex + 3) ?? [];
      surface.updateWorldMatrix(true, false);
      camera().updateWorldMatrix(true, false);
      const seen = new Vector3(x, y, z).applyMatrix4(surface.matrixWorld).project(camera());
      return [(1 + seen.x) / 2, (1 - seen.y) / 2];
    },

    /** @param {number} x @param {number} y @returns {Reading | null} */
    reading(x, y) {
      const found = hit(x, y);
      return found && mesh && readingAt(mesh, computed, found);
    },
  };
}
