// SPDX-License-Identifier: MIT
/**
 * @file Leaves out of a mesh what the page has: its topology, which changes only with its level and density.
 */

/** @import {Mesh} from '../../wasm/types.js' */
/** @import {MeshUpdate} from './protocol.js' */

/** For the meshes of one kind of one run. */
export function createTopologyFilter() {
  let known = '';
  return {
    /**
     * The mesh, without its topology if the page knows that. Meshes of different refinements may have as many vertices.
     * @param {Mesh} mesh
     * @param {number} level of the surface
     * @param {number} [density]
     * @returns {MeshUpdate}
     */
    update(mesh, level, density = 1) {
      const { centre, positions, normals, curvatures } = mesh;
      const refinement = [level, density, positions.length].join(' ');
      const isKnown = refinement === known;
      known = refinement;
      return isKnown ? { centre, positions, normals, curvatures } : mesh;
    },

    /** To be called when another run begins. */
    forget() {
      known = '';
    },
  };
}
