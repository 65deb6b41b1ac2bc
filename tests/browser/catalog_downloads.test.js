// SPDX-License-Identifier: MIT
/**
 * @file The catalog's downloads: each file is parsed again, and its surface is closed and has the genus of its row.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { builtPage, openAddress } from './page.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */

const served = servedPage();
const ENTRY = 'two-3.bending';
const GENUS = 2;

/** @param {Page} page @param {() => Promise<void>} press */
async function downloaded(page, press) {
  const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), press()]);
  return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
}

/** @param {string} name of the button in the details */
async function entryFile(name) {
  const { page, errors } = await openAddress(served.browser, `${served.url}?entry=${ENTRY}`);
  const button = page.getByRole('dialog').getByRole('button', { name, exact: true });
  const file = await downloaded(page, () => button.click());
  await page.waitForFunction(() => !document.querySelector('#details [aria-disabled=true]'));
  expect(await page.locator('#details .problem').innerText()).toBe('');
  expect(errors).toEqual([]);
  await page.context().close();
  return file;
}

/**
 * The genus of a closed oriented surface, in which each edge occurs once in each direction.
 * @param {number} vertices
 * @param {number[][]} faces
 * @returns {number} the genus
 */
function genusOf(vertices, faces) {
  /** @type {Set<number>} */
  const edges = new Set();
  for (const face of faces) face.forEach((from, i) => edges.add(from * vertices + face[(i + 1) % face.length]));
  expect(edges.size).toBe(faces.reduce((sum, face) => sum + face.length, 0));
  let open = 0;
  for (const edge of edges) open += Number(!edges.has((edge % vertices) * vertices + Math.floor(edge / vertices)));
  expect(open).toBe(0);
  return (2 - (vertices - edges.size / 2 + faces.length)) / 2;
}

/** @param {string} text */
function parseObj(text) {
  const lines = text.split('\n').map((line) => line.split(/\s+/));
  const vertices = lines.filter(([word]) => word === 'v').map(([, ...numbers]) => numbers.map(Number));
  const faces = lines
    .filter(([word]) => word === 'f')
    .map(([, ...corners]) => corners.filter(Boolean).map((corner) => parseInt(corner, 10) - 1));
  expect(vertices.flat().every(Number.isFinite)).toBe(true);
  expect(faces.flat().reduce((a, b) => Math.max(a, b))).toBe(vertices.length - 1);
  return { vertices, faces, normals: lines.filter(([word]) => word === 'vn').length };
}

/** Parses STL; corners with the same coordinates become one vertex. @param {Buffer} file */
function parseStl(file) {
  const count = file.readUInt32LE(80);
  expect(file.length).toBe(84 + 50 * count);
  /** @type {Map<string, number>} */
  const vertices = new Map();
  const faces = Array.from({ length: count }, (_, face) =>
    [0, 1, 2].map((corner) => {
      const at = 84 + 50 * face + 12 + 12 * corner;
      const key = [0, 4, 8].map((offset) => file.readFloatLE(at + offset)).join(' ');
      if (!vertices.has(key)) vertices.set(key, vertices.size);
      return Number(vertices.get(key));
    }),
  );
  return { vertices: [...vertices.keys()].map((key) => key.split(' ').map(Number)), faces };
}

