// SPDX-License-Identifier: MIT
/**
 * @file Where a mesh crosses itself: the curves in which triangles without a common vertex meet.
 *
 * All vertices are first moved by a fixed pseudorandom displacement, far smaller than a triangle, as symmetric surfaces
 * often meet exactly in vertices and edges. Then a pair of triangles meets in a segment or not at all. Each end of a segment
 * is a point in which an edge of one pierces the other; the next pair along the curve has the same point, found by the same
 * numbers, which joins the segments to curves. A crossing stays under such a displacement; a mere touch may be found or not.
 */

/** @import {Mesh} from '../../wasm/types.js' */

/**
 * The curves in which a surface crosses itself: their segments, 6 coordinates for each, as the mesh has them; the number of
 * curves, and that of the triangles among which they were found.
 * @typedef {{segments: Float32Array, places: number, triangles: number}} Crossings
 */

/** The largest displacement of a coordinate, as a part of the mesh's largest extent. Float coordinates have 1e-7. */
const DISPLACEMENT = 1e-6;
/** Triangles in a leaf of the tree. */
const LEAF = 4;

/** @param {Pick<Mesh, 'positions' | 'triangles'>} mesh @returns {Crossings} */
export function crossingsOf({ positions, triangles }) {
  const points = displaced(positions);
  const tree = createTree(points, triangles);
  const curves = createCurves();
  /** @type {number[]} */
  const segments = [];
  tree.visitPairs((one, other) => {
    if (neighbours(triangles, one, other)) return;
    const ends = segmentOf(points, triangles, one, other);
    if (!ends) return;
    segments.push(...ends[0].point, ...ends[1].point);
    curves.join(ends[0].key, ends[1].key);
  });
  return { segments: Float32Array.from(segments), places: curves.count(), triangles: triangles.length / 3 };
}

/** @param {Float32Array} positions @returns {Float64Array} */
function displaced(positions) {
  let [low, high] = [Infinity, -Infinity];
  for (const x of positions) {
    low = Math.min(low, x);
    high = Math.max(high, x);
  }
  const size = DISPLACEMENT * (high - low);
  let random = 1;
  return Float64Array.from(positions, (x) => {
    random = (Math.imul(random, 1_664_525) + 1_013_904_223) >>> 0; // Numerical Recipes' generator
    return x + size * (random / 2 ** 31 - 1);
  });
}

/** Whether two triangles have a common vertex. @param {Uint32Array} triangles @param {number} one @param {number} other */
function neighbours(triangles, one, other) {
  for (let i = 3 * one; i < 3 * one + 3; i++) {
    for (let j = 3 * other; j < 3 * other + 3; j++) if (triangles[i] === triangles[j]) return true;
  }
  return false;
}

/**
 * Six times the signed volume of the tetrahedron of four vertices.
 * @param {Float64Array} x @param {number} a @param {number} b @param {number} c @param {number} d
 */
function volume(x, a, b, c, d) {
  const [i, j, k, l] = [3 * a, 3 * b, 3 * c, 3 * d];
  const bx = x[j] - x[i];
  const by = x[j + 1] - x[i + 1];
  const bz = x[j + 2] - x[i + 2];
  const cx = x[k] - x[i];
  const cy = x[k + 1] - x[i + 1];
  const cz = x[k + 2] - x[i + 2];
  const dx = x[l] - x[i];
  const dy = x[l + 1] - x[i + 1];
  const dz = x[l + 2] - x[i + 2];
  return bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
}

/** Whether a triangle lies on one side of the plane of another. @param {Float64Array} x @param {Uint32Array} triangles @param {number} plane @param {number} other */
function onOneSide(x, triangles, plane, other) {
  const [i, j] = [3 * plane, 3 * other];
  const a = triangles[i];
  const b = triangles[i + 1];
  const c = triangles[i + 2];
  const first = volume(x, a, b, c, triangles[j]) > 0;
  return first === volume(x, a, b, c, triangles[j + 1]) > 0 && first === volume(x, a, b, c, triangles[j + 2]) > 0;
}

