// SPDX-License-Identifier: MIT
/**
 * @file How far a surface is from the cage's own, at the vertices of its limit mesh: (X − X₀)·n₀, where X₀ is the point
 * of the cage's own surface with the same parameters at the same level, and n₀ the normal there. In the file's units.
 */

/** @import {Minimizer} from '../../wasm/umbilic.js' */
/** @import {Mesh, Problem} from '../../wasm/types.js' */

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

/** @param {{Minimizer: typeof Minimizer}} core */
export function createDeviation(core) {
  /** The run whose cage's own surface is known, at which level, and the last mesh of that. @type {{run: Minimizer, level: number, surface: Minimizer, mesh: Mesh | null} | null} */
  let own = null;

  function drop() {
    own?.surface.dispose();
    own = null;
  }

  /** @param {Minimizer} run */
  function surfaceOf(run) {
    const { level } = run.progress;
    if (own?.run === run && own.level === level) return own;
    drop();
    /** @type {Problem} */
    const problem = { ...run.problem, options: { ...run.problem.options, levels: [level, level] } };
    delete problem.start;
    return (own = { run, level, surface: new core.Minimizer(problem), mesh: null });
  }

  return {
    /**
     * @param {Minimizer} run
     * @param {Mesh} mesh its limit mesh
     * @param {number} density of it
     * @returns {Float32Array} one for each vertex
     */
    of(run, mesh, density) {
      const known = surfaceOf(run);
      const same = known.mesh?.positions.length === mesh.positions.length;
      return deviations(mesh, (known.mesh = (same && known.mesh) || known.surface.limitMesh(density)));
    },

    drop,
  };
}
