// SPDX-License-Identifier: MIT
/**
 * @file The files of meshes that the worker makes, read again by programs that others wrote: closed and oriented outwards for a
 * solid modeller, valid glTF, and PLY with the curvatures of a sphere's radius.
 */
import { describe, expect, test } from '@jest/globals';
import { NodeIO } from '@gltf-transform/core';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { Cage, Minimizer } from '../../wasm/umbilic.js';
import { mapBytes, MAP_SIZE } from '../../web/colour/maps.js';
import { encode } from '../../web/colour/oklab.js';
import { finenesses, sizeOf, usualFineness } from '../../web/pages/studio/downloads.js';
import { open, session, useSession, work } from './session_harness.js';
import { solidOf } from './solid.js';

/** @typedef {import('../../web/worker/protocol.js').Exportable} Exportable */
/** @typedef {import('../../web/worker/protocol.js').ExportOptions} ExportOptions */

useSession();

/** A cube's cage far from the origin, of which the surface is about a sphere. */
const PLACE = [100, -50, 20];
const text = [
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((i) => {
    const [x, y, z] = [i & 1, (i >> 1) & 1, i >> 2].map((bit, axis) => PLACE[axis] + 2 * bit - 1);
    return `v ${x} ${y} ${z}`;
  }),
  ...['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`),
].join('\n');

/** @param {Exportable} what @param {ExportOptions} [options] @returns {any} the file of the open run */
function saved(what, options) {
  session.obey({ type: 'export', run: 1, what, options });
  const message = session.messages.at(-1);
  expect(message).toMatchObject({ type: 'exported', run: 1, what });
  return message.content;
}

/** Opens the cage, at level 2. */
function openCube() {
  open(1, { cage: { text }, levels: [2, 2] });
  work();
}

/** The middle and the sides of a box. @param {{min: readonly number[], max: readonly number[]}} box */
const boxOf = ({ min, max }) => ({
  middle: [0, 1, 2].map((axis) => (min[axis] + max[axis]) / 2),
  sides: [0, 1, 2].map((axis) => max[axis] - min[axis]),
});

/** @param {number[]} found @param {number[]} expected @param {number} tolerance */
function near(found, expected, tolerance) {
  expected.forEach((value, i) => expect(Math.abs(found[i] - value)).toBeLessThan(tolerance));
}

/** @param {Uint8Array} file */
const read = async (file) => new NodeIO().readBinary(file);

describe('STL', () => {
  test('is a solid for a modeller, with its outside out, where the cage is and as large', async () => {
    openCube();
    const found = await solidOf(saved('stl', { density: 4 }));
    expect(found.status()).toBe('NoError');
    expect(found.numTri()).toBe(2 * 96 * 4 ** 2);
    expect(found.genus()).toBe(0);
    // A negative volume would have its outside in.
    expect(found.volume()).toBeGreaterThan(1);
    const { middle, sides } = boxOf(found.boundingBox());
    near(middle, PLACE, 1e-4);
    expect(Math.max(...sides)).toBeLessThan(2);
    found.delete();
  });

  test('has the genus of its surface, and the longest side that is asked for', async () => {
    open(1, { cage: { generator: 'tetrahedron-frame' }, levels: [0, 0] });
    work();
    const found = await solidOf(saved('stl', { density: 3, extent: 80 }));
    expect([found.status(), found.genus()]).toEqual(['NoError', 3]);
    expect(found.volume()).toBeGreaterThan(0);
    const { middle, sides } = boxOf(found.boundingBox());
    expect(Math.abs(Math.max(...sides) - 80)).toBeLessThan(1e-4);
    near(middle, [0, 0, 0], 1e-4);
    found.delete();
  });
});

describe('GLB', () => {
  test('has one model with normals, y upwards, at the place of the cage', async () => {
    openCube();
    const document = await read(new Uint8Array(saved('glb', { density: 2, up: 'z', name: 'ball' })));
    const [node] = document.getRoot().listNodes();
    const [x, y, z] = PLACE;
    near(node.getTranslation(), [x, z, -y], 1e-5);
    expect(node.getName()).toBe('ball');
    const [primitive] = node.getMesh()?.listPrimitives() ?? [];
    expect(primitive.getIndices()?.getCount()).toBe(3 * 2 * 96 * 2 ** 2);
    expect(primitive.getAttribute('COLOR_0')).toBeNull();
    const positions = primitive.getAttribute('POSITION');
    const normals = primitive.getAttribute('NORMAL');
    for (const vertex of [0, 1, 17, 200]) {
      const [position, normal] = [positions, normals].map((column) => column?.getElement(vertex, []) ?? []);
      expect(Math.abs(Math.hypot(...normal) - 1)).toBeLessThan(1e-6);
      // About a sphere, on which both point the same way.
      const outwards = position.reduce((sum, value, axis) => sum + value * normal[axis], 0) / Math.hypot(...position);
      expect(outwards).toBeGreaterThan(0.9);
    }
  });

  test('has the colours of the shading, which are linear in glTF', async () => {
    openCube();
    const { curvatures } = new Minimizer({
      cage: { text },
      terms: { bending: 1 },
      options: { levels: [2, 2] },
    }).limitMesh(2);
    const colouring = { shading: /** @type {const} */ ('kappa1'), low: -1, high: 2 };
    const document = await read(new Uint8Array(saved('glb', { density: 2, colouring })));
    const colours = document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('COLOR_0');
    const bytes = mapBytes('diverging');
    for (const vertex of [0, 5, 100, 300]) {
      const kappa = curvatures[2 * vertex];
      const share = 0.5 + 0.5 * (kappa < 0 ? kappa : kappa / 2); // the middle of the colours is 0, as on the screen
      const entry = Math.round((MAP_SIZE - 1) * Math.min(1, Math.max(0, share)));
      const [red, green, blue, alpha] = colours?.getElement(vertex, /** @type {number[]} */ ([])) ?? [];
      near(
        [red, green, blue].map((value) => 255 * encode(value)),
        [...bytes.subarray(4 * entry, 4 * entry + 3)],
        0.51,
      );
      expect(alpha).toBe(1);
    }
    expect(saved('glb', { density: 2, colouring: { ...colouring, shading: 'plain' } }).byteLength).toBeLessThan(
      saved('glb', { density: 2, colouring }).byteLength,
    );
  });
});

describe('PLY', () => {
  /** @param {ExportOptions} options */
  function loaded(options) {
    const loader = new PLYLoader();
    loader.setCustomPropertyNameMapping({ curvature: ['kappa1', 'kappa2', 'mean_curvature', 'gaussian_curvature'] });
    const geometry = loader.parse(saved('ply', options));
    geometry.computeBoundingBox();
    return geometry;
  }

  test('has normals and curvatures at each vertex, in units of the file', () => {
    openCube();
    const geometry = loaded({ density: 4 });
    const { min, max } = /** @type {import('three').Box3} */ (geometry.boundingBox);
    near(min.clone().add(max).multiplyScalar(0.5).toArray(), PLACE, 1e-5);
    expect(geometry.getIndex()?.count).toBe(3 * 2 * 96 * 4 ** 2);
    const curvatures = geometry.getAttribute('curvature').array;
    expect(geometry.getAttribute('normal').count).toBe(curvatures.length / 4);
    const radius = (max.x - min.x) / 2;
    for (let i = 0; i < curvatures.length; i += 4) {
      const [kappa1, kappa2, mean, gaussian] = curvatures.subarray(i, i + 4);
      near([mean, gaussian], [(kappa1 + kappa2) / 2, kappa1 * kappa2], 1e-5);
      // About those of the sphere, which the surface of a cube's cage is not quite.
      expect(mean * radius).toBeGreaterThan(0.5);
      expect(mean * radius).toBeLessThan(2);
    }
  });

  test('of another size has the curvatures of that', () => {
    openCube();
    const [own, large] = [loaded({ density: 1 }), loaded({ density: 1, extent: 50 })].map((geometry) => {
      const { min, max } = /** @type {import('three').Box3} */ (geometry.boundingBox);
      return { side: max.x - min.x, curvatures: geometry.getAttribute('curvature').array };
    });
    expect(Math.abs(large.side - 50)).toBeLessThan(1e-5);
    const scale = large.side / own.side;
    near(
      [...large.curvatures.subarray(0, 3)].map((value) => value * scale),
      [...own.curvatures.subarray(0, 3)],
      1e-4,
    );
    expect(Math.abs((large.curvatures[3] * scale ** 2) / own.curvatures[3] - 1)).toBeLessThan(1e-4);
  });
});

describe('OBJ', () => {
  test('refined to quads is another cage of the same surface', () => {
    const pentagons =
      'v 0 0 1\nv 1 0 0\nv 0.3 0.9 0\nv -0.8 0.6 0\nv -0.8 -0.6 0\nv 0.3 -0.9 0\nf 2 3 4 5 6\nf 1 3 2\nf 1 4 3\nf 1 5 4\nf 1 6 5\nf 1 2 6\n';
    open(1, { cage: { text: pentagons }, levels: [0, 0] });
    work();
    for (const steps of [1, 2]) {
      const refined = Cage.read(saved('quads', { steps }));
      expect(refined.counts).toMatchObject({ genus: 0, faces: 20 * 4 ** (steps - 1) });
      expect(refined.mesh().triangles.length / 3).toBe(2 * 20 * 4 ** (steps - 1));
      refined.dispose();
    }
    expect(saved('quads', { steps: 1 })).not.toMatch(/^f( \d+){5}/m);
    expect(saved('control')).toMatch(/^f( \d+){5}/m);
  });
});

describe('the size that is said before a file is saved', () => {
  test('is about that of the file', () => {
    open(1, { cage: { generator: 'two-3' }, levels: [1, 1] });
    work();
    const { patches, control } = session.messages.findLast(({ type }) => type === 'surfaced');
    const counts = { patches, vertices: control.positions.length / 3 };
    expect(counts.patches).toBe(96);
    const { density } = usualFineness(finenesses(patches));
    const colouring = { shading: /** @type {const} */ ('mean'), low: -1, high: 1 };
    for (const what of /** @type {const} */ (['control', 'quads', 'limit', 'ply', 'stl', 'glb'])) {
      const file = saved(what, { density, colouring });
      const said = Number(sizeOf(what, { density, colouring }, counts));
      expect(said / (file.byteLength ?? file.length)).toBeGreaterThan(0.8);
      expect(said / (file.byteLength ?? file.length)).toBeLessThan(1.25);
      // The usual files of a small cage are quick to send.
      expect(said).toBeLessThan(6e6);
    }
  });

  test.each([1, 24, 96, 5000, 3e6])('comes with densities to choose from, for %d patches', (patches) => {
    const offered = finenesses(patches);
    const usual = usualFineness(offered);
    expect(offered).toContain(usual);
    expect(offered.slice(1).every(({ triangles }) => triangles <= 2e6)).toBe(true);
    if (patches < 1e4) expect(usual.triangles).toBeLessThanOrEqual(60_000);
  });
});
