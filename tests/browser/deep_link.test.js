// SPDX-License-Identifier: MIT
/**
 * @file The studio's addresses: an entry of the catalog in the state in which it was left, addresses that cannot be
 * opened, and how the address follows the state.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { beforeAll, describe, expect, test } from '@jest/globals';
import {
  builtPage,
  drawn,
  energies,
  evaluated,
  measured,
  minimized,
  openAddress,
  openDetails,
  screenshots,
  status,
} from './page.js';
import { cameraRests, difference, pictureOf } from './pictures.js';
import { servedPage } from './served.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../web/files/catalog.js').Catalog} Catalog */

const served = servedPage();
/** @type {Catalog} */
let catalog;
beforeAll(() => {
  catalog = JSON.parse(readFileSync(path.join(builtPage, 'catalog/catalog.json'), 'utf8'));
});

/** @param {string} search @param {import('playwright-core').BrowserContextOptions} [options] */
function open(search, options = {}) {
  const permissions = ['clipboard-read', 'clipboard-write'];
  return openAddress(served.browser, `${served.url}studio.html${search}`, {
    permissions,
    reducedMotion: 'reduce',
    ...options,
  });
}

/** Waits until the worker has sent the fine surface, which follows the coarse one. @param {Page} page */
async function complete(page) {
  await page.locator('#downloads [name=save]:not([aria-disabled=true])').waitFor();
}

/** @param {Page} page the address that its button copies, from the question mark on */
async function copied(page) {
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.getByRole('button', { name: 'Copied' }).waitFor();
  return new URL(await page.evaluate(() => navigator.clipboard.readText())).search;
}

/**
 * To be called before the page loads. Records when the page drew the first picture with a surface, and when the browser
 * showed it.
 * @param {Page} page
 */
async function recordFirstPicture(page) {
  await page.addInitScript(() => {
    let surfaced = false;
    const channel = new MessageChannel();
    channel.port1.onmessage = () => (document.documentElement.dataset.shown ??= String(performance.now()));
    window.Worker = class extends Worker {
      /** @param {ConstructorParameters<typeof Worker>} options */
      constructor(...options) {
        super(...options);
        this.addEventListener('message', ({ data }) => (surfaced ||= data.type === 'surfaced'));
      }
    };
    addEventListener('DOMContentLoaded', () => {
      const canvas = /** @type {HTMLElement} */ (document.querySelector('canvas'));
      new MutationObserver(() => {
        if (!surfaced || canvas.dataset.picture === 'old') return;
        document.documentElement.dataset.pictured ??= String(performance.now());
        channel.port2.postMessage(null);
      }).observe(canvas, { attributeFilter: ['data-picture'] });
    });
  });
}

/** The time that a picture takes if there is nothing to load, compute or compile. */
const leastPage = `<!doctype html><canvas></canvas><script type="module">
  const canvas = document.querySelector('canvas');
  const context = canvas.getContext('webgl2', { antialias: false });
  new Worker('data:text/javascript,postMessage({ type: "surfaced" })').onmessage = () =>
    requestAnimationFrame(() => {
      context.clearColor(1, 0, 0, 1);
      context.clear(context.COLOR_BUFFER_BIT);
      canvas.dataset.picture = 'fine';
    });
</script>`;

const search = () => new URLSearchParams(location.search).get('camera');

/** @param {string} text as the page prints numbers */
const number = (text) => Number(text.replaceAll('\u202f', '').replaceAll('−', '-'));

