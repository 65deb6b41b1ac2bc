// SPDX-License-Identifier: MIT
/** @file Cages as OBJ text: round trips with all digits, what a mesh of the core stands for, and text that is refused. */
import { expect, test } from '@jest/globals';
import { Cage, load } from '../../../wasm/umbilic.js';
import { formatObj, parseObj } from '../../../web/cage/obj.js';
import { box, cageOfMesh, refusal } from './cages.js';

/** @import {Point} from '../../../web/cage/polygons.js' */

/** @param {string} text */
function parsed(text) {
  const cage = parseObj(text);
  if ('refused' in cage) throw new Error(cage.refused);
  return cage;
}

test('a cage reads back from its text with every digit and every group', () => {
  const text = formatObj(box(1));
  expect(formatObj(parsed(text))).toBe(text);
  const cage = box(2);
  /** @param {Point} point @returns {Point} */
  const spread = ([x, y, z]) => [(x * 1e-7) / 3, y * Math.PI * 1e-7, z ? z * 1e-7 : -0];
  cage.points = cage.points.map(spread);
  cage.groups = [
    { name: 'one', faces: [0, 1, 5] },
    { name: 'two', faces: [1, 2] },
    { name: 'last\\', faces: [23] },
  ];
  expect(parsed(formatObj(cage))).toEqual(cage);
});

test('texture and normal numbers, numbers from the end, comments and joined lines are read as the format has them', () => {
  const text = [
    'v 0 0 0 # one\r\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n',
    'g a b\nf 1/1/1 3//2 2\\\n\ng\nf -4 -3 -1\nf 2 3 4\nf 1 4 3\n',
  ].join('');
  expect(parsed(text)).toEqual({
    points: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    faces: [
      [0, 2, 1],
      [0, 1, 3],
      [1, 2, 3],
      [0, 3, 2],
    ],
    groups: [
      { name: 'a', faces: [0] },
      { name: 'b', faces: [0] },
    ],
  });
});

test('text that is no cage is refused, with the line where that is known', () => {
  const triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
  expect(refusal(parseObj(''))).toBe('No face would be left.');
  expect(refusal(parseObj('v 1 2\n'))).toBe('Line 1: a vertex has three numbers.');
  expect(refusal(parseObj(`${triangle}f 1 2 4\n`))).toBe('Line 4: there is no vertex 4.');
  expect(refusal(parseObj(`${triangle}f 1 2 0\n`))).toBe('Line 4: there is no vertex 0.');
  expect(refusal(parseObj(`${triangle}f 1 2 -4\n`))).toBe('Line 4: there is no vertex -4.');
  expect(refusal(parseObj(`${triangle}f 1 2\n`))).toBe('Face 1 would have 2 corners.');
  expect(refusal(parseObj(`${triangle}f 1 2 2\n`))).toBe('Face 1 would have a vertex twice.');
  expect(refusal(parseObj('v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n'))).toBe('Face 1 would have no area.');
});

/** @param {number[]} face from its least corner */
function canonical(face) {
  const first = face.indexOf(Math.min(...face));
  return [...face.slice(first), ...face.slice(0, first)];
}

test('a generated cage is the same from the core’s text and from its mesh, and its text opens as the same cage', async () => {
  await load();
  for (const name of ['cube', 'torus', 'two-3', 'octahedron-frame']) {
    const generated = Cage.generate(name);
    const text = generated.obj();
    const fromText = parsed(text);
    const fromMesh = cageOfMesh(generated.mesh());
    expect(fromMesh.faces.map(canonical)).toEqual(fromText.faces.map(canonical));
    // Meshes have single precision.
    fromMesh.points.forEach((point, v) =>
      point.forEach((x, axis) => expect(Math.abs(x - fromText.points[v][axis])).toBeLessThan(1e-6)),
    );
    const again = Cage.read(formatObj(fromText));
    expect(again.obj()).toBe(text);
    expect(again.counts).toEqual(generated.counts);
    generated.dispose();
    again.dispose();
  }
});
