// SPDX-License-Identifier: MIT
/**
 * @file Broad lines: rows of dots, as graphics hardware draws lines of one pixel only. Faint where the surface hides them.
 */
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from 'three';
import { LIFT, lift } from './lift.js';

/** @import {ColorRepresentation, Material} from 'three' */

/** Width in CSS pixels. */
const WIDTH = 5;
/** Dots on each segment, so that they touch. */
const DOTS = 6;

/** @param {number} size in CSS pixels */
export const dotOf = (size) => ({
  size: size * Math.min(window.devicePixelRatio, 2),
  sizeAttenuation: false,
  transparent: true,
  toneMapped: false,
});

/** Draws dots as discs. @param {Material} material */
export function asDiscs(material) {
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      '#include <color_fragment>',
      '#include <color_fragment>\nif (distance(gl_PointCoord, vec2(0.5)) > 0.5) discard;',
    );
    lift(shader, LIFT.dot);
  };
}

/**
 * Points along segments, both ends included.
 * @param {Float32Array} segments 6 coordinates for each
 * @returns {Float32Array} 3 for each
 */
function dotsAlong(segments) {
  const dots = new Float32Array(((DOTS + 1) * segments.length) / 2);
  let at = 0;
  for (let s = 0; s < segments.length; s += 6) {
    for (let k = 0; k <= DOTS; k++) {
      for (let axis = s; axis < s + 3; axis++) {
        dots[at++] = segments[axis] + ((segments[axis + 3] - segments[axis]) * k) / DOTS;
      }
    }
  }
  return dots;
}

/** Several broad lines of one colour. @param {number} count */
export function createBroadLines(count) {
  const seen = new PointsMaterial(dotOf(WIDTH));
  const hidden = new PointsMaterial({ ...dotOf(WIDTH), opacity: 0.3, depthTest: false });
  [seen, hidden].forEach(asDiscs);
  const lines = Array.from({ length: count }, () => {
    const geometry = new BufferGeometry();
    const points = [hidden, seen].map((material) => new Points(geometry, material));
    for (const one of points) one.visible = false;
    return {
      points,
      /** @param {Float32Array} segments 6 coordinates for each */
      set(segments) {
        for (const one of points) one.visible = segments.length > 0;
        if (!segments.length) return;
        geometry.dispose();
        geometry.setAttribute('position', new BufferAttribute(dotsAlong(segments), 3));
      },
      dispose: () => geometry.dispose(),
    };
  });
  return {
    lines,
    /** @param {ColorRepresentation} colour */
    paint: (colour) => [seen, hidden].forEach((material) => material.color.set(colour)),
    dispose: () => [...lines, seen, hidden].forEach((one) => one.dispose()),
  };
}
