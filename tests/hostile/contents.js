// SPDX-License-Identifier: MIT
/**
 * @file Makes the cages of the tables of hostile inputs: OBJ texts of nets and of what is wrong with them, and files in bytes.
 */

/** @typedef {[number, number, number]} Point */

/** @param {Point[]} points @param {number[][]} faces with indices from 1 @returns {string} OBJ */
export const obj = (points, faces) =>
  [...points.map((p) => `v ${p.join(' ')}`), ...faces.map((f) => `f ${f.join(' ')}`), ''].join('\n');

export const tetrahedron = 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n';

/** A tetrahedron with other lines for its first vertex or its last face. */
export const withVertex = (/** @type {string} */ line) => tetrahedron.replace('v 1 1 1', line);
export const withFace = (/** @type {string} */ line) => tetrahedron.replace('f 2 4 3', line);

export const tetrahedronFaces = [
  [1, 2, 3],
  [1, 3, 4],
  [1, 4, 2],
  [2, 4, 3],
];

/** @param {number} count @returns {number[]} 0, 1, …, count - 1 */
export const range = (count) => [...Array(count).keys()];

/** @param {number} x @param {number} y @param {number} z @returns {string} with these edges, around the origin */
export function box(x, y, z) {
  const points = range(8).map(
    (i) => /** @type {Point} */ ([x * ((i & 1) - 0.5), (y * ((i & 2) - 1)) / 2, (z * ((i & 4) - 2)) / 4]),
  );
  return obj(points, [
    [1, 3, 4, 2],
    [5, 6, 8, 7],
    [1, 2, 6, 5],
    [2, 4, 8, 6],
    [4, 3, 7, 8],
    [3, 1, 5, 7],
  ]);
}

export const cube = box(2, 2, 2);

/** Two apexes over an n-gon of radius 1. @param {number} n @param {number} height */
export function bipyramid(n, height) {
  const ring = range(n).map(
    (i) => /** @type {Point} */ ([Math.cos((2 * Math.PI * i) / n), Math.sin((2 * Math.PI * i) / n), 0]),
  );
  const faces = range(n).flatMap((i) => [
    [i + 1, ((i + 1) % n) + 1, n + 1],
    [((i + 1) % n) + 1, i + 1, n + 2],
  ]);
  return obj([...ring, [0, 0, height], [0, 0, -height]], faces);
}

/**
 * A net of quads on a rectangle whose opposite sides are joined: around a torus, or, with a twist, as a Klein bottle.
 * @param {number} m @param {number} n @param {{ratio?: number, twisted?: boolean}} [options]
 */
