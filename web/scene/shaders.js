// SPDX-License-Identifier: MIT
/**
 * @file What is added to three.js' shader of the surface: the quantity that colours it, its isolines, and the patterns
 * that follow the viewer. All lines are as wide as a pixel or two at any zoom, by screen-space derivatives.
 */
import { MAP_SIZE } from '../colour/maps.js';
import { allQuantities } from '../colour/quantities.js';

/** @import {Pattern} from '../colour/quantities.js' */

/** From pole to pole of the mirrored surroundings, or of the light's. */
const STRIPES = 24;

/** The numbers by which the shader knows the patterns. @type {Record<Pattern, number>} */
export const PATTERNS = { stripes: 1, isophotes: 2 };

const cases = allQuantities.map(({ glsl }, i) => `if (which == ${i}) return ${glsl};`).join('\n  ');

const VERTEX_HEAD = `
attribute vec2 curvature;
attribute float computed;
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
uniform vec3 range;
uniform float isolines;
varying float vQuantity;
`;

/**
 * `range` has the values with the first, the middle and the last colour. Maps [0, 1] to the map's texel centres, which run from 0.5 to MAP_SIZE - 0.5. Isolines are at the multiples of `isolines`,
 * dark on light colours and light on dark ones; that of 0 is wider. Where they are finer than the pixels they fade.
 */
const FRAGMENT_COLOUR = `
#include <color_fragment>
if (which >= 0) {
  float side = vQuantity - range.y;
  float t = clamp(0.5 + 0.5 * side / (side < 0.0 ? range.y - range.x : range.z - range.y), 0.0, 1.0);
  diffuseColor.rgb = texture2D(colourMap, vec2((0.5 + t * ${(MAP_SIZE - 1).toFixed(1)}) / ${MAP_SIZE.toFixed(1)}, 0.5)).rgb;
}
if (which >= 0 && isolines > 0.0) {
  float lines = vQuantity / isolines;
  float pixel = fwidth(lines);
  float nearest = floor(lines + 0.5);
  float breadth = nearest == 0.0 ? 1.5 : 0.75;
  float line = 1.0 - smoothstep(breadth * pixel, (breadth + 0.75) * pixel, abs(lines - nearest));
  vec3 ink = vec3(dot(diffuseColor.rgb, vec3(0.2126, 0.7152, 0.0722)) > 0.12 ? 0.02 : 0.8);
  diffuseColor.rgb = mix(diffuseColor.rgb, ink, 0.7 * line * (1.0 - smoothstep(0.2, 0.5, pixel)));
}
`;

/**
 * Reflection stripes are what a mirror would show of surroundings with dark and light stripes about the picture's vertical;
 * isophotes are the places where a light at the viewer's upper left falls at equal angles. Both are as smooth as the
 * surface's normals, so a surface without a kink of its curvature has lines without a kink. Far from the eye, where they
 * are finer than the pixels, they fade to their mean.
 */
const FRAGMENT_PATTERNS = `
#include <normal_fragment_maps>
if (pattern > 0) {
  vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition);
  float cosine = pattern == ${PATTERNS.stripes} ? reflect(-toEye, normal).y : dot(normal, normalize(vec3(-0.9, 1.1, 1.2)));
  float phase = ${STRIPES.toFixed(1)} / PI * acos(clamp(cosine, -1.0, 1.0));
  float step = fwidth(phase);
  float light = smoothstep(0.5 - step, 0.5 + step, abs(2.0 * fract(phase) - 1.0));
  diffuseColor.rgb = mix(vec3(0.03), vec3(0.86), mix(light, 0.5, smoothstep(0.35, 0.7, step)));
}
`;

/** @typedef {{vertexShader: string, fragmentShader: string, uniforms: object}} Shader */

/** Colours a surface by a quantity, with isolines. @param {Shader} shader @param {object} uniforms */
export function addQuantity(shader, uniforms) {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = (VERTEX_HEAD + shader.vertexShader).replace(
    '#include <begin_vertex>',
    '#include <begin_vertex>\nvQuantity = quantityOf(curvature, computed);',
  );
  shader.fragmentShader = (FRAGMENT_HEAD + shader.fragmentShader).replace('#include <color_fragment>', FRAGMENT_COLOUR);
}

/** @param {Shader} shader @param {object} uniforms */
export function addPatterns(shader, uniforms) {
  Object.assign(shader.uniforms, uniforms);
  shader.fragmentShader = `uniform int pattern;\n${shader.fragmentShader}`.replace(
    '#include <normal_fragment_maps>',
    FRAGMENT_PATTERNS,
  );
}
