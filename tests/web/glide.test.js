// SPDX-License-Identifier: MIT
/**
 * @file The motion of the surface from one mesh to the next: linear, never more than one mesh behind, and in the end exact.
 */
import { describe, expect, test } from '@jest/globals';
import { BufferGeometry } from 'three';
import { setComputed, setSurface } from '../../web/scene/geometry.js';
import { PICTURE, createGlide, timingOf } from '../../web/scene/glide.js';
import { mesh } from './studio/state.js';

/** @typedef {import('../../web/scene/stand.js').Extent} Extent */

/** A triangle whose coordinates are all `value`, which no float represents exactly. @param {number} value */
function meshOf(value) {
  const made = mesh();
  made.positions.fill(value);
  made.normals.fill(value / 2);
  made.curvatures.fill(3 * value);
  return made;
}

/** @param {number} value @returns {Extent} */
const extentOf = (value) => ({ centre: [value, 2 * value, 3 * value], radius: 1 + value });

function gliding() {
  const geometry = new BufferGeometry();
  /** @type {Extent[]} */
  const places = [];
  const glide = createGlide(geometry, ({ centre, radius }) => places.push({ centre: [...centre], radius }));
  const array = (/** @type {string} */ name) => /** @type {Float32Array} */ (geometry.getAttribute(name).array);
  /** @param {number} value */
  function jump(value) {
    setSurface(geometry, meshOf(value));
    setComputed(geometry, new Float32Array(3).fill(-value));
    glide.jump(extentOf(value));
  }
  /**
   * @param {number} value
   * @param {{now: number, duration?: number, pictures?: number, shift?: number[], placed?: boolean}} how
   */
  function move(value, { now, duration = 100, pictures = Infinity, shift = [0, 0, 0], placed = true }) {
    glide.keep(shift);
    const next = meshOf(value);
    const computed = new Float32Array(3).fill(-value);
    setSurface(geometry, next);
    setComputed(geometry, computed);
    const { positions: position, normals: normal, curvatures: curvature } = next;
    const newest = { position, normal, curvature, computed };
    glide.begin(newest, placed ? extentOf(value) : null, { now, duration, pictures });
    return newest;
  }
  return { geometry, glide, places, array, jump, move };
}

describe('the surface', () => {
  test('moves linearly, with its normals, curvatures, values and place, and ends exactly at the newest mesh', () => {
    const { glide, places, array, jump, move } = gliding();
    jump(0);
    const newest = move(0.1, { now: 1000 });
    expect(glide.advance(1025)).toBe(true);
    expect(array('position')[4]).toBeCloseTo(0.025, 6);
    expect(array('normal')[4]).toBeCloseTo(0.0125, 6);
    expect(array('curvature')[4]).toBeCloseTo(0.075, 6);
    expect(array('computed')[2]).toBeCloseTo(-0.025, 6);
    expect(places.at(-1)?.radius).toBeCloseTo(1.025, 6);
    expect(places.at(-1)?.centre[2]).toBeCloseTo(0.075, 6);
    expect(glide.advance(1100)).toBe(false);
    for (const [name, values] of Object.entries(newest)) expect([...array(name)]).toEqual([...values]);
    expect(places.at(-1)).toEqual(extentOf(0.1));
    // Nothing is left to draw.
    const drawn = places.length;
    expect(glide.advance(1200)).toBe(false);
    expect(glide.settle()).toBe(false);
    expect(places.length).toBe(drawn);
  });

  test('goes on from what is shown when another mesh comes on its way', () => {
    const { glide, array, jump, move } = gliding();
    jump(0);
    move(1, { now: 0 });
    glide.advance(50);
    move(2, { now: 50 });
    // What is drawn lies between what was on the screen and the newest mesh.
    glide.advance(50);
    expect(array('position')[0]).toBeCloseTo(0.5, 6);
    glide.advance(100);
    expect(array('position')[0]).toBeCloseTo(1.25, 6);
    glide.advance(150);
    expect(array('position')[0]).toBe(2);
  });

  test('is halfway in the first picture and there in the second where it answers the hand, however soon they come', () => {
    const { glide, array, jump, move } = gliding();
    jump(0);
    const timing = timingOf('prompt', 20, 0);
    move(1, { now: 0, ...timing });
    expect(glide.advance(1)).toBe(true);
    expect(array('position')[0]).toBe(0.5);
    expect(glide.advance(2)).toBe(false);
    expect(array('position')[0]).toBe(1);
  });

  test('is the newest mesh from when that is set until the next picture, and at once when it is told to settle', () => {
    const { glide, places, array, jump, move } = gliding();
    jump(0);
    move(0.3, { now: 0 });
    expect(array('position')[0]).toBe(Math.fround(0.3));
    glide.advance(10);
    expect(array('position')[0]).toBeLessThan(0.1);
    expect(glide.settle()).toBe(true);
    expect(array('position')[0]).toBe(Math.fround(0.3));
    expect(places.at(-1)).toEqual(extentOf(0.3));
    expect(glide.advance(20)).toBe(false);
    move(0.4, { now: 30 });
    glide.advance(40);
    jump(0.5);
    expect(glide.advance(50)).toBe(false);
    expect(array('position')[0]).toBe(0.5);
  });

  test('does not jump where the newest mesh has another origin', () => {
    const { glide, places, array, jump, move } = gliding();
    jump(1);
    move(1, { now: 0, shift: [0.5, 0, -0.25] });
    glide.advance(0);
    expect([...array('position')].slice(3, 6)).toEqual([1.5, 1, 0.75]);
    expect(places.at(-1)).toEqual({ centre: [1.5, 2, 2.75], radius: 2 });
  });

  test('stays where it stands while the hand holds its handle', () => {
    const { glide, places, array, jump, move } = gliding();
    jump(1);
    move(2, { now: 0, placed: false });
    glide.advance(50);
    glide.advance(100);
    expect(array('position')[0]).toBe(2);
    expect(places).toEqual([extentOf(1)]);
    move(3, { now: 100 });
    glide.advance(150);
    expect(places.at(-1)?.radius).toBeCloseTo((2 + 4) / 2, 6);
  });

  test('uses the same arrays again in each picture and for each mesh', () => {
    const { geometry, glide, jump, move } = gliding();
    jump(0);
    const attributes = ['position', 'normal', 'curvature', 'computed'].map((name) => geometry.getAttribute(name));
    for (let i = 0; i < 4; i++) {
      move(i, { now: 100 * i });
      glide.advance(100 * i + 40);
    }
    expect(['position', 'normal', 'curvature', 'computed'].map((name) => geometry.getAttribute(name))).toEqual(
      attributes,
    );
  });
});

describe('the time of a motion', () => {
  test('is that between two meshes, and at most 150 ms', () => {
    expect(timingOf('even', 70, 0)).toEqual({ duration: 70, pictures: Infinity });
    expect(timingOf('even', 2000, 0)?.duration).toBe(150);
    expect(timingOf('prompt', 2000, 0)).toEqual({ duration: 2 * PICTURE, pictures: 2 });
  });

  test('is none where pictures are so slow that none would be drawn on the way', () => {
    expect(timingOf('even', 70, 80)).toBeNull();
    expect(timingOf('even', 100, 80)).not.toBeNull();
    expect(timingOf('prompt', 1000, 80)).toBeNull();
  });
});