/** @typedef {{key: string, point: [number, number, number]}} End of a segment: an edge and the triangle that it pierces */

/**
 * @param {Float64Array} x
 * @param {Uint32Array} triangles
 * @param {number} one
 * @param {number} other
 * @returns {[End, End] | null}
 */
function segmentOf(x, triangles, one, other) {
  if (onOneSide(x, triangles, one, other) || onOneSide(x, triangles, other, one)) return null;
  /** @type {End[]} */
  const ends = [];
  for (const [pierced, piercing] of [
    [one, other],
    [other, one],
  ]) {
    const [a, b, c] = triangles.subarray(3 * pierced, 3 * pierced + 3);
    const corners = triangles.subarray(3 * piercing, 3 * piercing + 3);
    const sides = [0, 1, 2].map((i) => volume(x, a, b, c, corners[i]));
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      // The edge from its lower vertex on, so that both of its triangles find the same numbers.
      const [from, to] = corners[i] < corners[j] ? [i, j] : [j, i];
      if (sides[from] > 0 === sides[to] > 0) continue;
      const [p, q] = [corners[from], corners[to]];
      const turns = [volume(x, p, q, a, b) > 0, volume(x, p, q, b, c) > 0, volume(x, p, q, c, a) > 0];
      if (turns[0] !== turns[1] || turns[1] !== turns[2]) continue;
      const t = sides[from] / (sides[from] - sides[to]);
      const at = (/** @type {number} */ axis) => x[3 * p + axis] + t * (x[3 * q + axis] - x[3 * p + axis]);
      ends.push({ key: `${p} ${q} ${pierced}`, point: [at(0), at(1), at(2)] });
    }
  }
  return ends.length === 2 ? [ends[0], ends[1]] : null;
}

/** Counts the curves that segments with common ends form. */
function createCurves() {
  /** Of each end another one of its curve, or itself. @type {Map<string, string>} */
  const parents = new Map();
  let curves = 0;

  /** @param {string} key */
  function find(key) {
    let root = key;
    for (let next = parents.get(root); next !== undefined && next !== root; next = parents.get(root)) root = next;
    parents.set(key, root); // shortens the way of the next search
    return root;
  }

  /** @param {string} key */
  function add(key) {
    if (parents.has(key)) return;
    parents.set(key, key);
    curves++;
  }

  return {
    /** @param {string} one @param {string} other */
    join(one, other) {
      add(one);
      add(other);
      const [from, to] = [find(one), find(other)];
      if (from === to) return;
      parents.set(from, to);
      curves--;
    },
    count: () => curves,
  };
}

/** A number of 30 bits that is near for near points of the unit cube: their bits interleaved. @param {number[]} point */
function mortonOf(point) {
  let code = 0;
  for (let bit = 9; bit >= 0; bit--) {
    for (const x of point) code = 2 * code + ((Math.min(1023, Math.floor(1024 * x)) >> bit) & 1);
  }
  return code;
}

/**
 * A binary tree of boxes over triangles, which lie in it in the order of their Morton codes. Node n has the children 2n + 1
 * and 2n + 2, and the leaves have LEAF triangles each.
 * @param {Float64Array} x
 * @param {Uint32Array} triangles
 */
