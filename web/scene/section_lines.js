// SPDX-License-Identifier: MIT
/**
 * @file The curves of a section with their curvature comb: teeth along the normals within the plane, as long as the curvature
 * says, and a line through their ends.
 */
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Plane, Vector3 } from 'three';
import { createBroadLines } from './broad_line.js';
import { extent } from './geometry.js';
import { combOf, planeAcross, sectionOf } from './section.js';

/** @import {ColorRepresentation} from 'three' */
/** @import {Mesh} from '../../wasm/types.js' */
/** @import {Comb, Curve, Triple} from './section.js' */

/**
 * The plane across a direction, from one end of the surface (-1) to the other (1), and the length of the teeth from 0 to 1.
 * @typedef {{direction: Triple, position: number, comb: number, cut: boolean}} Cut
 */
/** The number of curves, and their curvatures in 1/length. @typedef {{curves: number, least: number, largest: number}} CutFound */

/** Between two teeth, in radii of the surface. */
const SPACING = 0.015;
const FEWEST_TEETH = 24;
const MOST_TEETH = 800;
/** The length of all but a few teeth is at most this at the largest setting, in radii. */
const LONGEST = 0.5;
const ALL_BUT_A_FEW = 0.95;

/** Consecutive points as segments. @param {Triple[]} points @param {boolean} closed @returns {number[]} */
const joined = (points, closed) =>
  points.flatMap((point, i) =>
    i > 0 ? [...points[i - 1], ...point] : closed ? [...(points.at(-1) ?? []), ...point] : [],
  );

/** @param {Curve} curve @param {Triple} normal @param {number} radius @returns {Comb} */
function combAlong(curve, normal, radius) {
  const { points } = curve;
  const length = points.slice(1).reduce((sum, p, i) => sum + Math.hypot(...p.map((x, axis) => x - points[i][axis])), 0);
  const teeth = Math.round(length / (SPACING * radius));
  return combOf(curve, normal, Math.min(MOST_TEETH, Math.max(FEWEST_TEETH, teeth)));
}

/** A power of two that few curvatures exceed, so that the comb's scale rarely changes while the surface moves. @param {number[]} curvatures */
function typical(curvatures) {
  const sizes = curvatures.map(Math.abs).sort((a, b) => a - b);
  const large = sizes[Math.floor(ALL_BUT_A_FEW * (sizes.length - 1))];
  return large > 0 ? 2 ** Math.ceil(Math.log2(large)) : 1;
}

export function createSectionLines() {
  const broad = createBroadLines(1);
  const [curve] = broad.lines;
  const combGeometry = new BufferGeometry();
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.7, toneMapped: false });
  const comb = new LineSegments(combGeometry, material);
  const group = new Group();
  group.add(...curve.points, comb);
  for (const object of group.children) object.frustumCulled = false;
  group.visible = false;
  /** What is before it is cut away: its normal points to what stays. */
  const plane = new Plane();

  return {
    group,
    /** In the coordinates of the mesh. */
    plane,

    /**
     * @param {Mesh} mesh
     * @param {Cut | null} cut null hides it
     * @returns {CutFound | null}
     */
    set(mesh, cut) {
      group.visible = cut !== null;
      if (!cut) return null;
      const { radius } = extent(mesh.positions);
      const across = planeAcross(mesh, cut.direction, cut.position);
      plane.set(new Vector3(...across.normal).negate(), across.offset);
      const curves = sectionOf(mesh, across);
      const combs = curves.map((one) => combAlong(one, across.normal, radius));
      const all = combs.flatMap(({ curvatures }) => curvatures);
      const scale = (LONGEST * cut.comb * radius) / typical(all);
      const lines = combs.flatMap(({ points, normals, curvatures, closed }) => {
        const ends = points.map(
          (point, i) => /** @type {Triple} */ (point.map((x, axis) => x + scale * curvatures[i] * normals[i][axis])),
        );
        return [...points.flatMap((point, i) => [...point, ...ends[i]]), ...joined(ends, closed)];
      });
      curve.set(Float32Array.from(curves.flatMap(({ points, closed }) => joined(points, closed))));
      comb.visible = cut.comb > 0 && lines.length > 0;
      combGeometry.dispose();
      combGeometry.setAttribute('position', new BufferAttribute(Float32Array.from(lines), 3));
      const [least, largest] = all.reduce(
        ([low, high], k) => [Math.min(low, k), Math.max(high, k)],
        [Infinity, -Infinity],
      );
      return { curves: curves.length, least, largest };
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} accent */
    setColours(line, accent) {
      material.color.set(line);
      broad.paint(accent);
    },

    dispose: () => [broad, combGeometry, material].forEach((one) => one.dispose()),
  };
}
