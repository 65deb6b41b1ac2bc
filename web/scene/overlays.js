// SPDX-License-Identifier: MIT
/**
 * @file Lines that can be shown over the surface: the control cage, the cage that it began from, and the edges of its
 * patches. Plain where visible; cages are faint where the surface hides them.
 */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from 'three';
import { createCageLines } from './cage_lines.js';
import { LIFT, lift } from './lift.js';
import { patchEdges } from './patches.js';

/** @import {ColorRepresentation} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */

/** @param {BufferGeometry} surface whose vertices the patches have */
function createPatches(surface) {
  const geometry = new BufferGeometry();
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.45, toneMapped: false });
  material.onBeforeCompile = (shader) => lift(shader, LIFT.line);
  const lines = new LineSegments(geometry, material);
  lines.visible = false;
  lines.frustumCulled = false;
  /** The triangles whose edges are known. @type {Uint32Array | null} */
  let known = null;
  return {
    lines,
    /** @param {Mesh | null} mesh null hides them @param {number} density */
    set(mesh, density) {
      lines.visible = mesh !== null;
      if (!mesh) return;
      if (mesh.triangles !== known) geometry.setIndex(new BufferAttribute(patchEdges(mesh, density), 1));
      known = mesh.triangles;
      geometry.setAttribute('position', surface.getAttribute('position'));
    },
    material,
    dispose: () => [geometry, material].forEach((one) => one.dispose()),
  };
}

/** @param {BufferGeometry} surface */
export function createOverlays(surface) {
  const control = createCageLines();
  const original = createCageLines();
  const patches = createPatches(surface);
  const group = new Group();
  group.add(control.group, original.group, patches.lines);
  return {
    group,
    /** The material of the edges of patches. */
    patches: patches.material,
    setControl: control.set,
    setOriginal: original.set,
    setPatches: patches.set,

    /** The surface has another origin. @param {Float64Array} origin in the cage's coordinates */
    move(origin) {
      control.move(origin);
      original.move(origin);
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} accent of the cage that the surface began from */
    setColours(line, accent) {
      control.paint(line);
      patches.material.color.set(line);
      original.paint(accent);
    },

    dispose: () => [control, original, patches].forEach((one) => one.dispose()),
  };
}
