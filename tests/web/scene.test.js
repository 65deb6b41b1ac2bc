// SPDX-License-Identifier: MIT
/**
 * @file The parts of the scene that need no graphics: arrays handed to three.js, the extent of a surface, where it and the camera stand, and the pace of
 * frames.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { afterEach, beforeEach, describe, expect, test } from '@jest/globals';
import { BufferGeometry, Vector3 } from 'three';
import { extent, setComputed, setEdges, setParts, setSurface } from '../../web/scene/geometry.js';
import { splitHeld } from '../../web/scene/held.js';
import { createPace } from '../../web/scene/pace.js';
import { nearestVertex, pick } from '../../web/scene/pick.js';
import { cameraOf, fittingDistance, placementOf } from '../../web/scene/placement.js';
import { createStand } from '../../web/scene/stand.js';
import { mesh } from './studio/state.js';

describe('a geometry', () => {
  test('keeps its arrays while the mesh only moves, and is replaced when it has other counts', () => {
    const geometry = new BufferGeometry();
    let disposals = 0;
    geometry.addEventListener('dispose', () => disposals++);
    const first = mesh();
    setSurface(geometry, first);
    const [position, index] = [geometry.getAttribute('position'), geometry.getIndex()];
    const moved = mesh();
    moved.positions.fill(2);
    setSurface(geometry, moved);
    expect(geometry.getAttribute('position')).toBe(position);
    expect(geometry.getIndex()).toBe(index);
    expect(position.getX(1)).toBe(2);
    expect(disposals).toBe(0);
    // The first one can be shown again.
    setSurface(geometry, first);
    expect(position.getX(1)).toBe(0);

    const larger = {
      ...mesh(),
      positions: new Float32Array(12),
      normals: new Float32Array(12),
      curvatures: new Float32Array(8),
    };
    larger.triangles = new Uint32Array([0, 1, 2, 0, 2, 3]);
    setSurface(geometry, larger);
    expect(geometry.getAttribute('position').count).toBe(4);
    expect(geometry.getIndex()?.count).toBe(6);
    expect(disposals).toBe(1);
  });

  test('gets no curvature that a graphics card cannot interpolate', () => {
    const geometry = new BufferGeometry();
    const steep = mesh();
    steep.curvatures.set([Infinity, -Infinity, NaN, 1, -2, 3e38]);
    setSurface(geometry, steep);
    const values = [...geometry.getAttribute('curvature').array];
    expect(values[2]).toBe(0);
    expect(values[3]).toBe(1);
    for (const value of values) expect(Math.abs(value)).toBeLessThanOrEqual(1.0001e12);
  });

  test('has computed values only while there are some', () => {
    const geometry = new BufferGeometry();
    setSurface(geometry, mesh());
    setComputed(geometry, Float32Array.of(0, 1, -2));
    expect([...geometry.getAttribute('computed').array]).toEqual([0, 1, -2]);
    setComputed(geometry, Float32Array.of(0, NaN, Infinity));
    expect([...geometry.getAttribute('computed').array]).toEqual([0, 0, Math.fround(1e12)]);
    setComputed(geometry, null);
    expect(geometry.hasAttribute('computed')).toBe(false);
  });

  test('of a cage has its edges as index', () => {
    const geometry = new BufferGeometry();
    setEdges(geometry, mesh());
    expect([...(geometry.getIndex()?.array ?? [])]).toEqual([0, 1, 1, 2, 2, 0]);
  });

  test('extends from the middle of its box to its farthest vertex', () => {
    expect(extent(Float32Array.from([0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0, 4]))).toEqual({ centre: [1, 2, 2], radius: 3 });
  });
});

/** A strip of four unit squares along x, two triangles over each; vertex 2 i is (i, 0, 0), vertex 2 i + 1 is (i, 1, 0). */
function strip() {
  const corners = [0, 1, 2, 3].flatMap((i) => [2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1]);
  const positions = Array.from({ length: 10 }, (_, v) => [Math.floor(v / 2), v % 2, 0]).flat();
  return {
    ...mesh(),
    positions: Float32Array.from(positions),
    normals: new Float32Array(30),
    curvatures: new Float32Array(20),
    triangles: Uint32Array.from(corners),
    faces: Uint32Array.of(0, 0, 1, 1, 2, 2, 3, 3),
  };
}

