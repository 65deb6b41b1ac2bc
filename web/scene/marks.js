// SPDX-License-Identifier: MIT
/**
 * @file What is drawn on the surface: the rim of what is held, a dot at each pin, a boundary that is pointed at, and
 * the curves in which the surface crosses itself. Faint where the surface hides them.
 */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { asDiscs, createBroadLines, dotOf } from './broad_line.js';
import { LIFT, lift } from './lift.js';

/** @import {ColorRepresentation} from 'three' */

/** Diameter of a pin's dot, in CSS pixels. */
const DOT = 11;
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

export function createMarks() {
  const rimGeometry = new BufferGeometry();
  const rimSeen = new LineBasicMaterial({ transparent: true, opacity: 0.75, toneMapped: false });
  rimSeen.onBeforeCompile = (shader) => lift(shader, LIFT.line);
  const rim = new LineSegments(rimGeometry, rimSeen);

  const pinGeometry = new BufferGeometry();
  const pinSeen = new PointsMaterial(dotOf(DOT));
  const pinHidden = new PointsMaterial({ ...dotOf(DOT), opacity: 0.3, depthTest: false });
  [pinSeen, pinHidden].forEach(asDiscs);
  const pins = [new Points(pinGeometry, pinHidden), new Points(pinGeometry, pinSeen)];

  const broad = createBroadLines(2);
  const [boundary, crossings] = broad.lines;

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

    /** @param {BufferGeometry} surface @param {Uint32Array} vertices of it, from 0, one for each pin */
    setPins(surface, vertices) {
      for (const one of pins) one.visible = vertices.length > 0;
      if (!vertices.length) return;
      pinGeometry.setAttribute('position', surface.getAttribute('position'));
      pinGeometry.setIndex(new BufferAttribute(vertices, 1));
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} dot */
    setColours(line, dot) {
      rimSeen.color.set(line);
      for (const material of [pinSeen, pinHidden]) material.color.set(dot);
      broad.paint(dot);
    },

    dispose() {
      rimGeometry.dispose();
      pinGeometry.dispose();
      broad.dispose();
      [rimSeen, pinSeen, pinHidden].forEach((material) => material.dispose());
    },
  };
}
