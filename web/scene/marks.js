// SPDX-License-Identifier: MIT
/**
 * @file What is drawn on the surface: the rim of what is held, a dot at each pin, a boundary that is pointed at, and
 * the curves in which the surface crosses itself. Faint where the surface hides them.
 */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { LIFT, lift } from './lift.js';

/** @import {ColorRepresentation, Material} from 'three' */

/** Diameter of a pin's dot, in CSS pixels. */
const DOT = 11;
/** Width of the line along a marked boundary or a crossing, in CSS pixels: it is drawn as dots, as lines are always of one pixel. */
const LINE = 5;
/** Dots on each segment, so that they touch. */
const DOTS = 6;

/**
 * The segments of edges, 6 coordinates for each.
 * @param {BufferGeometry} surface whose positions the edges name
 * @param {Uint32Array} edges
 * @returns {Float32Array}
 */
function segmentsOf(surface, edges) {
  const { array } = surface.getAttribute('position');
  return Float32Array.from({ length: 3 * edges.length }, (_, i) => array[3 * edges[Math.floor(i / 3)] + (i % 3)]);
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

/** Draws dots as discs. @param {Material} material */
function asDiscs(material) {
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      '#include <color_fragment>',
      '#include <color_fragment>\nif (distance(gl_PointCoord, vec2(0.5)) > 0.5) discard;',
    );
    lift(shader, LIFT.dot);
  };
}

/** A broad line of dots along segments. @param {PointsMaterial[]} materials */
function createLine(materials) {
  const geometry = new BufferGeometry();
  const points = materials.map((material) => new Points(geometry, material));
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

  const line = { ...plain, size: LINE * Math.min(window.devicePixelRatio, 2) };
  const lineSeen = new PointsMaterial(line);
  const lineHidden = new PointsMaterial({ ...line, opacity: 0.3, depthTest: false });
  [lineSeen, lineHidden].forEach(asDiscs);
  const [boundary, crossings] = [0, 1].map(() => createLine([lineHidden, lineSeen]));

  const group = new Group();
  group.add(rim, ...boundary.points, ...crossings.points, ...pins);
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
    setBoundary: (surface, edges) => boundary.set(segmentsOf(surface, edges)),

    /** @param {Float32Array} segments 6 coordinates for each */
    setCrossings: (segments) => crossings.set(segments),

    /** @param {Float32Array} positions 3 for each pin */
    setPins(positions) {
      for (const one of pins) one.visible = positions.length > 0;
      pinGeometry.dispose();
      pinGeometry.setAttribute('position', new BufferAttribute(positions, 3));
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} dot */
    setColours(line, dot) {
      rimSeen.color.set(line);
      for (const material of [pinSeen, pinHidden, lineSeen, lineHidden]) material.color.set(dot);
    },

    dispose() {
      rimGeometry.dispose();
      pinGeometry.dispose();
      boundary.dispose();
      crossings.dispose();
      [rimSeen, pinSeen, pinHidden, lineSeen, lineHidden].forEach((material) => material.dispose());
    },
  };
}
