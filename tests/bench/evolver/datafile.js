// SPDX-License-Identifier: MIT
/**
 * @file Writes Surface Evolver's datafile of a genus-2 surface with the symmetry D3h: whole, or one of twelve sectors between mirrors.
 *
 * The sector lies in z >= 0, 0 <= y <= sqrt(3) x. It is a trapezoid of three triangles, whose twelve copies make the regular
 * triangulation that a genus-2 surface with this symmetry can have: all valences are 6, but for 8 where an arm meets two mirrors
 * (points outer and inner; three of each). The points are those of the cage `umbilic cage two-3`.
 *
 *       outer --- inner          outer-inner: half the section of an arm, in z = 0
 *       /   \     /   \          top-outer, inner-below: along an arm, in y = 0
 *    top --- side --- below      top-side-below: along a junction, in y = sqrt(3) x
 */

/** @typedef {[number, number, number]} Point */
/** @typedef {[number, number, number]} Triangle */
/** @typedef {{ points: Point[], triangles: Triangle[] }} Mesh */
/** @typedef {'whole' | 'sector'} Domain */
/** @typedef {'fixed' | 'free'} Area */

const root3 = Math.sqrt(3);

/** @type {Record<string, Point>} */
const corners = {
  top: [0, 0, 4 / 3],
  outer: [4 / 3, 0, 0],
  inner: [2 / 3, 0, 0],
  below: [0, 0, 2 / 3],
  side: [root3 / 9, 1 / 3, 0.8075499102701247],
};
/** The arm's section is no segment: its side has this distance from the plane y = 0. @type {Point} */
const armSide = [1, 1 / 3, 0];

/** The mirrors, as constraints of the datafile. @type {{ formula: string, distance: (point: Point) => number }[]} */
const mirrors = [
  { formula: 'z = 0', distance: ([, , z]) => z },
  { formula: 'y = 0', distance: ([, y]) => y },
  { formula: 'y = sqrt(3)*x', distance: ([x, y]) => (y - root3 * x) / 2 },
];

/** @param {Point} point @returns {number[]} the mirrors that it is on, counted from 1 */
function mirrorsOf(point) {
  return mirrors.flatMap(({ distance }, i) => (Math.abs(distance(point)) < 1e-9 ? [i + 1] : []));
}

/** The trapezoid, every triangle in four. @returns {Mesh} */
function sector() {
  const points = Object.values(corners);
  /** @type {Triangle[]} */
  const coarse = [
    [0, 1, 4],
    [4, 1, 2],
    [4, 2, 3],
  ];
  /** @type {Map<string, number>} */
  const middles = new Map();
  /** @param {number} a @param {number} b */
  const middle = (a, b) => {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    const known = middles.get(key);
    if (known !== undefined) return known;
    middles.set(key, points.length);
    const [p, q] = [points[a], points[b]];
    points.push(key === '1 2' ? armSide : [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2]);
    return points.length - 1;
  };
  const triangles = coarse.flatMap(([a, b, c]) => {
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    return /** @type {Triangle[]} */ ([
      [a, ab, ca],
      [ab, b, bc],
      [ca, bc, c],
      [ab, bc, ca],
    ]);
  });
  return { points, triangles };
}

/** Twelve copies of the sector, joined where they touch. @param {Mesh} mesh @returns {Mesh} */
function reflected({ points, triangles }) {
  /** @type {Point[]} */
  const all = [];
  /** @type {Map<string, number>} */
  const indices = new Map();
  /** @param {Point} point */
  const index = (point) => {
    const key = point.map((x) => (Math.round(x * 1e6) || 0).toString()).join(' ');
    const known = indices.get(key);
    if (known !== undefined) return known;
    indices.set(key, all.length);
    all.push(point);
    return all.length - 1;
  };
  /** @type {Triangle[]} */
  const copies = [];
  for (const turn of [0, 1, 2]) {
    const [c, s] = [Math.cos((turn * 2 * Math.PI) / 3), Math.sin((turn * 2 * Math.PI) / 3)];
    for (const up of [1, -1]) {
      for (const left of [1, -1]) {
        const image = points.map(([x, y, z]) => index([c * x - s * left * y, s * x + c * left * y, up * z]));
        for (const [i, j, k] of triangles) {
          copies.push(up * left > 0 ? [image[i], image[j], image[k]] : [image[i], image[k], image[j]]);
        }
      }
    }
  }
  return { points: all, triangles: copies };
}

/**
 * Elements are counted from 1 and a facet names its directed edges. All facets have tension 0: Evolver would add the area otherwise.
 * In a sector, a constraint is a mirror: all methods of Evolver's that end in sq_mean_curvature continue the surface by reflection there.
 * @param {Domain} domain
 * @param {string} quantity Evolver's method for the square of mean curvature
 * @param {Area} area whether it is held: the energy does not depend on size, so nothing else does
 * @returns {string} the datafile, up to and without the commands
 */
export function datafile(domain, quantity, area) {
  const whole = domain === 'whole';
  const { points, triangles } = whole ? reflected(sector()) : sector();
  /** @type {Map<string, number>} */
  const edges = new Map();
  /** @type {string[]} */
  const edgeLines = [];
  const facetLines = triangles.map((triangle, facet) => {
    const sides = triangle.map((a, i) => {
      const b = triangle[(i + 1) % 3];
      const back = edges.get(`${b} ${a}`);
      if (back !== undefined) return -back;
      edges.set(`${a} ${b}`, edges.size + 1);
      const shared = mirrorsOf(points[a]).filter((mirror) => mirrorsOf(points[b]).includes(mirror));
      edgeLines.push(`${edges.size} ${a + 1} ${b + 1}${whole ? '' : constraints(shared)}`);
      return edges.size;
    });
    return `${facet + 1} ${sides.join(' ')} tension 0`;
  });
  const vertexLines = points.map(
    (point, i) => `${i + 1} ${point.map((x) => x.toFixed(9)).join(' ')}${whole ? '' : constraints(mirrorsOf(point))}`,
  );
  return [
    `quantity willmore energy modulus ${whole ? 1 : 12} method ${quantity} global`,
    `quantity surface_area ${area === 'fixed' ? 'fixed = 1' : 'info_only'} method facet_area global`,
    ...(whole ? [] : mirrors.map(({ formula }, i) => `constraint ${i + 1}\nformula: ${formula}`)),
    'vertices',
    ...vertexLines,
    'edges',
    ...edgeLines,
    'faces',
    ...facetLines,
    'read',
    '',
  ].join('\n');
}

/** @param {number[]} list */
function constraints(list) {
  return list.length ? ` constraints ${list.join(' ')}` : '';
}
