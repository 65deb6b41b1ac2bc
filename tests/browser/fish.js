// SPDX-License-Identifier: MIT
/**
 * @file A cage with groups, for tests of what is held: an ellipsoid of quads with a bump, whose front is its head.
 */

/** Squares along each edge of the cube that is blown up. */
const SQUARES = 4;

/**
 * As the text of an OBJ file, the faces of the head first. There are 96 faces, of which 32 are the head's.
 * @returns {string}
 */
export function fish() {
  /** @type {Map<string, number>} */
  const numbers = new Map();
  /** @type {string[]} */
  const vertices = [];
  /** @param {number[]} point on the cube [-1, 1]³ */
  function vertex(point) {
    const name = point.map((x) => Math.round(x * SQUARES)).join(' ');
    const known = numbers.get(name);
    if (known) return known;
    const length = Math.hypot(...point);
    const [x, y, z] = point.map((value) => value / length);
    const bump = 1 + 0.12 * Math.sin(5 * x + 1) * Math.cos(3 * y) + 0.06 * Math.sin(4 * z + x);
    vertices.push(`v ${[2.2 * x, 0.8 * bump * y + 0.1 * x, bump * z].map((value) => value.toFixed(6)).join(' ')}`);
    numbers.set(name, vertices.length);
    return vertices.length;
  }

  /** @type {{head: string[], body: string[]}} */
  const faces = { head: [], body: [] };
  for (const axis of [0, 1, 2]) {
    for (const side of [-1, 1]) {
      /** @param {number} i @param {number} j */
      const at = (i, j) => {
        const point = [0, 0, 0];
        point[axis] = side;
        point[(axis + 1) % 3] = (2 * i) / SQUARES - 1;
        point[(axis + 2) % 3] = side * ((2 * j) / SQUARES - 1);
        return point;
      };
      for (let i = 0; i < SQUARES; i++) {
        for (let j = 0; j < SQUARES; j++) {
          const corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
          const front = corners.reduce((sum, [x]) => sum + x, 0) / 4;
          faces[front > 0.5 ? 'head' : 'body'].push(`f ${corners.map(vertex).join(' ')}`);
        }
      }
    }
  }
  return [...vertices, 'g head', ...faces.head, 'g body', ...faces.body, ''].join('\n');
}
