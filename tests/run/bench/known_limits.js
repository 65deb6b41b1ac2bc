// SPDX-License-Identifier: MIT
/**
 * @file Problems whose least energy is known: by a formula, as a tabulated minimal surface, or by the minimization of a
 * curve. Each is asked of several cages, caps or segments, since its answer should depend on none of them; but for what is
 * held at boundaries, whose truth is that of the spline through so many points (held_circles.js).
 */
import { clampedCatenoid, clampedRevolution, clampedSphere } from './clamped.js';

/** @typedef {import('../../../wasm/types.js').Problem} Problem */
/**
 * @typedef {object} Known
 * @property {string} what
 * @property {number} truth
 * @property {number} doubt by how much the truth itself may be off
 * @property {string} cage in words
 * @property {Problem} problem
 */
/** @typedef {{ cage: any, words: string, cap?: 'smooth' | 'flat' | 'none', levels?: [number, number], boundary?: string }} Ask */

const { PI, LN2, cos } = Math;
const zeta3 = 1.2020569031595942;

/**
 * Of functionals of second order, so that the table shows what the extrapolation leaves rather than the optimizer. Those of
 * third order would take too long.
 */
const tightTolerance = 1e-9;
const secondOrder = ['bending', 'willmore'];

/** The problem in words and as data. @param {string} what @param {number} truth @param {number} doubt @param {Record<string, number>} terms @param {Ask} ask @returns {Known} */
function known(what, truth, doubt, terms, { cage, words, cap = 'smooth', levels = [0, 3], boundary }) {
  const constraints = boundary ? { constraints: { boundary: { condition: boundary } } } : {};
  const tight = Object.keys(terms).every((name) => secondOrder.includes(name)) ? { tolerance: tightTolerance } : {};
  return {
    what,
    truth,
    doubt,
    cage: words,
    problem: /** @type {any} */ ({
      umbilic: 'problem',
      version: 1,
      cage,
      terms,
      ...constraints,
      options: { cap, levels, ...tight },
    }),
  };
}

/** An OBJ file's text. @param {number[][]} vertices @param {number[][]} faces from 0 */
function obj(vertices, faces) {
  const lines = [...vertices.map((v) => `v ${v.join(' ')}`), ...faces.map((f) => `f ${f.map((i) => i + 1).join(' ')}`)];
  return { name: 'polyhedron', text: `${lines.join('\n')}\n` };
}

const polyhedra = {
  tetrahedron: obj(
    [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], // prettier-ignore
    [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], // prettier-ignore
  ),
  octahedron: obj(
    [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], // prettier-ignore
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], // prettier-ignore
  ),
  'pentagonal prism': obj(
    [0.8, -0.8].flatMap((z) =>
      [0, 1, 2, 3, 4].map((i) =>
        [cos((2 * PI * i) / 5), Math.sin((2 * PI * i) / 5), z].map((x) => Number(x.toFixed(6))),
      ),
    ),
    [[0, 1, 2, 3, 4], [9, 8, 7, 6, 5], ...[0, 1, 2, 3, 4].map((i) => [i, 5 + i, 5 + ((i + 1) % 5), (i + 1) % 5])],
  ),
};

/** Lawson's surface of genus g in two junctions of g + 1 arms: bending 4 W - 8 pi (1 - g). @type {Record<number, [bending: number, doubt: number]>} */
const lawson = {
  2: [4 * 21.908514 + 8 * PI, 4e-6],
  3: [141.5466, 5e-5],
  4: [168.6859, 5e-5],
  5: expansion(5),
  6: [221.1176, 5e-5],
  11: expansion(11),
};

/** From the expansion of the area in t = 1 / (2 g + 2) to third order. @param {number} genus @returns {[number, number]} */
function expansion(genus) {
  const t = 0.5 / (genus + 1);
  return [32 * PI * (1 - LN2 * t - 2.25 * zeta3 * t ** 3) + 8 * PI * (genus - 1), 32 * PI * 4 * t ** 5];
}

/** @param {number} genus @param {Ask['cap']} cap @param {object} [options] of the generator @param {string} [words] */
function lawsonRow(genus, cap, options = {}, words = '') {
  const [bending, doubt] = lawson[genus];
  const generator = `two-${genus + 1}`;
  const family = 'family' in options ? options.family : 'flag';
  const levels = /** @type {[number, number]} */ (family === 'hub' ? [0, 4] : [0, 3]); // hubs often begin at level 2
  const cage = { cage: { generator, ...options }, words: `${generator}, ${family}${words}`, cap, levels };
  return known(`Lawson's surface of genus ${genus}`, bending, doubt, { bending: 1 }, cage);
}

const hub = { family: 'hub' };
const lawsonRows = [
  ...[2, 3, 4, 5, 6, 11].flatMap((genus) => [lawsonRow(genus, 'smooth'), lawsonRow(genus, 'smooth', hub)]),
  ...[2, 3, 4].flatMap((genus) => [lawsonRow(genus, 'none'), lawsonRow(genus, 'flat')]),
  lawsonRow(2, 'none', hub),
  lawsonRow(2, 'smooth', { thickness: 0.7 }, ', arms 0.7 as thick'),
  lawsonRow(3, 'smooth', { spread: 1.5 }, ', arms 1.5 as far out'),
];

