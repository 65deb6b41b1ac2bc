// SPDX-License-Identifier: MIT
/**
 * @file Names of the generated cages on the page, and names of saved files.
 */

/**
 * Vertices and edges of the polyhedra whose edges are thickened to frames. @type {Record<string, [number, number]>}
 */
const polyhedra = {
  tetrahedron: [4, 6],
  cube: [8, 12],
  octahedron: [6, 12],
  dodecahedron: [20, 30],
  icosahedron: [12, 30],
  cuboctahedron: [12, 24],
  'triangular-prism': [6, 9],
  'pentagonal-prism': [10, 15],
  'hexagonal-prism': [12, 18],
  'truncated-tetrahedron': [12, 18],
};

/**
 * A cage's title, such as "Two junctions, 3 arms", with its genus if its name determines it.
 * @param {string} name as the core knows it
 * @returns {{title: string, genus: number | null, frame: boolean}} `frame` is true if it has two families and a
 *   thickness
 */
export function cageWords(name) {
  if (name === 'cube') return { title: 'Cube', genus: 0, frame: false };
  if (name === 'torus') return { title: 'Torus', genus: 1, frame: false };
  const sides = /^hole-(\d+)$/.exec(name)?.[1];
  if (name === 'n-sided' || sides) return { title: `${sides ?? 'N'}-sided hole`, genus: null, frame: false };
  const arms = /^two-(\d+)$/.exec(name);
  if (arms) return { title: `Two junctions, ${arms[1]} arms`, genus: Number(arms[1]) - 1, frame: true };
  const polyhedron = /^(.*)-frame$/.exec(name)?.[1];
  if (!polyhedron) return { title: name, genus: null, frame: false };
  const counts = polyhedra[polyhedron];
  const title = `${polyhedron[0].toUpperCase()}${polyhedron.slice(1).replaceAll('-', ' ')} frame`;
  return { title, genus: counts ? counts[1] - counts[0] + 1 : null, frame: true };
}

/**
 * A cage file's name without folder and extension, with only safe characters.
 * @param {string} fileName
 */
export function stemOf(fileName) {
  const stem = fileName.replace(/^.*[/\\]/, '').replace(/\.(obj|off|ply|json)$/i, '');
  return stem.replace(/[^\p{L}\p{N}._-]+/gu, '-').replace(/^-+|-+$/g, '') || 'cage';
}