function createTree(x, triangles) {
  const count = triangles.length / 3;
  const boxes = new Float64Array(6 * count);
  for (let t = 0; t < count; t++) {
    for (let axis = 0; axis < 3; axis++) {
      const [a, b, c] = [0, 1, 2].map((i) => x[3 * triangles[3 * t + i] + axis]);
      boxes[6 * t + axis] = Math.min(a, b, c);
      boxes[6 * t + 3 + axis] = Math.max(a, b, c);
    }
  }
  const order = mortonOrder(boxes, count);
  const leaves = 2 ** Math.ceil(Math.log2(Math.max(1, count / LEAF)));
  const nodes = new Float64Array(6 * (2 * leaves - 1));
  for (let n = 2 * leaves - 2; n >= 0; n--) {
    if (n < leaves - 1) {
      unite(nodes, n, nodes, 2 * n + 1, nodes, 2 * n + 2);
      continue;
    }
    nodes.fill(Infinity, 6 * n, 6 * n + 3).fill(-Infinity, 6 * n + 3, 6 * n + 6);
    const first = LEAF * (n - leaves + 1);
    for (let i = first; i < Math.min(count, first + LEAF); i++) unite(nodes, n, nodes, n, boxes, order[i]);
  }

  /** @param {number} n @param {number} m @param {(one: number, other: number) => void} visit */
  function visitLeaves(n, m, visit) {
    const [first, second] = [LEAF * (n - leaves + 1), LEAF * (m - leaves + 1)];
    for (let i = first; i < Math.min(count, first + LEAF); i++) {
      for (let j = n === m ? i + 1 : second; j < Math.min(count, second + LEAF); j++) {
        if (overlap(boxes, order[i], order[j])) visit(order[i], order[j]);
      }
    }
  }

  return {
    /** Visits each pair of triangles whose boxes overlap once. @param {(one: number, other: number) => void} visit */
    visitPairs(visit) {
      const stack = [0, 0];
      while (stack.length) {
        const [m, n] = [Number(stack.pop()), Number(stack.pop())];
        if (n !== m && !overlap(nodes, n, m)) continue;
        if (n >= leaves - 1) {
          visitLeaves(n, m, visit); // both are leaves, as the tree is complete and both are at the same depth
        } else if (n === m) {
          stack.push(2 * n + 1, 2 * n + 1, 2 * n + 1, 2 * n + 2, 2 * n + 2, 2 * n + 2);
        } else {
          for (const left of [2 * n + 1, 2 * n + 2]) stack.push(left, 2 * m + 1, left, 2 * m + 2);
        }
      }
    },
  };
}

/** The triangles in the order of their boxes' middles. @param {Float64Array} boxes @param {number} count @returns {Uint32Array} */
function mortonOrder(boxes, count) {
  const low = [0, 1, 2].map((axis) => least(boxes, axis));
  const size = Math.max(...[3, 4, 5].map((axis) => -least(boxes, axis, -1) - low[axis - 3])) || 1;
  // The code, and below it the number of the triangle: an integer below 2^53 for up to 2^23 triangles.
  const keys = Float64Array.from({ length: count }, (_, t) => {
    const middle = low.map((x, axis) => ((boxes[6 * t + axis] + boxes[6 * t + 3 + axis]) / 2 - x) / size);
    return mortonOf(middle) * 2 ** 23 + t;
  }).sort();
  return Uint32Array.from(keys, (key) => key % 2 ** 23);
}

/** The least number of a column of boxes, times `sign`. @param {Float64Array} boxes @param {number} column @param {1 | -1} [sign] */
function least(boxes, column, sign = 1) {
  let result = Infinity;
  for (let i = column; i < boxes.length; i += 6) result = Math.min(result, sign * boxes[i]);
  return result;
}

/**
 * Box n of `to` becomes the one around two others.
 * @param {Float64Array} to @param {number} n @param {Float64Array} one @param {number} i @param {Float64Array} other @param {number} j
 */
function unite(to, n, one, i, other, j) {
  for (let axis = 0; axis < 3; axis++) {
    to[6 * n + axis] = Math.min(one[6 * i + axis], other[6 * j + axis]);
    to[6 * n + 3 + axis] = Math.max(one[6 * i + 3 + axis], other[6 * j + 3 + axis]);
  }
}

/** @param {Float64Array} boxes @param {number} n @param {number} m */
function overlap(boxes, n, m) {
  const [i, j] = [6 * n, 6 * m];
  return (
    boxes[i] <= boxes[j + 3] &&
    boxes[j] <= boxes[i + 3] &&
    boxes[i + 1] <= boxes[j + 4] &&
    boxes[j + 1] <= boxes[i + 4] &&
    boxes[i + 2] <= boxes[j + 5] &&
    boxes[j + 2] <= boxes[i + 5]
  );
}