describe('held faces', () => {
  /** Sets of corners, in an order that does not depend on that of triangles. @param {Uint32Array} indices @param {number} size */
  function sorted(indices, size) {
    const sets = Array.from({ length: indices.length / size }, (_, i) => [...indices.slice(size * i, size * i + size)]);
    return sets.map((set) => set.sort((a, b) => a - b).join(' ')).sort();
  }

  test('are drawn after the free ones, and their rim is the edges between both', () => {
    const { triangles } = strip();
    const parts = splitHeld(strip(), Uint8Array.of(0, 1, 1, 0));
    expect(parts.free).toBe(12);
    const outer = new Uint32Array([...triangles.slice(0, 6), ...triangles.slice(18)]);
    expect(sorted(parts.triangles.slice(0, 12), 3)).toEqual(sorted(outer, 3));
    expect(sorted(parts.triangles.slice(12), 3)).toEqual(sorted(triangles.slice(6, 18), 3));
    expect(sorted(parts.rim, 2)).toEqual(['2 3', '6 7']);
  });

  test('of one free vertex, whose triangles are all free, have no rim there', () => {
    expect([...splitHeld(strip(), Uint8Array.of(0, 0, 0, 0)).rim]).toEqual([]);
    expect([...splitHeld(strip(), Uint8Array.of(1, 1, 1, 1)).rim]).toEqual([]);
    expect(splitHeld(strip(), null)).toMatchObject({ free: 24 });
  });

  test('have a material of their own', () => {
    const geometry = new BufferGeometry();
    setSurface(geometry, strip(), Uint8Array.of(0, 1, 1, 0));
    expect(geometry.groups).toEqual([
      { start: 0, count: 12, materialIndex: 0 },
      { start: 12, count: 12, materialIndex: 1 },
    ]);
    setParts(geometry, strip(), null);
    expect(geometry.groups).toEqual([{ start: 0, count: 24, materialIndex: 0 }]);
  });
});

