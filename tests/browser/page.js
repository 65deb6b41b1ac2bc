// SPDX-License-Identifier: MIT
/**
 * @file Helpers for tests of the page: opening it, watching for errors, and reading what a user would read.
 */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {import('playwright-core').Page} Page */

const build = fileURLToPath(new URL('../../build/', import.meta.url));
export const builtPage = path.join(build, 'web');
export const screenshots = path.join(build, 'screenshots');

/**
 * The errors and requests of a page so far.
 * @typedef {{page: Page, errors: string[], requests: string[]}} Watched
 */

/**
 * Opens the studio and waits until its first surface is measured.
 * @param {Browser} browser
 * @param {string} url of the site
 * @param {import('playwright-core').BrowserContextOptions} [options]
 * @param {(page: Page) => Promise<void>} [prepare]
 * @returns {Promise<Watched>}
 */
export async function openPage(browser, url, options = {}, prepare = async () => {}) {
  const watched = await openAddress(browser, `${url}studio.html`, options, prepare);
  await measured(watched.page);
  return watched;
}

/**
 * Options for tests that look at pixels, and for pictures that people look at. Other tests draw a quarter of the pixels:
 * software that draws takes more time than the page.
 */
export const allPixels = { deviceScaleFactor: 1 };

/**
 * Opens any page of the site.
 * @param {Browser} browser
 * @param {string} address
 * @param {import('playwright-core').BrowserContextOptions} [options]
 * @param {(page: Page) => Promise<void>} [prepare]
 * @returns {Promise<Watched>}
 */
export async function openAddress(browser, address, options = {}, prepare = async () => {}) {
  const fewPixels = { deviceScaleFactor: 0.5 };
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...fewPixels, ...options });
  const page = await context.newPage();
  /** @type {string[]} */
  const errors = [];
  /** @type {string[]} */
  const requests = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  page.on('response', (response) => {
    if (response.status() >= 400) errors.push(`${response.status()} ${response.url()}`);
  });
  await prepare(page);
  await page.goto(address);
  return { page, errors, requests };
}

/** Waits until the table of energies is there. @param {Page} page */
export async function measured(page) {
  await page.locator('#energies tbody tr').first().waitFor();
}

/**
 * Opens the details of an entry of the catalog and takes a picture of them.
 * @param {Page} page
 * @param {string} address
 * @param {string} picture its name
 * @returns {Promise<number>} the width that is cut off, in pixels; none if it is not positive
 */
export async function detailsCut(page, address, picture) {
  await page.goto(address);
  const dialog = page.getByRole('dialog');
  await dialog.waitFor();
  await page.waitForLoadState('networkidle');
  await page.screenshot({ path: path.join(screenshots, `${picture}.png`) });
  return dialog.locator('.content').evaluate((content) => content.scrollWidth - content.clientWidth);
}

/** Waits for a status that matches. @param {Page} page @param {RegExp} pattern @param {number} [timeout] */
export async function status(page, pattern, timeout = 30_000) {
  await page.locator('#status').filter({ hasText: pattern }).waitFor({ timeout });
}

/** How the status begins when a run has ended where it should. */
export const minimized = /^(Minimized|The energy)/;

/** Opens the details of a run, which has ended a level. @param {Page} page */
export async function openDetails(page) {
  const details = page.locator('#run-details');
  await details.waitFor();
  if ((await details.getAttribute('open')) === null) await details.locator('summary').click();
}

/** Opens what only experts set: how the cage of a frame is built, and how its energy is minimized. @param {Page} page */
export async function openAdvanced(page) {
  for (const details of await page.locator('details:has(> summary:text-is("Advanced"))').all()) {
    const summary = details.locator('> summary');
    if ((await summary.isVisible()) && (await details.getAttribute('open')) === null) await summary.click();
  }
}

/** @param {string} text of the line below the status */
export function parseProgress(text) {
  const match = /energy ([\d.\u202f]+) · level (\d+) · ([\d\u202f]+) evaluation/.exec(text);
  if (!match) throw new Error(`no progress in "${text}"`);
  const [energy, level, evaluations] = match.slice(1).map((number) => Number(number.replaceAll('\u202f', '')));
  return { energy, level, evaluations };
}

/** Energy, level and evaluations as the page shows them. @param {Page} page */
export async function progress(page) {
  return parseProgress((await page.locator('#progress').textContent()) ?? '');
}

/**
 * Records the progress line from now on; the returned function returns all that was recorded.
 * @param {Page} page
 */
export async function recordProgress(page) {
  const texts = await page.evaluateHandle(() => {
    const line = /** @type {Element} */ (document.querySelector('#progress'));
    /** @type {string[]} */
    const seen = [];
    new MutationObserver(() => seen.push(line.textContent ?? '')).observe(line, { childList: true, subtree: true });
    return seen;
  });
  return async () => (await texts.jsonValue()).filter((text) => text.startsWith('energy')).map(parseProgress);
}

/**
 * To be called before the page loads. Records the messages between page and worker, and when pictures are drawn,
 * starting with the next press of Start or of "Minimize again".
 * @typedef {{time: number, name: string, evaluations: number}} PageEvent `time` in milliseconds after the press
 * @param {Page} page
 */
