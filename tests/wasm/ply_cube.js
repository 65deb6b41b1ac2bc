// SPDX-License-Identifier: MIT
/**
 * @file A cube of side 2/3 as a binary PLY file, whose coordinates have no short decimals.
 */

const FACES = [
  [3, 2, 1, 0],
  [4, 5, 6, 7],
  [0, 1, 5, 4],
  [1, 2, 6, 5],
  [2, 3, 7, 6],
  [3, 0, 4, 7],
];

/** The same cube as OBJ, as the core writes it. */
export const objCube = () => {
  const signs = [-1, 1];
  const corners = signs.flatMap((z) =>
    signs.flatMap((y) => (y < 0 ? signs : [1, -1]).map((x) => [x / 3, y / 3, z / 3])),
  );
  const faces = FACES.map((face) => `f ${face.map((v) => v + 1).join(' ')}\n`);
  return corners.map(([x, y, z]) => `v ${x} ${y} ${z}\n`).join('') + faces.join('');
};

/** @param {number} [last] the last index of the last face @returns {Uint8Array} */
export function plyCube(last = 7) {
  const header =
    'ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n' +
    'element face 6\nproperty list uchar ushort vertex_indices\nend_header\n';
  const bytes = new Uint8Array(header.length + 8 * 24 + 6 * 9);
  bytes.set(new TextEncoder().encode(header));
  const view = new DataView(bytes.buffer, header.length);
  const coordinates =
    objCube()
      .match(/^v .*/gm)
      ?.flatMap((line) => line.slice(2).split(' ').map(Number)) ?? [];
  coordinates.forEach((x, i) => view.setFloat64(8 * i, x, true));
  FACES.forEach((face, f) => {
    const at = 8 * 24 + 9 * f;
    view.setUint8(at, 4);
    face.forEach((v, k) => view.setUint16(at + 1 + 2 * k, v, true));
  });
  view.setUint16(view.byteLength - 2, last, true);
  return bytes;
}