describe('a ray', () => {
  test('meets the nearest triangle from either side, and says the face of the cage', () => {
    const low = strip();
    const high = { ...strip(), faces: Uint32Array.of(4, 4, 5, 5, 6, 6, 7, 7) };
    const both = {
      positions: Float32Array.from([...low.positions, ...high.positions.map((x, i) => (i % 3 === 2 ? 1 : x))]),
      triangles: Uint32Array.from([...low.triangles, ...high.triangles.map((v) => v + 10)]),
      faces: Uint32Array.from([...low.faces, ...high.faces]),
    };
    expect(pick(both, [2.25, 0.5, 5], [0, 0, -1])).toMatchObject({ face: 6, point: [2.25, 0.5, 1] });
    expect(pick(both, [2.25, 0.5, -5], [0, 0, 2])).toMatchObject({ face: 2, point: [2.25, 0.5, 0] });
    expect(pick(both, [2.25, 0.5, 0.5], [0, 0, -1])?.face).toBe(2);
    expect(pick(both, [4.25, 0.5, 5], [0, 0, -1])).toBeNull();
    expect(pick(both, [2.25, 0.5, 5], [0, 0, 1])).toBeNull();
    expect(pick(both, [0, 0.5, 0.25], [1, 0, 0])).toBeNull();
  });

  test('is met through its edges and corners as well', () => {
    const rings = 8;
    const sphere = { positions: /** @type {number[]} */ ([]), triangles: /** @type {number[]} */ ([]) };
    for (let i = 0; i <= rings; i++) {
      for (let j = 0; j < 2 * rings; j++) {
        const [polar, around] = [(Math.PI * i) / rings, (Math.PI * j) / rings];
        const radius = Math.sin(polar);
        sphere.positions.push(radius * Math.cos(around), radius * Math.sin(around), Math.cos(polar));
        if (i === rings) continue;
        const [a, b] = [2 * rings * i + j, 2 * rings * i + ((j + 1) % (2 * rings))];
        sphere.triangles.push(a, a + 2 * rings, b + 2 * rings, a, b + 2 * rings, b);
      }
    }
    const closed = {
      positions: new Float32Array(sphere.positions),
      triangles: new Uint32Array(sphere.triangles),
      faces: new Uint32Array(sphere.triangles.length / 3),
    };
    const eye = /** @type {[number, number, number]} */ ([3.1, 2.2, 1.7]);
    for (let t = 0; t < closed.triangles.length; t++) {
      const [a, b] = [3 * closed.triangles[t], 3 * closed.triangles[t - (t % 3) + ((t + 1) % 3)]];
      for (const part of [0, 0.25, 0.5, 0.75]) {
        const along = /** @type {[number, number, number]} */ (
          eye.map((x, c) => closed.positions[a + c] * (1 - part) + closed.positions[b + c] * part - x)
        );
        const hit = pick(closed, eye, along);
        const distance = Math.hypot(...(hit?.point ?? [Infinity]).map((x, c) => x - eye[c]));
        expect(distance).toBeLessThan(Math.hypot(...along) + 1e-5); // not through the front to what is behind it
      }
    }
  });

  test('is nearest to one of the vertices of the cage at the face that it meets', () => {
    const hit = { face: 1, point: /** @type {[number, number, number]} */ ([1.9, 0.2, 0]) };
    expect(nearestVertex(strip(), hit, 10)).toBe(4);
    expect(nearestVertex(strip(), hit, 4)).toBe(2);
    expect(nearestVertex(strip(), hit, 2)).toBe(-1);
  });
});

describe('a surface', () => {
  /** Where a point of the model is in the world. @param {ReturnType<typeof createStand>} stand @param {...number} point */
  function inWorld({ object, model }, ...point) {
    object.updateMatrixWorld(true);
    return new Vector3(...point).applyMatrix4(model.matrixWorld).toArray();
  }

  test('stands about the origin with radius 1 wherever it lies, also after it has moved and been told again', () => {
    const stand = createStand();
    for (const [centre, radius] of /** @type {Array<[[number, number, number], number]>} */ ([
      [[50, -30, 20], 2],
      [[48, -30, 21], 0.5],
      [[48, -30, 21], 0.5],
      [[0, 0, 0], 1e-6],
      [[1e6, 0, 0], 1],
    ])) {
      stand.centre({ centre, radius });
      // Rounded are the factor and the product with the centre.
      const digits = 15 - Math.ceil(Math.log10(1 + Math.max(...centre.map(Math.abs)) / radius));
      inWorld(stand, ...centre).forEach((value) => expect(value).toBeCloseTo(0, digits));
      const [x, y, z] = inWorld(stand, centre[0] + radius, centre[1], centre[2]);
      expect(Math.hypot(x, y, z)).toBeCloseTo(1, digits);
    }
  });

  test('is turned about its own centre when the axis that points upwards changes', () => {
    const stand = createStand();
    stand.centre({ centre: [50, -30, 20], radius: 2 });
    stand.setUp('z');
    const centre = inWorld(stand, 50, -30, 20);
    const top = inWorld(stand, 50, -30, 22);
    centre.forEach((value) => expect(value).toBeCloseTo(0, 12));
    [0, 1, 0].forEach((value, axis) => expect(top[axis]).toBeCloseTo(value, 12));
  });

  test('without an extent is drawn in its own size', () => {
    const stand = createStand();
    for (const radius of [0, NaN, Infinity]) {
      stand.centre({ centre: [1, 2, 3], radius });
      expect(inWorld(stand, 2, 2, 3)).toEqual([1, 0, 0]);
    }
  });
});

