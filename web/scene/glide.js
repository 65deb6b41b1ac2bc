// SPDX-License-Identifier: MIT
/**
 * @file Moves the surface from what is on the screen to the newest mesh of the same topology, a part of the way in each
 * picture. Writes into the geometry's own arrays, so that the lines that share its positions move with it.
 *
 * Writing 25 000 vertices takes less than 1 ms in Chromium, of a picture of 50 ms and more where there is no graphics hardware;
 * what mixing two sets of attributes in the vertex shader would save there is less than by how much pictures differ.
 */

/** @import {BufferGeometry} from 'three' */
/** @import {Extent} from './stand.js' */

/** Milliseconds between two pictures of a motion. */
export const PICTURE = 1000 / 30;
/** The longest time in milliseconds by which the surface on the screen is behind the newest. */
const LONGEST = 150;

const ATTRIBUTES = /** @type {const} */ (['position', 'normal', 'curvature', 'computed']);

/**
 * How the surface comes to the newest mesh. `even`: within the time between two meshes. `prompt`, if that answers the
 * hand: halfway in the first picture, and there in the second.
 * @typedef {'even' | 'prompt'} Motion
 */

/** At the latest after `duration` milliseconds, and after as many pictures. @typedef {{duration: number, pictures: number}} Timing */

/**
 * @param {Motion} motion
 * @param {number} since milliseconds since the mesh before
 * @param {number} interval the shortest time between two pictures, in milliseconds
 * @returns {Timing | null} null if no picture between the meshes can be drawn in time
 */
export function timingOf(motion, since, interval) {
  const timing =
    motion === 'prompt'
      ? { duration: 2 * PICTURE, pictures: 2 }
      : { duration: Math.min(LONGEST, since), pictures: Infinity };
  return interval <= timing.duration ? timing : null;
}

/** @param {Extent} target changed in place @param {Extent} from @param {Extent} to @param {number} part */
function mixExtents(target, from, to, part) {
  for (let i = 0; i < 3; i++) target.centre[i] = from.centre[i] + part * (to.centre[i] - from.centre[i]);
  target.radius = from.radius + part * (to.radius - from.radius);
}

/** @returns {Extent} */
const nowhere = () => ({ centre: [0, 0, 0], radius: 1 });

/**
 * @param {BufferGeometry} geometry
 * @param {(extent: Extent) => void} place called with the extent of what is shown
 */
export function createGlide(geometry, place) {
  /** What was shown when the newest mesh came; kept, so that its memory is used again. @type {Map<string, Float32Array>} */
  const kept = new Map();
  /** What moves. @type {Array<{name: string, from: Float32Array, to: Float32Array}>} */
  let moving = [];
  let timing = { duration: 0, pictures: 0 };
  let begun = 0;
  let pictures = 0;
  const [shown, first, last] = [nowhere(), nowhere(), nowhere()];
  /** Whether the surface is placed anew while it moves. */
  let placed = false;

  /** @param {number} part of the way, up to 1 */
  function write(part) {
    for (const { name, from, to } of moving) {
      const attribute = geometry.getAttribute(name);
      const { array } = attribute;
      if (part === 1) array.set(to);
      else for (let i = 0; i < array.length; i++) array[i] = from[i] + part * (to[i] - from[i]);
      attribute.needsUpdate = true;
    }
    if (placed) {
      if (part === 1) mixExtents(shown, last, last, 0);
      else mixExtents(shown, first, last, part);
      place(shown);
    }
    if (part === 1) moving = [];
  }

  return {
    /**
     * Keeps what is shown; call it before the newest mesh is set in the geometry.
     * @param {readonly number[]} shift what leads from the mesh's coordinates to those of the newest
     */
    keep(shift) {
      for (const name of ATTRIBUTES) {
        const array = geometry.getAttribute(name)?.array;
        if (!array) {
          kept.delete(name);
          continue;
        }
        const copy = kept.get(name)?.length === array.length ? kept.get(name) : new Float32Array(array.length);
        copy?.set(array);
        if (copy) kept.set(name, copy);
      }
      const positions = kept.get('position') ?? [];
      if (shift.some(Boolean)) for (let i = 0; i < positions.length; i++) positions[i] += shift[i % 3];
      mixExtents(first, shown, shown, 0);
      for (let i = 0; i < 3; i++) first.centre[i] += shift[i];
    },

    /**
     * Begins to move from what was kept to the newest mesh, which the geometry has.
     * @param {Partial<Record<typeof ATTRIBUTES[number], Float32Array | null>>} newest its arrays, by the names of attributes; not changed while it moves
     * @param {Extent | null} extent of it; null if the surface is not placed anew
     * @param {Timing & {now: number}} when `now` in milliseconds
     */
    begin(newest, extent, { now, ...rest }) {
      moving = [];
      for (const name of ATTRIBUTES) {
        const [from, to] = [kept.get(name), newest[name]];
        if (from && to && from.length === to.length) moving.push({ name, from, to });
      }
      placed = extent !== null;
      if (extent) mixExtents(last, extent, extent, 0);
      [timing, begun, pictures] = [rest, now, 0];
    },

    /** Shows the mesh that the geometry has as it is. @param {Extent | null} extent of it; null if it is not placed anew */
    jump(extent) {
      moving = [];
      if (!extent) return;
      mixExtents(shown, extent, extent, 0);
      place(shown);
    },

    /** Moves on; call it before each picture. @param {number} now milliseconds @returns {boolean} whether there is more to come */
    advance(now) {
      if (!moving.length) return false;
      pictures++;
      write(Math.min(1, Math.max((now - begun) / timing.duration, pictures / timing.pictures)));
      return moving.length > 0;
    },

    /** Shows the newest mesh exactly, at once. @returns {boolean} whether that is a change */
    settle() {
      if (!moving.length) return false;
      write(1);
      return true;
    },
  };
}
