// SPDX-License-Identifier: MIT
/**
 * @file The cage that is edited: its faces, through which the surface is seen, its edges and its vertices, with what is
 * selected of them in the accent colour; and what of it is under a point of the picture.
 */
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  PointsMaterial,
} from 'three';
import { createCageLines } from './cage_lines.js';
import { asDiscs } from './broad_line.js';
import { createPointing } from './pointing.js';

/** @import {Camera, ColorRepresentation} from 'three' */
/** @import * as core from '../../wasm/types.js' */

/** Diameters of the dots, in CSS pixels. */
const [DOT, SELECTED_DOT] = [6, 11];
/** How near to a vertex a press takes it, in CSS pixels. */
const REACH = 12;

/** A cage, with points in the coordinates of the file, and what is selected of it. @typedef {object} EditedCage
 * @property {Array<[number, number, number]>} points
 * @property {number[][]} faces
 * @property {{points: number[], faces: number[]}} selection
 */

/** The middle of the box around some points. @param {EditedCage['points']} points */
function middleOf(points) {
  const ends = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of points) [low, high] = [Math.min(low, point[axis]), Math.max(high, point[axis])];
    return (low + high) / 2;
  });
  return Float64Array.from(ends);
}

/** Its faces as fans of triangles, and its edges once. @param {EditedCage} cage @returns {core.Mesh} */
function meshOf({ points, faces }) {
  const centre = middleOf(points);
  const positions = Float32Array.from(points.flatMap((point) => point.map((x, axis) => x - centre[axis])));
  const triangles = faces.flatMap((face) => face.slice(2).flatMap((_, i) => [face[0], face[i + 1], face[i + 2]]));
  const owners = faces.flatMap((face, f) => Array(face.length - 2).fill(f));
  /** @type {Map<string, [number, number]>} */
  const edges = new Map();
  for (const face of faces) {
    face.forEach((from, i) => {
      const to = face[(i + 1) % face.length];
      edges.set(from < to ? `${from} ${to}` : `${to} ${from}`, [from, to]);
    });
  }
  return {
    centre,
    positions,
    normals: new Float32Array(0),
    curvatures: new Float32Array(0),
    triangles: Uint32Array.from(triangles),
    faces: Uint32Array.from(owners),
    edges: Uint32Array.from([...edges.values()].flat()),
  };
}

/** A sheet that hides nothing. @param {number} opacity */
const sheet = (opacity) =>
  new MeshBasicMaterial({
    transparent: true,
    opacity,
    side: DoubleSide,
    depthWrite: false,
    toneMapped: false,
    // Nearer than a part of the surface that is as flat as the cage.
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -8,
  });

/** @param {number} diameter in CSS pixels @param {boolean} through whether the surface does not hide them */
function dots(diameter, through) {
  const size = diameter * Math.min(window.devicePixelRatio, 2);
  const material = new PointsMaterial({ size, sizeAttenuation: false, transparent: true, toneMapped: false });
  material.depthTest = !through;
  asDiscs(material);
  return material;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {() => Camera} camera
 */
export function createEdited(canvas, camera) {
  const materials = {
    face: sheet(0.07),
    selected: sheet(0.42),
    dot: dots(DOT, false),
    chosen: dots(SELECTED_DOT, true),
  };
  const [faces, selected, points, chosen] = Array.from({ length: 4 }, () => new BufferGeometry());
  const lines = createCageLines();
  const body = new Group();
  body.add(
    new Mesh(faces, materials.face),
    new Mesh(selected, materials.selected),
    new Points(points, materials.dot),
    new Points(chosen, materials.chosen),
  );
  for (const object of body.children) object.frustumCulled = false;
  const group = new Group();
  group.add(body, lines.group);
  group.visible = false;
  const pointing = createPointing(body, camera);
  /** @type {core.Mesh | null} */
  let mesh = null;
  /** Of the surface, in the coordinates of the file. */
  let origin = /** @type {Float64Array} */ (new Float64Array(3));

  function place() {
    lines.move(origin);
    const [x, y, z] = mesh ? mesh.centre.map((value, axis) => value - origin[axis]) : [0, 0, 0];
    body.position.set(x, y, z);
  }

  /** @param {BufferGeometry} geometry @param {BufferAttribute} position @param {number[] | Uint32Array} index */
  function fill(geometry, position, index) {
    geometry.dispose();
    geometry.setAttribute('position', position);
    geometry.setIndex(new BufferAttribute(Uint32Array.from(index), 1));
  }

  /** The distance of a vertex from a point of the picture, in CSS pixels. @param {number} vertex @param {number} x @param {number} y */
  function distanceTo(vertex, x, y) {
    const [px, py] = pointing.place(vertex);
    return Math.hypot((px - x) * canvas.clientWidth, (py - y) * canvas.clientHeight);
  }

  /** All vertices. */
  const vertices = () => (mesh ? Array.from({ length: mesh.positions.length / 3 }, (_, v) => v) : []);

  return {
    group,

    /** @param {EditedCage | null} cage null hides it */
    set(cage) {
      group.visible = cage !== null;
      mesh = cage && meshOf(cage);
      lines.set(mesh);
      if (!cage || !mesh) return;
      pointing.set(mesh);
      const position = new BufferAttribute(mesh.positions, 3);
      const own = new Set(cage.selection.faces);
      /** @type {[number[], number[]]} */
      const parts = [[], []];
      mesh.faces.forEach((f, t) =>
        parts[own.has(f) ? 1 : 0].push(...(mesh?.triangles.subarray(3 * t, 3 * t + 3) ?? [])),
      );
      fill(faces, position, parts[0]);
      fill(selected, position, parts[1]);
      fill(points, position, vertices());
      fill(chosen, position, cage.selection.points);
      place();
    },

    /** The surface has another origin. @param {Float64Array} next in the coordinates of the file */
    move(next) {
      origin = next;
      place();
    },

    /**
     * What is under a point of the picture: a vertex of the face there, if one is near, or the face; beside the cage, a vertex.
     * @param {number} x
     * @param {number} y
     * @returns {{what: 'points' | 'faces', number: number} | null} the number from 0
     */
    at(x, y) {
      if (!group.visible || !mesh) return null;
      const cell = pointing.cell(x, y, mesh.positions.length / 3);
      if (cell) {
        const near = cell.vertex >= 0 && distanceTo(cell.vertex, x, y) <= REACH;
        return near ? { what: 'points', number: cell.vertex } : { what: 'faces', number: cell.face };
      }
      const distances = vertices().map((v) => distanceTo(v, x, y));
      const nearest = distances.reduce((best, one, v) => (one < (distances[best] ?? Infinity) ? v : best), -1);
      return distances[nearest] <= REACH ? { what: 'points', number: nearest } : null;
    },

    /** The vertices inside a box of the picture. @param {number[]} from @param {number[]} to two opposite corners */
    inBox(from, to) {
      const [low, high] = [Math.min, Math.max].map((pick) => from.map((one, i) => pick(one, to[i])));
      return vertices().filter((v) => pointing.place(v).every((one, i) => one >= low[i] && one <= high[i]));
    },

    /** @param {ColorRepresentation} line @param {ColorRepresentation} accent of what is selected */
    setColours(line, accent) {
      lines.paint(line);
      for (const material of [materials.face, materials.dot]) material.color.set(line);
      for (const material of [materials.selected, materials.chosen]) material.color.set(accent);
    },

    dispose() {
      [faces, selected, points, chosen, ...Object.values(materials)].forEach((one) => one.dispose());
      lines.dispose();
    },
  };
}