/** @param {string} functional @param {number} truth @param {Ask} ask */
const sphere = (functional, truth, ask) => known('sphere', truth, 0, { [functional]: 1 }, ask);
const cube = { cage: { generator: 'cube' }, words: 'cube' };
const thirdOrder = [
  ...['mvs', 'mvs_cross', 'mehlum_tarrou', 'second_form_variation', 'mean_curvature_variation', 'curvedness_variation'],
];
/** @type {Ask[]} */
const otherSpheres = Object.entries(polyhedra).map(([words, cage]) => ({ cage, words, levels: [0, 4] }));
const sphereRows = [
  .../** @type {const} */ (['smooth', 'none', 'flat']).map((cap) => sphere('bending', 8 * PI, { ...cube, cap })),
  sphere('willmore', 4 * PI, cube),
  ...otherSpheres.map((ask) => sphere('bending', 8 * PI, ask)),
  sphere('bending', 8 * PI, { ...otherSpheres[0], cap: 'none' }),
  ...thirdOrder.map((functional) => sphere(functional, 0, { ...cube, levels: [0, 4] })),
  sphere('mvs_cross', 0, { ...cube, cap: 'flat', levels: [0, 4] }),
  ...otherSpheres.map((ask) => sphere('mvs_cross', 0, ask)),
];

/** @param {number} ratio @param {[number, number]} [segments] @returns {Ask} */
const torus = (ratio, segments) => ({
  cage: { generator: 'torus', ratio, ...(segments ? { segments } : {}) },
  words: `torus ${(segments ?? [6, 8]).join('x')}, ratio ${ratio}`,
});

/**
 * The least energies of closed surfaces of revolution for weights of bending and mvs_cross, as profiles.js finds them with
 * 12 terms; its test computes them again. Their tubes are not quite round: tori whose tubes are circles have at least
 * 81.019085, 146.593787 and 1021.235809.
 * @type {[bending: number, cross: number, energy: number][]}
 */
export const blends = [
  [0.999, 0.001, 81.00818026],
  [0.95, 0.05, 146.58680664],
  [1, 1, 1020.6704807],
];

const torusRows = [
  ...[torus(0.3), torus(0.5), torus(0.85), torus(0.5, [8, 8]), torus(0.5, [12, 6])].map((ask) =>
    known('Clifford torus', 8 * PI ** 2, 0, { bending: 1 }, ask),
  ),
  known('Clifford torus', 2 * PI ** 2, 0, { willmore: 1 }, torus(0.5)),
  known('any torus', 0, 0, { mvs: 1 }, torus(0.5)),
  ...blends.flatMap(([bending, mvs_cross, energy]) =>
    [torus(0.5), torus(0.3, [8, 8]), torus(0.5, [12, 6])].map((ask) =>
      known('surface of revolution', energy, 1e-8 * energy, { bending, mvs_cross }, { ...ask, levels: [0, 4] }),
    ),
  ),
];

/** @param {string} generator @param {[number, number]} segments @param {object} options @param {string} words @param {string} [boundary] @returns {Ask} */
const open = (generator, segments, options, words, boundary = 'tangent') => ({
  cage: { generator, segments, ...options },
  words: `${generator} ${segments.join('x')}, ${words}`,
  levels: [0, 2],
  boundary,
});

/** @param {string} what @param {import('./clamped.js').Least} least @param {'willmore' | 'bending'} functional @param {Ask} ask */
const clamped = (what, least, functional, ask) =>
  known(what, least[functional], (functional === 'bending' ? 4 : 1) * least.doubt, { [functional]: 1 }, ask);

const revolutionRows = [0.3, 0.5, 1, 2].flatMap((radius) =>
  [16, 32, 64].map((around) => {
    const across = Math.max(4, Math.round(around / PI / radius / 2) * 2);
    const ask = open('cylinder', [around, Math.min(across, around)], { radius }, `radius ${radius}`);
    return clamped('clamped surface of revolution', clampedRevolution(radius, around), 'willmore', ask);
  }),
);

/** @param {number} angle degrees @param {number} around @param {string} [boundary] */
const part = (angle, around, boundary) =>
  open('spherical-cap', [around, around / 8], { half_angle: angle }, `${angle} degrees`, boundary);
/** @param {number} angle @param {number} around @param {'willmore' | 'bending'} functional */
const clampedPart = (angle, around, functional) =>
  clamped('part of a sphere', clampedSphere(angle, around), functional, part(angle, around));
const partRows = [30, 90, 150].flatMap((angle) => [
  ...[16, 32, 64].map((around) => clampedPart(angle, around, 'willmore')),
  clampedPart(angle, 32, 'bending'),
  ...[16, 32].map((m) => known('part of a sphere', 0, 0, { mvs_cross: 1 }, part(angle, m, 'curvature'))),
]);

const catenoidRows = [1, 2].flatMap((height) =>
  [16, 32, 64].map((m) => {
    const ask = open('catenoid', [m, Math.round((m * height) / 8) * 2], { height }, `height ${height}`);
    return clamped('catenoid', clampedCatenoid(height, m), 'bending', ask);
  }),
);
const cylinderRows = [16, 32].flatMap((m) => {
  const ask = open('cylinder', [m, m / 2], {}, 'radius 1', 'curvature');
  return [known('cylinder', 0, 0, { mvs_cross: 1 }, ask), known('cylinder', 0, 0, { mvs: 1 }, ask)];
});
const diskRows = [16, 32].map((m) => known('disk', 0, 0, { bending: 1 }, open('disk', [m, m / 8], {}, 'radius 1')));

/** @type {Known[]} */
export const knownLimits = [
  ...[lawsonRows, sphereRows, torusRows, revolutionRows, partRows, catenoidRows, cylinderRows, diskRows].flat(),
];
