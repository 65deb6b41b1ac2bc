// SPDX-License-Identifier: MIT
/**
 * @file The surface's material: a soft ceramic, coloured per vertex from the principal curvatures or the deviation through a colour map,
 * or striped by what it would mirror. What is held has another, in grey.
 */
import { Color, DataTexture, DoubleSide, LinearFilter, MeshStandardMaterial, SRGBColorSpace } from 'three';
import { MAP_SIZE, mapBytes } from '../colour/maps.js';
import { allQuantities } from '../colour/quantities.js';

/** @import {MapName} from '../colour/maps.js' */
/** @import {Quantity} from '../colour/quantities.js' */
/** @import {Range} from '../colour/range.js' */

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

const cases = allQuantities.map(({ glsl }, i) => `if (which == ${i}) return ${glsl};`).join('\n  ');

const VERTEX_HEAD = `
attribute vec2 curvature;
attribute float deviation;
uniform int which;
varying float vQuantity;
float quantityOf(vec2 k, float d) {
  ${cases}
  return 0.0;
}
`;

const FRAGMENT_HEAD = `
uniform int which;
uniform sampler2D colourMap;
uniform vec2 range;
varying float vQuantity;
`;

/** Maps [0, 1] to the map's texel centres, which run from 0.5 to MAP_SIZE - 0.5. */
const FRAGMENT_COLOUR = `
#include <color_fragment>
if (which >= 0) {
  float t = clamp((vQuantity - range.x) / (range.y - range.x), 0.0, 1.0);
  diffuseColor.rgb = texture2D(colourMap, vec2((0.5 + t * ${(MAP_SIZE - 1).toFixed(1)}) / ${MAP_SIZE.toFixed(1)}, 0.5)).rgb;
}
`;

/** From pole to pole of the mirrored surroundings. */
const STRIPES = 24;

/**
 * Reflection stripes: what a mirror would show of surroundings with dark and light stripes about the picture's vertical. They are as smooth
 * as the surface's normals, so a surface without a kink of its curvature has stripes without a kink. Far from the eye, where
 * they are finer than the pixels, they fade to their mean.
 */
const FRAGMENT_STRIPES = `
#include <normal_fragment_maps>
if (striped) {
  vec3 mirrored = reflect(-normalize(vViewPosition), normal);
  float phase = ${STRIPES.toFixed(1)} / PI * acos(clamp(mirrored.y, -1.0, 1.0));
  float step = fwidth(phase);
  float light = smoothstep(0.5 - step, 0.5 + step, abs(2.0 * fract(phase) - 1.0));
  diffuseColor.rgb = mix(vec3(0.03), vec3(0.86), mix(light, 0.5, smoothstep(0.35, 0.7, step)));
}
`;

/** @param {{fragmentShader: string, uniforms: object}} shader @param {object} uniforms */
function addStripes(shader, uniforms) {
  Object.assign(shader.uniforms, uniforms);
  shader.fragmentShader = `uniform bool striped;\n${shader.fragmentShader}`.replace(
    '#include <normal_fragment_maps>',
    FRAGMENT_STRIPES,
  );
}

/**
 * @returns {{material: MeshStandardMaterial, held: MeshStandardMaterial, shade: (quantity: Quantity | null, range: Range | null, striped?: boolean) => void,
 *   dispose: () => void}}
 */
export function createSurfaceMaterial() {
  const textures = { diverging: mapTexture('diverging'), sequential: mapTexture('sequential') };
  const uniforms = {
    which: { value: -1 },
    colourMap: { value: textures.diverging },
    range: { value: [-1, 1] },
  };
  const stripes = { striped: { value: false } };
  const material = new MeshStandardMaterial({ color: PLAIN, roughness: 0.52, metalness: 0, side: DoubleSide });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = (VERTEX_HEAD + shader.vertexShader).replace(
      '#include <begin_vertex>',
      '#include <begin_vertex>\nvQuantity = quantityOf(curvature, deviation);',
    );
    shader.fragmentShader = (FRAGMENT_HEAD + shader.fragmentShader).replace(
      '#include <color_fragment>',
      FRAGMENT_COLOUR,
    );
    addStripes(shader, stripes);
  };
  const held = new MeshStandardMaterial({ color: HELD, roughness: 0.7, metalness: 0, side: DoubleSide });
  held.onBeforeCompile = (shader) => addStripes(shader, stripes);
  return {
    material,
    held,
    shade(quantity, range, striped = false) {
      stripes.striped.value = striped;
      uniforms.which.value = quantity && range ? allQuantities.indexOf(quantity) : -1;
      if (!quantity || !range) return;
      uniforms.colourMap.value = textures[quantity.map];
      uniforms.range.value = [range.low, range.high];
    },
    dispose() {
      material.dispose();
      held.dispose();
      Object.values(textures).forEach((texture) => texture.dispose());
    },
  };
}
