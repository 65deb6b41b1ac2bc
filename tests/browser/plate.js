// SPDX-License-Identifier: MIT
/**
 * @file An open cage with two boundaries, for tests of what is held at them: a wavy plate of quads with a hole.
 */

/** Quads along each side of the plate, and the first and last of those that are missing. */
const SIDE = 6;
const HOLE = [2, 3];

/**
 * As the text of an OBJ file: 32 faces, the first boundary of 24 vertices around them, and the second of 8 around the
 * hole. Vertex 25 is in the middle of the hole, and no face has it.
 * @returns {string}
 */
export function plate() {
  const steps = [...Array(SIDE + 1).keys()];
  const missing = (/** @type {number} */ i) => i >= HOLE[0] && i <= HOLE[1];
  /** @param {number} i @param {number} j */
  const number = (i, j) => j * (SIDE + 1) + i + 1;
  const vertices = steps.flatMap((j) =>
    steps.map((i) => `v ${i} ${(0.4 * Math.sin(i) * Math.cos(j)).toFixed(6)} ${j}`),
  );
  const faces = steps.slice(0, SIDE).flatMap((j) =>
    steps
      .slice(0, SIDE)
      .filter((i) => !(missing(i) && missing(j)))
      .map((i) => `f ${number(i, j)} ${number(i, j + 1)} ${number(i + 1, j + 1)} ${number(i + 1, j)}`),
  );
  return [...vertices, ...faces, ''].join('\n');
}