describe('an address that names an entry', () => {
  test('opens the catalog’s minimizer, converged, with its energy, error bar and levels', async () => {
    const { page, errors } = await open('?shape=two-3&functional=bending');
    await status(page, /^The catalog’s minimizer: [\d.]+, within /);
    await drawn(page);
    const entry = catalog.entries.find((one) => one.shape === 'two-3' && one.functional === 'bending');
    if (!entry?.energy || !entry.error) throw new Error('the catalog has no such energy');
    const [energy, error] = (await page.locator('#entry strong').innerText()).split(' ± ').map(number);
    expect(Math.abs(energy - entry.energy)).toBeLessThanOrEqual(error / 10); // printed with two digits of the error
    expect(error).toBeCloseTo(entry.error, 2);
    await openDetails(page);
    expect(await page.locator('#limit').innerText()).toContain(await page.locator('#entry strong').innerText());
    expect(await page.locator('#levels tbody tr').count()).toBe(entry.levels.length);
    await measured(page);
    const printed = number((await energies(page))['Bending energy'].split(' ±')[0]);
    expect(printed / Number(entry.energies.bending)).toBeCloseTo(1, 5);
    expect(await page.locator('[name=functional]').inputValue()).toBe('bending');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 60_000);

  test('is drawn soon; prints how soon, which depends on the machine', async () => {
    /** @param {string} address @returns {Promise<number[]>} when its first picture was drawn, and shown */
    async function firstPicture(address) {
      const { page } = await openAddress(served.browser, address, {}, recordFirstPicture);
      await page.waitForFunction(() => document.documentElement.dataset.shown);
      const { pictured, shown } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
      await page.context().close();
      return [pictured, shown].map(Number);
    }
    /** @type {number[][]} */
    const times = [];
    for (let i = 0; i < 3; i++)
      times.push(await firstPicture(`${served.url}studio.html?shape=two-3&functional=mvs_cross`));
    // Measured last, when the browser has already used WebGL.
    const floor = await firstPicture(`data:text/html,${encodeURIComponent(leastPage)}`);
    for (const time of [floor, ...times].flat()) expect(time).toBeGreaterThan(0);
    const [drawn, shown] = [0, 1].map((part) => times.map((time) => Math.round(time[part])).join(', '));
    console.log(
      `An entry was drawn ${drawn} ms after its page was asked for, and on the screen after ${shown} ms; ` +
        `a page with nothing but a clear WebGL canvas after ${floor.map(Math.round).join(' and ')} ms`,
    );
  }, 90_000);

  test('opens the view that it was copied from: shading, and the camera after it was turned', async () => {
    const asked = '?shape=two-3&functional=mvs_cross&shading=gaussian&camera=10,40,1.2';
    const { page, errors } = await open(asked);
    await status(page, /^The catalog’s minimizer: [\d.]+, within /);
    await drawn(page);
    expect(await page.locator('[name=shading]').inputValue()).toBe('gaussian');
    expect(await copied(page)).toBe(asked);

    await complete(page);
    const box = await page.locator('#surface canvas').boundingBox();
    if (!box) throw new Error('there is no canvas');
    const before = await pictureOf(page, page.locator('#surface'));
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 40, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(0, 0);
    await cameraRests(page, '10,40,1.2');
    const turned = await copied(page);
    await page.getByRole('button', { name: 'Copy link' }).waitFor();
    const left = await pictureOf(page, page.locator('#surface'));
    expect(await difference(page, before, left)).toBeGreaterThan(0.05);

    const again = await open(turned);
    await status(again.page, /^The catalog’s minimizer: [\d.]+, within /);
    await complete(again.page);
    const restored = await pictureOf(again.page, again.page.locator('#surface'));
    expect(await copied(again.page)).toBe(turned);
    expect(await difference(page, left, restored)).toBeLessThan(0.01); // angles are kept to a tenth of a degree
    expect([...errors, ...again.errors]).toEqual([]);
    await Promise.all([page.context().close(), again.page.context().close()]);
  }, 90_000);

  test('offers to minimize it again, and ends within its error bar; the address is then the cage’s', async () => {
    const { page, errors } = await open('?shape=torus&functional=bending');
    await status(page, /^The catalog’s minimizer: [\d.]+, within /);
    const known = await page.locator('#entry strong').innerText();
    await page.getByRole('button', { name: 'Minimize again from the cage' }).click();
    await status(page, minimized, 90_000);
    await openDetails(page);
    await page.locator('#limit strong').waitFor();
    const [[energy, error], [again]] = [known, await page.locator('#limit strong').innerText()].map((text) =>
      text.split(' ± ').map(number),
    );
    expect(Math.abs(again - energy)).toBeLessThanOrEqual(error);
    expect(await page.locator('#entry strong').innerText()).toBe(known);
    expect(new URL(page.url()).searchParams.get('start')).toBe('cage');
    expect(errors).toEqual([]);
    await page.context().close();
  }, 120_000);
});

describe('an address that cannot be opened', () => {
  test.each([
    ['?shape=two-3&functional=nothing', /no functional “nothing”/],
    ['?shape=two-77777&functional=bending', /was not opened/],
    ['?shape=two-4&shading=rainbow&camera=1', /“shading=rainbow”.*“camera=1”/],
  ])(
    '%s says so and leaves a studio that works',
    async (address, words) => {
      const { page, errors } = await open(address);
      await measured(page);
      expect(await page.locator('#alert').innerText()).toMatch(words);
      await page.getByRole('button', { name: 'Dismiss' }).click();
      await page.locator('#step').click();
      await status(page, /^Paused at/);
      await evaluated(page, 1);
      // The browser, too, reports a missing file.
      expect(errors.filter((error) => !error.includes('404'))).toEqual([]);
      await page.context().close();
    },
    60_000,
  );
});

describe('the address', () => {
  test('follows what is chosen without a trace in the history, and once for a drag', async () => {
    const { page } = await open('?shape=two-3');
    await measured(page);
    const entries = await page.evaluate(() => history.length);
    await page.evaluate(() => {
      const replace = history.replaceState.bind(history);
      history.replaceState = (...args) => {
        const { dataset } = document.documentElement;
        dataset.replaced = String(Number(dataset.replaced ?? 0) + 1);
        replace(...args);
      };
    });
    await page.locator('[name=shape]').selectOption('two-4');
    await page.locator('[name=functional]').selectOption('bending');
    await page.locator('[name=shading]').selectOption('kappa1');
    await page.waitForFunction(() => location.search === '?shape=two-4&functional=bending&start=cage&shading=kappa1');
    await measured(page);
    const replaced = () => page.evaluate(() => Number(document.documentElement.dataset.replaced));
    const before = await replaced();
    expect(before).toBeLessThanOrEqual(4);
    await page.locator('#surface canvas').focus();
    for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowLeft');
    await page.waitForFunction(search);
    await page.waitForTimeout(600);
    expect(await replaced()).toBeLessThanOrEqual(before + 2);
    expect(await page.evaluate(() => history.length)).toBe(entries);
    await page.screenshot({ path: path.join(screenshots, 'address.png') });
    await page.context().close();
  }, 60_000);
});
