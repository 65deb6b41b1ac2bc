// SPDX-License-Identifier: MIT
/**
 * @file Copies the arrays of a mesh into a three.js geometry. Reuses the buffers while only positions change, and
 * replaces them when counts change.
 */
import { BufferAttribute } from 'three';
import { splitHeld } from './held.js';

/** @import {BufferGeometry} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */

/**
 * Curvatures near extraordinary vertices may be infinite, which the graphics card cannot interpolate; this replaces
 * them.
 */
const LARGEST = 1e12;

/** @param {Float32Array} values changed in place */
function makeFinite(values) {
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (!(value <= LARGEST && value >= -LARGEST)) values[i] = Number.isNaN(value) ? 0 : Math.sign(value) * LARGEST;
  }
}

/**
 * @param {BufferGeometry} geometry
 * @param {string} name
 * @param {Float32Array} array
 * @param {number} itemSize
 */
function setAttribute(geometry, name, array, itemSize) {
  const attribute = geometry.getAttribute(name);
  if (attribute instanceof BufferAttribute && attribute.array.length === array.length) {
    attribute.copyArray(array);
    attribute.needsUpdate = true;
  } else {
    // A copy, since the next mesh is written over it while this one may be shown again.
    geometry.setAttribute(name, new BufferAttribute(array.slice(), itemSize));
  }
}

/** @param {BufferGeometry} geometry @param {Uint32Array} index */
function setIndex(geometry, index) {
  const current = geometry.getIndex();
  if (current?.array === index) return;
  if (!current || current.array.length !== index.length || index.some((value, i) => value !== current.array[i])) {
    geometry.setIndex(new BufferAttribute(index, 1));
  }
}

/**
 * @param {BufferGeometry} geometry
 * @param {number} vertices
 */
function disposeIfChanged(geometry, vertices) {
  const position = geometry.getAttribute('position');
  if (position && position.count !== vertices) geometry.dispose();
}

/**
 * Sets the limit surface: triangles with normals and curvatures. Those that are free are drawn with the first material,
 * those that are held with the second.
 * @param {BufferGeometry} geometry
 * @param {Mesh} mesh
 * @param {Uint8Array | null} [held] 1 for each held face of the cage; null if nothing is held
 * @returns {Uint32Array} the rim of what is held, two vertices for each edge
 */
export function setSurface(geometry, mesh, held = null) {
  disposeIfChanged(geometry, mesh.positions.length / 3);
  makeFinite(mesh.curvatures);
  setAttribute(geometry, 'position', mesh.positions, 3);
  setAttribute(geometry, 'normal', mesh.normals, 3);
  setAttribute(geometry, 'curvature', mesh.curvatures, 2);
  const rim = setParts(geometry, mesh, held);
  geometry.computeBoundingSphere();
  return rim;
}

/**
 * Sets what is computed of each vertex; without, all are 0.
 * @param {BufferGeometry} geometry
 * @param {Float32Array | null} computed changed in place where it is not finite
 */
export function setComputed(geometry, computed) {
  if (!computed) return void geometry.deleteAttribute('computed');
  makeFinite(computed);
  setAttribute(geometry, 'computed', computed, 1);
}

/**
 * Sets which triangles of the surface are held.
 * @param {BufferGeometry} geometry
 * @param {Mesh} mesh
 * @param {Uint8Array | null} held
 * @returns {Uint32Array} the rim
 */
export function setParts(geometry, mesh, held) {
  const { triangles, free, rim } = splitHeld(mesh, held);
  setIndex(geometry, triangles);
  geometry.clearGroups();
  geometry.addGroup(0, free, 0);
  if (free < triangles.length) geometry.addGroup(free, triangles.length - free, 1);
  return rim;
}

/**
 * Sets the control cage: its edges.
 * @param {BufferGeometry} geometry
 * @param {Pick<Mesh, 'positions' | 'edges'>} mesh
 */
export function setEdges(geometry, mesh) {
  disposeIfChanged(geometry, mesh.positions.length / 3);
  setAttribute(geometry, 'position', mesh.positions, 3);
  setIndex(geometry, mesh.edges);
  geometry.computeBoundingSphere();
}

/**
 * Centre of the bounding box, and the largest distance of a vertex from it.
 * @param {Float32Array} positions
 * @returns {{centre: [number, number, number], radius: number}}
 */
export function extent(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const [x, y, z] = low.map((value, axis) => (value + high[axis]) / 2);
  let squared = 0;
  for (let i = 0; i < positions.length; i += 3) {
    squared = Math.max(squared, (positions[i] - x) ** 2 + (positions[i + 1] - y) ** 2 + (positions[i + 2] - z) ** 2);
  }
  return { centre: [x, y, z], radius: Math.sqrt(squared) };
}