/** @param {Buffer} file */
function parseGlb(file) {
  expect(file.toString('latin1', 0, 4)).toBe('glTF');
  expect(file.readUInt32LE(4)).toBe(2);
  expect(file.readUInt32LE(8)).toBe(file.length);
  const length = file.readUInt32LE(12);
  const document = JSON.parse(file.toString('utf8', 20, 20 + length));
  const [primitive] = document.meshes[0].primitives;
  const binary = file.subarray(20 + length + 8);
  /** @param {number} accessor @returns {number[]} */
  const numbers = (accessor) => {
    const { bufferView, byteOffset = 0, count, type, componentType } = document.accessors[accessor];
    const start = (document.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    const size = /** @type {Record<string, number>} */ ({ SCALAR: 1, VEC3: 3 })[type] * count;
    expect([5125, 5126]).toContain(componentType);
    return Array.from({ length: size }, (_, i) =>
      componentType === 5126 ? binary.readFloatLE(start + 4 * i) : binary.readUInt32LE(start + 4 * i),
    );
  };
  const indices = numbers(primitive.indices);
  return {
    positions: numbers(primitive.attributes.POSITION),
    normals: numbers(primitive.attributes.NORMAL),
    faces: Array.from({ length: indices.length / 3 }, (_, i) => indices.slice(3 * i, 3 * i + 3)),
  };
}

/** @param {number[][]} vertices @returns {number} */
function largestExtent(vertices) {
  return Math.max(
    ...[0, 1, 2].map((axis) => {
      const values = vertices.map((vertex) => vertex[axis]);
      return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
    }),
  );
}

/** @returns {Catalog} */
const catalog = () => JSON.parse(readFileSync(path.join(builtPage, 'catalog/catalog.json'), 'utf8'));
const entry = () => catalog().entries.find(({ shape, functional }) => `${shape}.${functional}` === ENTRY);

describe('an entry’s', () => {
  test('generated cage is an OBJ file', async () => {
    const { name, content } = await entryFile('Cage');
    expect(name).toBe('two-3.cage.obj');
    const { vertices, faces } = parseObj(content.toString());
    expect([vertices.length, faces.length]).toEqual([22, 24]);
    expect(genusOf(vertices.length, faces)).toBe(GENUS);
  });

  test('control mesh is an OBJ file with all digits', async () => {
    const { name, content } = await entryFile('Control mesh');
    expect(name).toBe(`${ENTRY}.control.obj`);
    const { vertices, faces } = parseObj(content.toString());
    expect(faces).toHaveLength(entry()?.faces ?? 0);
    expect(genusOf(vertices.length, faces)).toBe(GENUS);
    const { points } = JSON.parse(readFileSync(path.join(builtPage, `catalog/${ENTRY}.json`), 'utf8')).surface;
    // Symmetry moves a point onto its axis up to rounding.
    for (const axis of [0, 1, 2]) expect(Math.abs(vertices[0][axis] - points[axis])).toBeLessThan(1e-14);
  });

  test('limit mesh is an OBJ file of quads with normals', async () => {
    const { name, content } = await entryFile('Limit mesh');
    expect(name).toBe(`${ENTRY}.limit.obj`);
    const { vertices, faces, normals } = parseObj(content.toString());
    expect(faces.every((face) => face.length === 4)).toBe(true);
    expect(normals).toBe(vertices.length);
    expect(faces.length).toBeGreaterThan(10_000);
    expect(genusOf(vertices.length, faces)).toBe(GENUS);
  }, 60_000);

  test('STL is closed and 100 mm across', async () => {
    const { name, content } = await entryFile('STL');
    expect(name).toBe(`${ENTRY}.stl`);
    const { vertices, faces } = parseStl(content);
    expect(genusOf(vertices.length, faces)).toBe(GENUS);
    // The coordinates have single precision.
    expect(Math.abs(largestExtent(vertices) - 100)).toBeLessThan(1e-4);
  }, 60_000);

  test('GLB is glTF 2.0 with unit normals, 1 m across', async () => {
    const { name, content } = await entryFile('GLB');
    expect(name).toBe(`${ENTRY}.glb`);
    const { positions, normals, faces } = parseGlb(content);
    const vertices = Array.from({ length: positions.length / 3 }, (_, i) => positions.slice(3 * i, 3 * i + 3));
    expect(genusOf(vertices.length, faces)).toBe(GENUS);
    expect(normals).toHaveLength(positions.length);
    expect(Math.abs(Math.hypot(...normals.slice(0, 3)) - 1)).toBeLessThan(1e-5);
    expect(Math.abs(largestExtent(vertices) - 1)).toBeLessThan(1e-5);
  }, 60_000);
});

describe('the whole table', () => {
  test('is CSV with a line for each entry, and JSON as it is', async () => {
    const { page, errors } = await openAddress(served.browser, served.url);
    await page.locator('#table tbody tr').first().waitFor();
    const csv = await downloaded(page, () => page.getByRole('button', { name: 'CSV' }).click());
    expect(csv.name).toBe('umbilic-catalog.csv');
    const lines = csv.content.toString().trimEnd().split('\r\n');
    const { entries } = catalog();
    expect(lines).toHaveLength(entries.length + 1);
    const energy = lines[0].split(',').indexOf('energy');
    expect(Number(lines[1].split(',')[energy])).toBe(entries[0].energy);

    const json = await downloaded(page, () => page.getByRole('link', { name: 'JSON' }).click());
    expect(json.name).toBe('umbilic-catalog.json');
    expect(JSON.parse(json.content.toString())).toEqual(catalog());
    expect(errors).toEqual([]);
    await page.context().close();
  });
});
