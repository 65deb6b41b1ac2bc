// SPDX-License-Identifier: MIT
/**
 * @file Cages whose surfaces cross themselves.
 */

/** Two cubes with edges of length 2, as OBJ. @param {number} shift between their centres, along x */
export function cubes(shift) {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [(i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1]);
  const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'];
  const vertices = [0, shift].flatMap((x) => corners.map(([a, b, c]) => `v ${a + x} ${b} ${c}`));
  const polygons = [0, 8].flatMap((first) =>
    faces.map(
      (face) =>
        `f ${face
          .split(' ')
          .map((vertex) => Number(vertex) + first)
          .join(' ')}`,
    ),
  );
  return `${[...vertices, ...polygons].join('\n')}\n`;
}

/**
 * A tube whose cross section is a figure eight, around the z axis, as OBJ: it crosses itself in a circle of radius 4.
 * @param {number} m faces around the axis @param {number} n faces around the figure; even
 */
export function figureEightTube(m, n) {
  const vertices = Array.from({ length: m * n }, (_, i) => {
    const [u, v] = [(2 * Math.PI * Math.floor(i / n)) / m, (2 * Math.PI * (i % n)) / n];
    const out = 4 + 2 * Math.sin(v);
    return `v ${out * Math.cos(u)} ${out * Math.sin(u)} ${Math.sin(2 * v)}`;
  });
  const at = (/** @type {number} */ i, /** @type {number} */ j) => 1 + (i % m) * n + (j % n);
  const faces = Array.from({ length: m * n }, (_, i) => {
    const [u, v] = [Math.floor(i / n), i % n];
    return `f ${at(u, v)} ${at(u + 1, v)} ${at(u + 1, v + 1)} ${at(u, v + 1)}`;
  });
  return `${[...vertices, ...faces].join('\n')}\n`;
}