export function torus(m, n, { ratio = 0.5, twisted = false } = {}) {
  const points = range(m * n).map((i) => {
    const [u, v] = [(2 * Math.PI * Math.floor(i / n)) / m, (2 * Math.PI * (i % n)) / n];
    const r = 1 + ratio * Math.cos(v);
    return /** @type {Point} */ ([r * Math.cos(u), r * Math.sin(u), ratio * Math.sin(v)]);
  });
  /** @param {number} i @param {number} j */
  const at = (i, j) => (i === m ? (twisted ? (n - (j % n)) % n : j % n) : i * n + (j % n)) + 1;
  return obj(
    points,
    range(m * n).map((k) => {
      const [i, j] = [Math.floor(k / n), k % n];
      return [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    }),
  );
}

/** A band of n quads, whose ends are joined with a twist. @param {number} n */
export function moebius(n) {
  const points = range(2 * n).map((i) => {
    const [u, side] = [(2 * Math.PI * Math.floor(i / 2)) / n, (i % 2) - 0.5];
    const r = 2 + side * Math.cos(u / 2);
    return /** @type {Point} */ ([r * Math.cos(u), r * Math.sin(u), side * Math.sin(u / 2)]);
  });
  const faces = range(n).map((i) =>
    i + 1 < n ? [2 * i + 1, 2 * i + 2, 2 * i + 4, 2 * i + 3] : [2 * i + 1, 2 * i + 2, 1, 2],
  );
  return obj(points, faces);
}

/** A flat net of m times n squares, open. @param {number} m @param {number} n @param {(i: number, j: number) => boolean} [keeps] */
export function sheet(m, n, keeps = () => true) {
  const points = range((m + 1) * (n + 1)).map((k) => /** @type {Point} */ ([Math.floor(k / (n + 1)), k % (n + 1), 0]));
  /** @param {number} i @param {number} j */
  const at = (i, j) => i * (n + 1) + j + 1;
  const faces = range(m * n)
    .map((k) => [Math.floor(k / n), k % n])
    .filter(([i, j]) => keeps(i, j))
    .map(([i, j]) => [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
  return obj(points, faces);
}

/** @param {string} text OBJ @param {(point: Point, index: number) => Point} map */
export function moved(text, map) {
  let index = 0;
  return text.replace(/^v (.*)$/gm, (_, words) => `v ${map(words.split(' ').map(Number), index++).join(' ')}`);
}

/** Both in one file. @param {string} first OBJ @param {string} second OBJ */
export function both(first, second) {
  const count = (first.match(/^v /gm) ?? []).length;
  const shifted = second.replace(
    /^f (.*)$/gm,
    (_, words) =>
      `f ${words
        .split(' ')
        .map((/** @type {string} */ w) => Number(w) + count)
        .join(' ')}`,
  );
  return first + shifted;
}

/** Numbers from 0 to 1 that are the same each time. @param {number} seed */
export function randomNumbers(seed) {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** Any bytes. @param {number} count @param {number} [seed] @returns {Uint8Array} */
export function junk(count, seed = 1) {
  const random = randomNumbers(seed);
  return Uint8Array.from(range(count), () => Math.floor(256 * random()));
}

const encoder = new TextEncoder();

/** @param {...(string | Uint8Array | number[])} parts @returns {Uint8Array} */
export function bytes(...parts) {
  return Uint8Array.from(parts.flatMap((part) => [...(typeof part === 'string' ? encoder.encode(part) : part)]));
}

/** UTF-16 with its byte-order mark. @param {string} text @param {boolean} little @returns {Uint8Array} */
export const utf16 = (text, little) =>
  Uint8Array.from(
    [...`\uFEFF${text}`].flatMap((c) => {
      const code = c.charCodeAt(0);
      return little ? [code & 255, code >> 8] : [code >> 8, code & 255];
    }),
  );

/** A tetrahedron as OFF with other first lines, vertices or faces. */
export const off = ({
  head = 'OFF\n4 4 6',
  vertices = '1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1',
  faces = '3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2',
} = {}) => `${head}\n${vertices}\n${faces}\n`;

/** A tetrahedron as PLY text. */
export const ply = ({
  format = 'format ascii 1.0',
  vertex = 'element vertex 4\nproperty float x\nproperty float y\nproperty float z',
  face = 'element face 4\nproperty list uchar int vertex_indices',
  end = 'end_header',
  body = '1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n',
} = {}) => `ply\n${[format, vertex, face, end].filter(Boolean).join('\n')}\n${body}`;

/**
 * A tetrahedron as binary PLY, whose first index and first coordinate may be others.
 * @param {{big?: boolean, index?: number, x?: number, cut?: number, more?: number, length?: number}} [options]
 * `cut` bytes are missing at the end, or `more` follow it; `length` is that of the first face's list
 */
export function binaryPly({ big = false, index = 0, x = 1, cut = 0, more = 0, length = 3 } = {}) {
  const header = encoder.encode(
    `ply\nformat binary_${big ? 'big' : 'little'}_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n` +
      'property double z\nelement face 4\nproperty list uint int vertex_indices\nend_header\n',
  );
  const body = new DataView(new ArrayBuffer(4 * 24 + 4 * 16));
  const points = [x, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1];
  points.forEach((value, i) => body.setFloat64(8 * i, value, !big));
  tetrahedronFaces.forEach((face, f) => {
    body.setUint32(96 + 16 * f, f === 0 ? length : 3, !big);
    face.forEach((v, k) => body.setInt32(100 + 16 * f + 4 * k, f === 0 && k === 0 ? index : v - 1, !big));
  });
  const all = bytes(header, new Uint8Array(body.buffer), new Uint8Array(more));
  return all.subarray(0, all.length - cut);
}
