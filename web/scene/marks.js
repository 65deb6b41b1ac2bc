// SPDX-License-Identifier: MIT
/**
 * @file What is drawn on the surface: the rim of what is held, a dot at each pin, and a boundary that is pointed at. Faint where the surface hides them.
 */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { LIFT, lift } from './lift.js';

/** @import {ColorRepresentation, Material} from 'three' */

/** Diameter of a pin's dot, in CSS pixels. */
const DOT = 11;
/** Width of the line along a marked boundary, in CSS pixels: it is drawn as dots, as lines are always of one pixel. */
const LINE = 5;
/** Dots on each edge of the mesh, so that they touch. */
const DOTS = 6;

/**
 * Points along edges, both ends included.
 * @param {BufferGeometry} surface whose positions the edges name
 * @param {Uint32Array} edges
 * @returns {Float32Array} 3 for each
 */
function dotsAlong(surface, edges) {
  const { array } = surface.getAttribute('position');
  const dots = [];
  for (let e = 0; e < edges.length; e += 2) {
    for (let k = 0; k <= DOTS; k++) {
      for (let axis = 0; axis < 3; axis++) {
        const [from, to] = [array[3 * edges[e] + axis], array[3 * edges[e + 1] + axis]];
        dots.push(from + ((to - from) * k) / DOTS);
      }
    }
  }
  return Float32Array.from(dots);
}

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

export function createMarks() {
  const rimGeometry = new BufferGeometry();
  const rimSeen = new LineBasicMaterial({ transparent: true, opacity: 0.75, toneMapped: false });
  rimSeen.onBeforeCompile = (shader) => lift(shader, LIFT.line);
  const rim = new LineSegments(rimGeometry, rimSeen);

  const pinGeometry = new BufferGeometry();
  const size = DOT * Math.min(window.devicePixelRatio, 2);
  const plain = { size, sizeAttenuation: false, transparent: true, toneMapped: false };
  const pinSeen = new PointsMaterial(plain);
  const pinHidden = new PointsMaterial({ ...plain, opacity: 0.3, depthTest: false });
  [pinSeen, pinHidden].forEach(asDiscs);
  const pins = [new Points(pinGeometry, pinHidden), new Points(pinGeometry, pinSeen)];

  const boundaryGeometry = new BufferGeometry();
  const line = { ...plain, size: LINE * Math.min(window.devicePixelRatio, 2) };
  const boundarySeen = new PointsMaterial(line);
  const boundaryHidden = new PointsMaterial({ ...line, opacity: 0.3, depthTest: false });
  [boundarySeen, boundaryHidden].forEach(asDiscs);
  const boundary = [new Points(boundaryGeometry, boundaryHidden), new Points(boundaryGeometry, boundarySeen)];
  for (const one of boundary) one.visible = false;

  const group = new Group();
  group.add(rim, ...boundary, ...pins);
  for (const object of group.children) object.frustumCulled = false;

  return {
    group,

    /** @param {BufferGeometry} surface whose positions the edges name @param {Uint32Array} edges */
    setRim(surface, edges) {
      rim.visible = edges.length > 0;
      if (!edges.length) return;
      rimGeometry.setAttribute('position', surface.getAttribute('position'));
      rimGeometry.setIndex(new BufferAttribute(edges, 1));
    },

    /** @param {BufferGeometry} surface whose positions the edges name @param {Uint32Array} edges */
    setBoundary(surface, edges) {
      for (const one of boundary) one.visible = edges.length > 0;
      if (!edges.length) return;
      boundaryGeometry.dispose();
      boundaryGeometry.setAttribute('position', new BufferAttribute(dotsAlong(surface, edges), 3));
    },

    /** @param {Float32Array} positions 3 for each pin */
    setPins(positions) {
      for (const one of pins) one.visible = positions.length > 0;
      pinGeometry.dispose();
      pinGeometry.setAttribute('position', new BufferAttribute(positions, 3));
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} dot */
    setColours(line, dot) {
      rimSeen.color.set(line);
      for (const material of [pinSeen, pinHidden, boundarySeen, boundaryHidden]) material.color.set(dot);
    },

    dispose() {
      rimGeometry.dispose();
      pinGeometry.dispose();
      boundaryGeometry.dispose();
      [rimSeen, pinSeen, pinHidden, boundarySeen, boundaryHidden].forEach((material) => material.dispose());
    },
  };
}