export async function recordEvents(page) {
  await page.addInitScript(() => {
    /** @type {PageEvent[]} */
    let events = [];
    let start = 0;
    /** @param {string} name @param {number} [evaluations] */
    const keep = (name, evaluations = -1) => events.push({ time: performance.now() - start, name, evaluations });
    window.Worker = class extends Worker {
      /** @param {ConstructorParameters<typeof Worker>} options */
      constructor(...options) {
        super(...options);
        this.addEventListener('message', ({ data }) => keep(data.type, data.evaluations));
      }
    };
    addEventListener('DOMContentLoaded', () => {
      const canvas = /** @type {HTMLElement} */ (document.querySelector('canvas'));
      new MutationObserver(() => canvas.dataset.picture !== 'old' && keep('drawn')).observe(canvas, {
        attributeFilter: ['data-picture'],
      });
      for (const button of document.querySelectorAll('#primary, #entry button')) {
        button.addEventListener('click', () => ((events = []), (start = performance.now())), { capture: true });
      }
    });
    Object.assign(window, { recordedEvents: () => events });
  });
}

/** The recorded events. @param {Page} page @returns {Promise<PageEvent[]>} */
export function recordedEvents(page) {
  return page.evaluate(() => /** @type {any} */ (window).recordedEvents());
}

/** Waits until this many evaluations have been made. @param {Page} page @param {number} count */
export async function evaluated(page, count) {
  await page.waitForFunction((least) => {
    const match = /([\d\u202f]+) evaluation/.exec(document.querySelector('#progress')?.textContent ?? '');
    return match !== null && Number(match[1].replaceAll('\u202f', '')) >= least;
  }, count);
}

/** The energies of the table, by their names. @param {Page} page @returns {Promise<Record<string, string>>} */
export function energies(page) {
  return page.locator('#energies tbody tr').evaluateAll((rows) => {
    const entries = rows.map((row) => [row.querySelector('th')?.textContent, row.lastElementChild?.textContent]);
    return Object.fromEntries(entries);
  });
}

/** Waits until the current surface has been drawn at full resolution. @param {Page} page */
export async function drawn(page) {
  await page.locator('canvas[data-picture=fine]').waitFor();
}

/** Waits until the core has answered the last change. @param {Page} page */
export async function settled(page) {
  await status(page, /^Ready/);
  await measured(page);
  await drawn(page);
}

/**
 * Saves a file from the studio's downloads, once there is something to save.
 * @param {Page} page
 * @param {import('../../web/pages/studio/state/types.js').Download} what
 * @returns {Promise<{name: string, content: Buffer}>}
 */
export async function download(page, what) {
  await page.locator('#downloads [name=what]').selectOption(what);
  const button = page.locator('#downloads [name=save]:not([aria-disabled=true])');
  const [saved] = await Promise.all([page.waitForEvent('download'), button.click()]);
  return { name: saved.suggestedFilename(), content: readFileSync(await saved.path()) };
}

/** The text of a download. @param {Page} page @param {Parameters<typeof download>[1]} what */
export const downloadedText = async (page, what) => (await download(page, what)).content.toString();

/** Drops a file on the page. @param {Page} page @param {string} name @param {string | Uint8Array} content */
export const dropFile = (page, name, content) => dropFiles(page, [[name, content]]);

/** Drops files on the page, at once. @param {Page} page @param {[name: string, content: string | Uint8Array][]} files */
export async function dropFiles(page, files) {
  const encoded = files.map(([name, content]) => ({ name, bytes: [...Buffer.from(content)] }));
  const transfer = await page.evaluateHandle((all) => {
    const created = new DataTransfer();
    for (const { name, bytes } of all) created.items.add(new File([Uint8Array.from(bytes)], name));
    return created;
  }, encoded);
  for (const type of ['dragenter', 'dragover', 'drop']) {
    await page.dispatchEvent('body', type, { dataTransfer: transfer });
  }
}

/**
 * Describes a picture of the surface: the fraction that is not background, the number of its colours, and their mean
 * distance from grey.
 * @param {Page} page
 * @param {boolean} [moving] whether a run goes on, so that no picture is final
 */
export async function look(page, moving = false) {
  if (!moving) await drawn(page);
  const picture = await page.locator('#surface').screenshot();
  return page.evaluate(async (encoded) => {
    const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.drawImage(bitmap, 0, 0);
    // The middle of the picture, which contains only the surface and the background.
    const [x, y, width, height] = [0.1, 0.15, 0.8, 0.6].map((part, i) =>
      Math.round(part * (i % 2 ? bitmap.height : bitmap.width)),
    );
    const { data } = context.getImageData(x, y, width, height);
    const colours = new Set();
    let coloured = 0;
    let largest = 0;
    for (let i = 0; i < data.length; i += 4) {
      const chroma = Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]);
      largest = Math.max(largest, chroma);
      if (chroma < 24) continue;
      coloured++;
      colours.add((data[i] >> 3) * 1024 + (data[i + 1] >> 3) * 32 + (data[i + 2] >> 3));
    }
    return { coloured: coloured / (width * height), colours: colours.size, chroma: largest };
  }, picture.toString('base64'));
}
