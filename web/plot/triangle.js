// SPDX-License-Identifier: MIT
/**
 * @file The plane of a triangle picker: where shares of three lie in an equilateral triangle, which shares a place has,
 * and where keys move them. Pure.
 */

/** Parts of three that sum to 1, each at least 0: of the top, the left and the right corner. @typedef {[number, number, number]} Shares */
/** @typedef {[x: number, y: number]} Point */

/** The height of the triangle, whose sides have length 1. */
export const HEIGHT = Math.sqrt(3) / 2;

/** The top, left and right corner; y points down. @type {[Point, Point, Point]} */
export const CORNERS = [
  [0.5, 0],
  [0, HEIGHT],
  [1, HEIGHT],
];

/** @type {Shares} */
export const CENTRE = [1 / 3, 1 / 3, 1 / 3];

/** How far an arrow key moves, and with Shift. */
const STEP = 0.01;
const LARGE_STEP = 0.1;

/** @param {Shares} shares @returns {Point} */
export const placeOf = (shares) => [
  shares.reduce((sum, share, i) => sum + share * CORNERS[i][0], 0),
  shares.reduce((sum, share, i) => sum + share * CORNERS[i][1], 0),
];

/** The barycentric coordinates of a place, below 0 outside. @param {Point} place @returns {Shares} */
function coordinatesOf([x, y]) {
  const top = 1 - y / HEIGHT;
  const right = x - top / 2;
  return [top, 1 - top - right, right];
}

/** The shares of the place on the side between two corners that is nearest. @param {Point} place @param {number} from @param {number} to @returns {Shares} */
function onSide([x, y], from, to) {
  const [[x0, y0], [x1, y1]] = [CORNERS[from], CORNERS[to]];
  const along = (x - x0) * (x1 - x0) + (y - y0) * (y1 - y0); // sides have length 1
  const part = Math.min(1, Math.max(0, along));
  /** @type {Shares} */
  const shares = [0, 0, 0];
  shares[from] = 1 - part;
  shares[to] = part;
  return shares;
}

/** The shares of a place, or of the nearest one in the triangle. @param {Point} place @returns {Shares} */
export function sharesAt(place) {
  const inside = coordinatesOf(place);
  if (inside.every((share) => share >= 0)) return inside;
  /** @param {Shares} shares */
  const distance = (shares) => {
    const [x, y] = placeOf(shares);
    return Math.hypot(x - place[0], y - place[1]);
  };
  const sides = [onSide(place, 0, 1), onSide(place, 1, 2), onSide(place, 2, 0)];
  return sides.reduce((best, shares) => (distance(shares) < distance(best) ? shares : best));
}

/** Towards the top corner, or straight away from it. @param {Shares} shares @param {number} step */
function raised([top, left, right], step) {
  const next = Math.min(1, Math.max(0, top + step));
  const rest = left + right;
  const part = rest > 0 ? left / rest : 0.5;
  return /** @type {Shares} */ ([next, (1 - next) * part, (1 - next) * (1 - part)]);
}

/** Along the foot of the triangle. @param {Shares} shares @param {number} step to the right */
function shifted([top, left, right], step) {
  const next = Math.min(left + right, Math.max(0, right + step));
  return /** @type {Shares} */ ([top, left + right - next, next]);
}

/**
 * Where a key moves a point: arrows by a step, 1 to 3 to the corners, Home and End to the first and the last, 0 to the
 * middle.
 * @param {Shares} shares
 * @param {string} key as KeyboardEvent names it
 * @param {boolean} large whether steps are ten times as large
 * @returns {Shares | null} null if the key does nothing
 */
export function movedByKey(shares, key, large) {
  const step = large ? LARGE_STEP : STEP;
  switch (key) {
    case 'ArrowUp':
      return raised(shares, step);
    case 'ArrowDown':
      return raised(shares, -step);
    case 'ArrowLeft':
      return shifted(shares, -step);
    case 'ArrowRight':
      return shifted(shares, step);
    case '1':
    case 'Home':
      return [1, 0, 0];
    case '2':
      return [0, 1, 0];
    case '3':
    case 'End':
      return [0, 0, 1];
    case '0':
      return CENTRE;
    default:
      return null;
  }
}
