// SPDX-License-Identifier: MIT
/**
 * @file The surface's material: a soft ceramic, coloured per vertex from the principal curvatures or what is computed through a colour map,
 * or with a pattern. What is held has another, in grey. The shaders are in shaders.js.
 */
import { Color, DataTexture, DoubleSide, LinearFilter, MeshStandardMaterial, SRGBColorSpace } from 'three';
import { MAP_SIZE, mapBytes } from '../colour/maps.js';
import { allQuantities } from '../colour/quantities.js';
import { isolineStep, middleOf } from '../colour/range.js';
import { PATTERNS, addPatterns, addQuantity } from './shaders.js';

/** @import {MapName} from '../colour/maps.js' */
/** @import {Pattern, Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

/**
 * How a surface is coloured: by a quantity with its range, with isolines or without, or by a pattern; plainly if all are null.
 * @typedef {{quantity: Quantity | null, range: Range | null, pattern?: Pattern | null, isolines?: boolean}} Shade
 */

/** The surface's colour if no quantity colours it. */
const PLAIN = new Color(0xd9d2c5);
/** The colour of what is held: a grey darker than any in the middle of a colour map. */
const HELD = new Color(0x92969c);

/** @param {MapName} name */
function mapTexture(name) {
  const texture = new DataTexture(mapBytes(name), MAP_SIZE, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/**
 * @returns {{material: MeshStandardMaterial, held: MeshStandardMaterial, shade: (shade: Shade) => void, dispose: () => void}}
 */
export function createSurfaceMaterial() {
  const textures = { diverging: mapTexture('diverging'), sequential: mapTexture('sequential') };
  const uniforms = {
    which: { value: -1 },
    colourMap: { value: textures.diverging },
    range: { value: [-1, 0, 1] },
    isolines: { value: 0 },
  };
  const patterns = { pattern: { value: 0 } };
  const material = new MeshStandardMaterial({ color: PLAIN, roughness: 0.52, metalness: 0, side: DoubleSide });
  material.onBeforeCompile = (shader) => {
    addQuantity(shader, uniforms);
    addPatterns(shader, patterns);
  };
  const held = new MeshStandardMaterial({ color: HELD, roughness: 0.7, metalness: 0, side: DoubleSide });
  held.onBeforeCompile = (shader) => addPatterns(shader, patterns);
  return {
    material,
    held,
    shade({ quantity, range, pattern = null, isolines = false }) {
      patterns.pattern.value = pattern ? PATTERNS[pattern] : 0;
      uniforms.which.value = quantity && range ? allQuantities.indexOf(quantity) : -1;
      if (!quantity || !range) return;
      uniforms.colourMap.value = textures[quantity.map];
      uniforms.range.value = [range.low, middleOf(quantity.signed, range), range.high];
      uniforms.isolines.value = isolines ? isolineStep(range) : 0;
    },
    dispose() {
      material.dispose();
      held.dispose();
      Object.values(textures).forEach((texture) => texture.dispose());
    },
  };
}
