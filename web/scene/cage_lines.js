// SPDX-License-Identifier: MIT
/** @file The edges of a cage: plain where visible, faint where the surface hides them. */
import { BufferGeometry, Group, LineBasicMaterial, LineSegments } from 'three';
import { setEdges } from './geometry.js';

/** @import {ColorRepresentation} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */

/** What of a mesh its edges need. @typedef {Pick<Mesh, 'centre' | 'positions' | 'edges'>} Edges */

export function createCageLines() {
  const geometry = new BufferGeometry();
  const seen = new LineBasicMaterial({ transparent: true, opacity: 0.85, toneMapped: false });
  const hidden = new LineBasicMaterial({ transparent: true, opacity: 0.16, depthTest: false, toneMapped: false });
  const group = new Group();
  group.add(new LineSegments(geometry, hidden), new LineSegments(geometry, seen));
  group.visible = false;
  /** @type {Edges | null} */
  let shown = null;
  /** Of the surface, in the cage's coordinates. */
  let origin = /** @type {Float64Array} */ (new Float64Array(3));

  function place() {
    if (!shown) return;
    const [x, y, z] = shown.centre.map((value, axis) => value - origin[axis]);
    group.position.set(x, y, z);
  }

  return {
    group,
    /** @param {Edges | null} mesh null hides it */
    set(mesh) {
      group.visible = mesh !== null;
      if (!mesh || mesh === shown) return;
      shown = mesh;
      setEdges(geometry, mesh);
      place();
    },
    /** @param {Float64Array} next */
    move(next) {
      origin = next;
      place();
    },
    /** @param {ColorRepresentation} colour */
    paint: (colour) => [seen, hidden].forEach((material) => material.color.set(colour)),
    dispose: () => [geometry, seen, hidden].forEach((one) => one.dispose()),
  };
}
