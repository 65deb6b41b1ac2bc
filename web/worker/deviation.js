// SPDX-License-Identifier: MIT
/**
 * @file How far a surface is from the cage's own, at the vertices of its limit mesh: (X − X₀)·n₀, where X₀ is the point
 * of the cage's own surface with the same parameters at the same level, and n₀ the normal there. In the file's units.
 */

/** @import {Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {createOwnSurface} from './own_surface.js' */

/**
 * @param {Mesh} mesh
 * @param {Mesh} own with the same topology
 * @returns {Float32Array}
 */
export function deviations(mesh, own) {
  const shift = [0, 1, 2].map((axis) => mesh.centre[axis] - own.centre[axis]);
  return Float32Array.from({ length: mesh.positions.length / 3 }, (_, vertex) => {
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) {
      const i = 3 * vertex + axis;
      sum += (mesh.positions[i] - own.positions[i] + shift[axis]) * own.normals[i];
    }
    return sum;
  });
}

/** @param {ReturnType<typeof createOwnSurface>} own */
export function createDeviation(own) {
  /** The last mesh of a cage's own surface. @type {{surface: Minimizer, mesh: Mesh} | null} */
  let last = null;

  return {
    /**
     * @param {Minimizer} run
     * @param {Mesh} mesh its limit mesh
     * @param {number} density of it
     * @returns {Float32Array} one for each vertex
     */
    of(run, mesh, density) {
      const surface = own.of(run);
      const same = last?.surface === surface && last.mesh.positions.length === mesh.positions.length;
      if (!last || !same) last = { surface, mesh: surface.limitMesh(density) };
      return deviations(mesh, last.mesh);
    },

    drop() {
      last = null;
      own.drop();
    },
  };
}
