// SPDX-License-Identifier: MIT
/**
 * @file Leaves out of a mesh what the page has: its topology, which changes only with its level and density.
 */

/** @import {Mesh} from '../../wasm/types.js' */
/** @import {MeshUpdate} from './protocol.js' */

/** For the meshes of one kind of one run, whose refinements differ in their number of vertices. */
export function createTopologyFilter() {
  let known = -1;
  return {
    /** The mesh, without its topology if the page knows that. @param {Mesh} mesh @returns {MeshUpdate} */
    update(mesh) {
      const { centre, positions, normals, curvatures } = mesh;
      const isKnown = positions.length === known;
      known = positions.length;
      return isKnown ? { centre, positions, normals, curvatures } : mesh;
    },

    /** To be called when another run begins. */
    forget() {
      known = -1;
    },
  };
}
