// SPDX-License-Identifier: MIT
/**
 * @file The surface moves between two meshes of a run, in pictures of its own; with reduced motion it does not. In the end it is
 * the newest mesh, to the pixel, and nothing is drawn any more.
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { dropFile, measured, openAddress, settled, status } from './page.js';
import { servedPage } from './served.js';
import { serve } from './site.js';

/** @typedef {import('playwright-core').Page} Page */

const served = servedPage();
/** A surface of genus 2 without symmetry. */
const text = readFileSync(new URL('../core/reference/g2.obj', import.meta.url), 'utf8');
const small = { viewport: { width: 400, height: 300 }, deviceScaleFactor: 0.25 };

/** To be called before the page loads. Counts its frames, and its pictures by their kind. @param {Page} page */
async function countPictures(page) {
  await page.addInitScript(() => {
    const counted = { frames: 0, pictures: /** @type {Record<string, number>} */ ({}) };
    const plain = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => {
      counted.frames++;
      return plain(callback);
    };
    addEventListener('DOMContentLoaded', () => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas'));
      new MutationObserver(() => {
        const kind = canvas.dataset.picture ?? '';
        counted.pictures[kind] = (counted.pictures[kind] ?? 0) + 1;
      }).observe(canvas, { attributeFilter: ['data-picture'] });
    });
    Object.assign(window, { counted });
  });
}

/** @param {Page} page @returns {Promise<{frames: number, pictures: Record<string, number>}>} */
const counted = (page) => page.evaluate(() => /** @type {any} */ (window).counted);

/** Frames that the page asks for while nothing happens. @param {Page} page */
async function framesAtRest(page) {
  await page.locator('canvas[data-picture=fine]').waitFor();
  await page.waitForTimeout(400);
  const before = await counted(page);
  await page.waitForTimeout(400);
  return (await counted(page)).frames - before.frames;
}

describe('a scene that is given a mesh every 100 ms', () => {
  /** @type {Awaited<ReturnType<typeof serve>>} */
  let site;
  beforeAll(async () => {
    site = await serve(fileURLToPath(new URL('../../', import.meta.url)));
  });
  afterAll(() => site?.close());

  /** Shows eggs of rising length. @param {{calm: boolean, overlay?: boolean}} how */
  async function show({ calm, overlay = false }) {
    const { page, errors } = await openAddress(served.browser, `${site.url}eggs.html`, small, async (fresh) => {
      await countPictures(fresh);
      const imports = {
        three: './node_modules/three/build/three.module.js',
        'three/addons/': './node_modules/three/examples/jsm/',
      };
      const body = `<!doctype html><link rel="icon" href="data:,"><script type="importmap">${JSON.stringify({ imports })}</script>
        <div style="width: 300px; height: 200px"><canvas></canvas></div>`;
      await fresh.route('**/eggs.html', (route) => route.fulfill({ contentType: 'text/html', body }));
    });
    const picture = await page.evaluate(async ([isCalm, cut]) => {
      const load = (/** @type {string} */ name) => import(new URL(name, location.href).href);
      const [{ createScene }, { SphereGeometry }] = await Promise.all([
        load('web/scene/scene.js'),
        load('node_modules/three/build/three.module.js'),
      ]);
      const sphere = new SphereGeometry(1, 24, 16);
      const round = sphere.getAttribute('position').array;
      const triangles = Uint32Array.from(sphere.getIndex().array);
      const faces = new Uint32Array(triangles.length / 3);
      /** @param {number} length */
      const egg = (length) => ({
        centre: Float64Array.of(length, 0, 0),
        positions: Float32Array.from(round, (/** @type {number} */ x, /** @type {number} */ i) =>
          i % 3 ? x : length * x,
        ),
        normals: Float32Array.from(round),
        curvatures: new Float32Array((2 * round.length) / 3),
        ...{ triangles, faces, edges: new Uint32Array(0) },
      });
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('canvas'));
      const scene = createScene(canvas, { calm: isCalm, slow: true, rested: () => {} });
      for (let i = 0; i <= 15; i++) {
        scene.setSurface(egg(1 + 0.1 * i), null, undefined, 'even');
        if (cut) scene.setSection({ direction: [0, 0, 1], position: 0.5, comb: 0, cut: false });
        await new Promise((resolve) => {
          setTimeout(resolve, 100);
        });
      }
      await new Promise((resolve) => {
        new MutationObserver(() => canvas.dataset.picture === 'fine' && resolve(null)).observe(canvas, {
          attributes: true,
        });
      });
      // The picture is kept only until the browser shows it.
      return new Promise((resolve) => {
        const seen = new MutationObserver(() => {
          if (canvas.dataset.picture === 'old') return;
          seen.disconnect();
          resolve(canvas.toDataURL());
        });
        seen.observe(canvas, { attributes: true });
        scene.requestRender();
      });
    }, /** @type {const} */ ([calm, overlay]));
    const { pictures } = await counted(page);
    const frames = await framesAtRest(page);
    expect(errors).toEqual([]);
    await page.context().close();
    return { picture, moving: pictures.moving ?? 0, frames };
  }

  test('draws pictures between them, ends with the same picture as without, and rests', async () => {
    const [moving, calm] = [await show({ calm: false }), await show({ calm: true })];
    console.log(`${moving.moving} pictures between 16 meshes`);
    expect(moving.moving).toBeGreaterThan(5);
    expect(calm.moving).toBe(0);
    expect(moving.picture === calm.picture).toBe(true);
    expect([moving.frames, calm.frames]).toEqual([0, 0]);
  }, 60_000);

  test('shows each at once while there is a section, which lies on the newest', async () => {
    const { moving, frames } = await show({ calm: false, overlay: true });
    expect([moving, frames]).toEqual([0, 0]);
  }, 60_000);
});

describe('a run in the studio', () => {
  /** Starts on a coarse mesh. @param {'reduce' | 'no-preference'} reducedMotion */
  async function start(reducedMotion) {
    const { page, errors } = await openAddress(
      served.browser,
      `${served.url}studio.html`,
      { ...small, reducedMotion },
      countPictures,
    );
    await measured(page);
    await dropFile(page, 'cage.obj', text);
    await page.locator('#cage').filter({ hasText: 'cage.obj' }).waitFor();
    await page.locator('[name=last]').selectOption('2');
    await page.locator('[name=first]').selectOption('0');
    await settled(page);
    await page.locator('#primary').click();
    return { page, errors };
  }

  test('moves between its meshes, and rests when it is paused', async () => {
    const { page, errors } = await start('no-preference');
    await page.waitForFunction(() => /** @type {any} */ (window).counted.pictures.moving >= 3, null, {
      timeout: 60_000,
    });
    await page.getByRole('button', { name: 'Pause' }).click();
    await status(page, /^Paused/);
    expect(await framesAtRest(page)).toBe(0);
    expect(errors).toEqual([]);
    await page.context().close();
  }, 90_000);

  test('shows each mesh at once where motion is reduced', async () => {
    const { page, errors } = await start('reduce');
    await page.waitForFunction(() => /** @type {any} */ (window).counted.pictures.coarse >= 6, null, {
      timeout: 60_000,
    });
    expect((await counted(page)).pictures.moving).toBeUndefined();
    expect(errors).toEqual([]);
    await page.context().close();
  }, 90_000);
});
