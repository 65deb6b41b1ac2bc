// SPDX-License-Identifier: MIT
/**
 * @file Limit meshes as STL, for printing, and as GLB, for viewing. Imports three.js, so pages import this file only on
 * demand.
 */
import { BufferAttribute, BufferGeometry, Mesh as Model, MeshStandardMaterial } from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';

/** @import {Mesh} from '../../wasm/types.js' */

/** The largest extent of a model in the units of its format: millimetres in STL, metres in GLB. */
export const STL_EXTENT = 100;
export const GLB_EXTENT = 1;

/** @param {Mesh} mesh @param {number} size the largest extent @returns {Model} centred at the origin */
function model(mesh, size) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions.slice(), 3));
  geometry.setAttribute('normal', new BufferAttribute(mesh.normals.slice(), 3));
  geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
  geometry.center();
  geometry.computeBoundingBox();
  const box = geometry.boundingBox;
  const extent = box ? Math.max(...box.max.clone().sub(box.min).toArray()) : 0;
  if (extent > 0) geometry.scale(size / extent, size / extent, size / extent);
  return new Model(geometry, new MeshStandardMaterial({ color: 0xd9d2c5, roughness: 0.5, metalness: 0 }));
}

/** Binary STL, z upwards. @param {Mesh} mesh @returns {ArrayBuffer} */
export function stl(mesh) {
  const view = new STLExporter().parse(model(mesh, STL_EXTENT), { binary: true });
  return /** @type {ArrayBuffer} */ (view.buffer);
}

/** Binary glTF 2.0, in which y is upwards. @param {Mesh} mesh @param {string} name @returns {Promise<ArrayBuffer>} */
export async function glb(mesh, name) {
  const object = model(mesh, GLB_EXTENT);
  object.geometry.rotateX(-Math.PI / 2);
  object.name = name;
  return /** @type {ArrayBuffer} */ (await new GLTFExporter().parseAsync(object, { binary: true }));
}