describe('where the camera stands', () => {
  test.each([
    { azimuth: 0, elevation: 0, distance: 1, target: [0, 0, 0] },
    { azimuth: -123.4, elevation: 56.7, distance: 2.5, target: [0.1, -0.25, 3] },
    { azimuth: 38.7, elevation: 90, distance: 0.05, target: [0, 0, 0] },
    { azimuth: 180, elevation: -89.9, distance: 8, target: [0, 0, 0] },
  ])('for %j leads back to it, whatever the shape of the picture', (numbers) => {
    const camera = /** @type {import('../../web/address/camera.js').Camera} */ (numbers);
    for (const aspect of [0.5, 1, 2]) expect(cameraOf(placementOf(camera, aspect), aspect)).toEqual(camera);
  });

  test('is on the axis at elevation 90, and where the unit ball touches the picture’s edges less the margin', () => {
    const { position, target } = placementOf({ azimuth: 0, elevation: 90, distance: 1, target: [0, 0, 0] }, 1);
    expect(target.toArray()).toEqual([0, 0, 0]);
    const away = position.clone().sub(target);
    // Less than a tenth of a degree from it, so that the azimuth is not lost.
    expect(away.y).toBeCloseTo(fittingDistance(1), 6);
    expect(Math.hypot(away.x, away.z)).toBeLessThan(1e-3 * away.y);
    // The angle from the ball's centre to its outline is asin(radius / distance).
    for (const [aspect, half] of [
      [1, 14],
      [3, 14],
      [0.5, (Math.atan(Math.tan((14 * Math.PI) / 180) / 2) * 180) / Math.PI],
    ]) {
      const angle = (Math.asin(1 / fittingDistance(aspect)) * 180) / Math.PI;
      expect(angle).toBeLessThan(half);
      expect(angle).toBeGreaterThan(0.8 * half);
    }
  });
});

describe('the pace of frames', () => {
  const request = globalThis.requestAnimationFrame;
  const cancel = globalThis.cancelAnimationFrame;
  beforeEach(() => {
    globalThis.requestAnimationFrame = (callback) => Number(setTimeout(() => callback(performance.now()), 1));
    globalThis.cancelAnimationFrame = (frame) => clearTimeout(frame);
  });
  afterEach(() => {
    globalThis.requestAnimationFrame = request;
    globalThis.cancelAnimationFrame = cancel;
  });

  test('makes one frame of many requests, and none of none', async () => {
    let frames = 0;
    const pace = createPace(() => frames++);
    for (let i = 0; i < 10; i++) pace.request();
    await sleep(100);
    expect(frames).toBe(1);
    expect(pace.interval()).toBe(0);
    pace.request();
    await sleep(100);
    expect(frames).toBe(2);
    pace.dispose();
  });

  test('goes on while drawing asks for more, and rests when it does not', async () => {
    let frames = 0;
    const pace = createPace(() => {
      frames++;
      if (frames < 5) pace.request();
    });
    pace.request();
    await sleep(300);
    expect(frames).toBe(5);
    pace.dispose();
  });

  test('leaves at least half of the time to the page where frames are slow', async () => {
    let drawing = 0;
    const pace = createPace(() => {
      const start = performance.now();
      while (performance.now() - start < 50);
      drawing += performance.now() - start;
      pace.request();
    });
    const start = performance.now();
    pace.request();
    await sleep(1000);
    const time = performance.now() - start;
    expect(pace.interval()).toBeGreaterThanOrEqual(100);
    pace.dispose();
    expect(drawing).toBeGreaterThan(100);
    // One frame that has begun and has no pause behind it yet is allowed for.
    expect(drawing).toBeLessThan(0.5 * time + 60);
  });

  test('ends when it is disposed of', async () => {
    let frames = 0;
    const pace = createPace(() => frames++);
    pace.request();
    pace.dispose();
    await sleep(50);
    expect(frames).toBe(0);
  });
});
