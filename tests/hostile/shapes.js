// SPDX-License-Identifier: MIT
/**
 * @file Cages whose text is right and whose shape is not: topology that is no surface, and places that break arithmetic.
 */
import {
  bipyramid,
  both,
  box,
  cube,
  moebius,
  moved,
  obj,
  randomNumbers,
  range,
  sheet,
  tetrahedron,
  torus,
} from './contents.js';
import { cage } from './row.js';

/** @param {string} text OBJ @param {number} factor */
const scaled = (text, factor) => moved(text, ([x, y, z]) => [factor * x, factor * y, factor * z]);
/** @param {string} text OBJ @param {number} distance */
const far = (text, distance) => moved(text, ([x, y, z]) => [x + distance, y, z]);
/** @param {string} text OBJ @param {number} amount @param {number} seed */
function noisy(text, amount, seed) {
  const random = randomNumbers(seed);
  return moved(text, (p) => /** @type {any} */ (p.map((c) => c + amount * (2 * random() - 1))));
}

// One row a line.
// prettier-ignore
export const topologyRows = [
  cage('one triangle', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'minimized', '3 vertices, 1 faces, genus 0, boundaries 1'),
  cage('one square', sheet(1, 1), 'minimized', '4 vertices, 1 faces, genus 0, boundaries 1'),
  cage('one face of 1000 vertices', () => obj(range(1000).map((i) => [Math.cos(i / 159.2), Math.sin(i / 159.2), 0]), [range(1000).map((i) => i + 1)]), 'refused', 'face 1 has 1000 sides and would become a vertex of that valence; at most 24 are possible'),
  cage('two triangles back to back', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n', 'refused', 'vertex 1 has valence 2; the limit surface is evaluated for valences 3 to 24'),
  cage('two squares back to back', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\n', 'refused', 'vertex 1 has valence 2; the limit surface is evaluated for valences 3 to 24'),
  cage('three faces at an edge', `${tetrahedron}v 3 3 3\nf 1 2 5\n`, 'refused', 'line 10: edge between vertices 1 and 2 belongs to 3 faces: not a manifold'),
  cage('100 faces at an edge', () => obj([[0, 0, 0], [0, 0, 1], ...range(100).map((i) => /** @type {any} */ ([Math.cos(i), Math.sin(i), 0]))], range(100).map((i) => [1, 2, i + 3])), 'refused', 'line 105: edge between vertices 1 and 2 belongs to 100 faces: not a manifold'),
  cage('two tetrahedra at a vertex', both(tetrahedron, far(tetrahedron, 2)).replaceAll(' 8', ' 1'), 'refused', 'line 1: vertex 1 joins 2 separate fans of faces: not a manifold'),
  cage('two fans at a vertex of an open cage', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n', 'refused', 'line 1: vertex 1 joins 2 separate fans of faces: not a manifold'),
  cage('a Moebius strip', () => moebius(8), 'refused', 'line 24: face 8 cannot be turned to match all of its neighbours: the surface is not orientable'),
  cage('a Moebius strip of three quads', () => moebius(3), 'refused', 'line 9: face 3 cannot be turned to match all of its neighbours: the surface is not orientable'),
  cage('a Klein bottle', () => torus(6, 6, { twisted: true }), 'refused', 'line 43: face 7 cannot be turned to match all of its neighbours: the surface is not orientable'),
  cage('the projective plane', 'v 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 1\nv 0 -1 1\nv 1 1 1\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\nf 1 6 2\nf 2 3 5\nf 3 4 6\nf 4 5 2\nf 5 6 3\nf 6 2 4\n', 'refused', 'line 13: face 7 cannot be turned to match all of its neighbours: the surface is not orientable'),
  cage('a Moebius strip beside a cube', () => both(cube, far(moebius(8), 9)), 'refused', 'line 38: face 14 cannot be turned to match all of its neighbours: the surface is not orientable'),
  cage('faces that turn either way', tetrahedron.replace('f 1 3 4', 'f 4 3 1').replace('f 2 4 3', 'f 3 4 2'), 'minimized', 'turned 2 faces, so that all faces agree on one side as the outside'),
  cage('inside out', tetrahedron.replace(/^f (\d) (\d) (\d)$/gm, 'f $3 $2 $1'), 'minimized', 'turned 4 faces, so that what pointed inward points outward'),
  cage('a vertex that no face uses', `v 9 9 9\n${both('v 0 0 0\n', tetrahedron).slice(8)}`, 'minimized', 'dropped 1 vertex that no face uses'),
  cage('100 000 vertices that no face uses', () => `${tetrahedron}${range(100000).map((i) => `v ${i} 0 0`).join('\n')}\n`, 'minimized', 'dropped 100000 vertices that no face uses'),
  cage('an open tetrahedron', tetrahedron.replace('f 2 4 3\n', ''), 'minimized', '4 vertices, 3 faces, genus 0, boundaries 1'),
  cage('a sheet with a hole', () => sheet(5, 5, (i, j) => i !== 2 || j !== 2), 'minimized', '36 vertices, 24 faces, genus 0, boundaries 2'),
  cage('a sheet whose holes meet at a vertex', () => sheet(4, 4, (i, j) => !(i === 1 && j === 1) && !(i === 2 && j === 2)), 'refused', 'line 13: vertex 13 joins 2 separate fans of faces: not a manifold'),
  cage('a checkerboard', () => sheet(4, 4, (i, j) => (i + j) % 2 === 0), 'refused', 'line 7: vertex 7 joins 2 separate fans of faces: not a manifold'),
  cage('a strip of one row', () => sheet(1, 20), 'minimized', '42 vertices, 20 faces, genus 0, boundaries 1'),
  cage('two cubes apart', () => both(cube, far(cube, 5)), 'minimized', '16 vertices, 12 faces, genus 0'),
  cage('two cubes in one place', () => both(cube, cube), 'minimized', '16 vertices, 12 faces, genus 0'),
  cage('a cube in a cube', () => both(scaled(cube, 3), cube), 'minimized', '16 vertices, 12 faces, genus 0'),
  cage('a closed and an open part', () => both(cube, far(sheet(3, 3), 5)), 'minimized', '24 vertices, 15 faces, genus 0, boundaries 1'),
  cage('64 cubes', () => range(6).reduce((all, i) => both(all, far(all, 5 * 2 ** i)), cube), 'minimized', '512 vertices, 384 faces, genus 0'),
  cage('16 cubes in one place', () => range(4).reduce((all) => both(all, all), cube), 'minimized', '128 vertices, 96 faces, genus 0'),
  cage('100 triangles apart', () => range(100).map((i) => `v ${i} 0 0\nv ${i} 1 0\nv ${i} 0 1\nf -1 -2 -3\n`).join(''), 'minimized', '300 vertices, 100 faces, genus 0, boundaries 100'),
  cage('a torus of 3 times 3 quads', () => torus(3, 3), 'minimized', '9 vertices, 9 faces, genus 1'),
  cage('a seam whose vertices are there twice', () => sheet(4, 4).replace('f', 'v 0 0 0\nf'), 'minimized', 'dropped 1 vertex that no face uses'),
  cage('valence 24', () => bipyramid(24, 1), 'minimized', '26 vertices, 48 faces, genus 0'),
  cage('valence 25', () => bipyramid(25, 1), 'refused', 'vertex 26 has valence 25; the limit surface is evaluated for valences 3 to 24'),
  cage('valence 10 000', () => bipyramid(10000, 1), 'refused', 'vertex 10001 has valence 10000; the limit surface is evaluated for valences 3 to 24'),
  cage('13 faces at a vertex of the boundary', () => obj([[0, 0, 0], ...range(14).map((k) => /** @type {any} */ ([Math.cos(k / 5), Math.sin(k / 5), 0]))], range(13).map((k) => [1, k + 2, k + 3])), 'refused', 'vertex 1 has 13 faces and lies on the boundary, where at most 12 are possible'),
  cage('a vertex of valence 2', 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nv 0 0 1\nf 1 5 2 3\nf 1 3 4\nf 1 4 2 5\nf 2 4 3\n', 'refused', 'vertex 5 has valence 2; the limit surface is evaluated for valences 3 to 24'),
];

// One row a line.
// prettier-ignore
export const placeRows = [
  cage('all vertices in one place', () => moved(cube, () => [1, 2, 3]), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage coincide'),
  cage('all vertices on a line', () => moved(cube, (_, i) => [i, i, i]), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('all vertices on a line, but for rounding', () => moved(cube, (_, i) => [i, i * 0.1, i / 3]), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('a cube pressed flat', () => moved(cube, ([x, y]) => [x, y, 0]), 'doubtful', 'below_bound'),
  cage('a plate of 1 : 333', () => box(2, 2, 0.006), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a plate of 1 : 10^6', () => box(2, 2, 2e-6), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a plate of 1 : 10^200', () => box(2, 2, 2e-200), 'doubtful', 'below_bound'),
  cage('a needle of 1 : 1000', () => box(1, 1, 1000), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a needle of 1 : 10^15', () => box(1, 1, 1e15), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('a box of 10^6 : 1 : 10^-6', () => box(1e6, 1, 1e-6), 'doubtful', 'max_iterations'),
  cage('a lens of 1 : 1000', () => bipyramid(5, 0.001), 'minimized', '7 vertices, 10 faces, genus 0'),
  cage('two vertices in one place', () => moved(cube, (p, i) => (i === 1 ? [-1, -1, -1] : p)), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a face of no area', () => moved(cube, (p, i) => (i < 4 ? [p[0], p[0], -1] : p)), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a vertex in the middle', () => moved(cube, (p, i) => (i === 6 ? [0, 0, 0] : p)), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a spike of 10^4', () => moved(cube, (p, i) => (i === 6 ? [1e4, 1e4, 1e4] : p)), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a spike of 10^300', () => moved(cube, (p, i) => (i === 6 ? [1e300, 1e300, 1e300] : p)), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('two vertices swapped', () => moved(cube, (p, i) => (i === 0 ? [1, 1, 1] : i === 7 ? [-1, -1, -1] : p)), 'minimized', 'turned 6 faces, so that what pointed inward points outward'),
  cage('noise as long as its edges', () => noisy(cube, 2, 1), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a torus of noise', () => noisy(torus(6, 4), 0.5, 2), 'minimized', '24 vertices, 24 faces, genus 1'),
  cage('2^300 times the size', () => scaled(cube, 2 ** 300), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('2^-300 times the size', () => scaled(cube, 2 ** -300), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('2^1000 times the size', () => scaled(cube, 2 ** 1000), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('2^-1000 times the size', () => scaled(cube, 2 ** -1000), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('the largest numbers', () => moved(cube, (p) => /** @type {any} */ (p.map((c) => c * Number.MAX_VALUE))), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('the least normal numbers', () => scaled(cube, 2.2250738585072014e-308), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('denormal numbers', () => scaled(cube, 1e-310), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('the least denormal number', () => scaled(cube, 5e-324), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('a cube of 1 at a distance of 10^9', () => far(cube, 1e9), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a cube of 1 at a distance of 10^15', () => far(cube, 1e15), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('a cube of 1 at a distance of 10^17', () => far(cube, 1e17), 'refused', 'line 9: face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('a cube of 10^-12 at a distance of 1', () => far(scaled(cube, 1e-12), 1), 'minimized', '8 vertices, 6 faces, genus 0'),
  cage('cubes of 10^-100 and 10^100', () => both(scaled(cube, 1e-100), far(scaled(cube, 1e100), 1e101)), 'doubtful', '16 vertices, 12 faces, genus 0'),
  cage('a torus of radii 1 : 1000', () => torus(8, 4, { ratio: 0.001 }), 'minimized', '32 vertices, 32 faces, genus 1'),
  cage('a torus through itself', () => torus(6, 6, { ratio: 1.5 }), 'doubtful', 'max_iterations'),
  cage('a torus that touches itself', () => torus(8, 8, { ratio: 1 }), 'minimized', '64 vertices, 64 faces, genus 1'),
  cage('a sheet whose faces all lie on each other', () => moved(sheet(4, 4), ([x, y]) => [x % 2, y % 2, 0]), 'doubtful', 'not_resolved'),
  cage('a face of 10 000 vertices', () => obj([...range(10000).map((i) => /** @type {any} */ ([Math.cos(i * 2e-4 * Math.PI), Math.sin(i * 2e-4 * Math.PI), 0]))], [range(10000).map((i) => i + 1)]), 'refused', 'face 1 has 10000 sides and would become a vertex of that valence; at most 24 are possible'),
];
