// SPDX-License-Identifier: MIT
/**
 * @file Uses the studio for a long time, and measures what memory it keeps: of JavaScript on the page, of the worker's
 * WebAssembly module, and of the browser's process.
 */
import { readFileSync } from 'node:fs';
import { minimized, openPage, status } from './page.js';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').CDPSession} Session */

/**
 * In bytes, after garbage was collected. `heap` of JavaScript on the page, and `buffers` of its arrays; `module` of the worker's
 * WebAssembly module; `renderer` the private memory of the process of page and workers, where the system tells and it is asked for. `nodes` is the
 * number of the document's nodes, `workers` that of the page's workers.
 * @typedef {{heap: number, buffers: number, module: number, renderer: number, nodes: number, workers: number}} Memory
 */

/**
 * Arguments for the browser: compiled JavaScript, which grows as long as something is used more often than before, is no part of
 * the heap then.
 */
export const UNCOMPILED = ['--js-flags=--no-sparkplug --no-maglev --no-turbofan'];

/** Drawing in software takes long. */
const SMALL = { reducedMotion: /** @type {const} */ ('reduce'), viewport: { width: 800, height: 500 } };

/** After this time what was closed has been written, in milliseconds. */
const SETTLING = 1500;
/** How often the memory of the process is looked at. */
const SAMPLES = 6;

/** One use of the studio: from something that is opened to nothing that is left. @typedef {(page: Page, cycle: number) => Promise<void>} Cycle */

/** The core's worker, among those of the page. */
const CORE = /\/worker-/;
/** What the worker's script begins with, so that its module can be measured. */
const CAPTURE = `for (const name of ['instantiate', 'instantiateStreaming']) {
  const plain = WebAssembly[name];
  WebAssembly[name] = async (...given) => {
    const made = await plain.call(WebAssembly, ...given);
    const exported = Object.values((made.instance ?? made).exports);
    self.soakedMemory = exported.find((one) => one instanceof WebAssembly.Memory);
    return made;
  };
}
`;

/** Bytes of the process's memory that it shares with no other. @param {number} pid */
function privateMemory(pid) {
  const text = readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8');
  const lines = [...text.matchAll(/^Private_(?:Clean|Dirty):\s+(\d+) kB$/gm)];
  return lines.reduce((sum, [, kilobytes]) => sum + 1024 * Number(kilobytes), 0);
}

/**
 * The process of the page: the largest that draws pages, at its smallest in a few seconds, since the memory of workers that have
 * ended is given back later.
 * @param {Page} page
 * @param {Session} session of the browser
 */
async function rendererMemory(page, session) {
  if (process.platform !== 'linux') return NaN;
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const renderers = processInfo.filter(({ type }) => type === 'renderer');
  let least = Infinity;
  for (let i = 0; i < SAMPLES; i++) {
    least = Math.min(least, Math.max(...renderers.map(({ id }) => privateMemory(id))));
    await page.waitForTimeout(SETTLING);
  }
  return least;
}

/** @param {Page} page */
async function moduleMemory(page) {
  const workers = page.workers().filter((worker) => CORE.test(worker.url()));
  const sizes = await Promise.all(
    workers.map((worker) => worker.evaluate(() => /** @type {any} */ (self).soakedMemory?.buffer.byteLength ?? 0)),
  );
  return Math.max(0, ...sizes);
}

/** @param {Page} page @param {boolean} [all] also that of the process, which takes 9 s @returns {Promise<Memory>} */
export async function measure(page, all = true) {
  const [session, whole] = await Promise.all([
    page.context().newCDPSession(page),
    /** @type {Browser} */ (page.context().browser()).newBrowserCDPSession(),
  ]);
  await page.waitForTimeout(SETTLING);
  await session.send('Memory.simulatePressureNotification', { level: 'critical' });
  for (let i = 0; i < 3; i++) await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize } = await session.send('Runtime.getHeapUsage');
  const { nodes } = await session.send('Memory.getDOMCounters');
  const memory = {
    heap: usedSize,
    buffers: backingStorageSize,
    nodes,
    module: await moduleMemory(page),
    renderer: all ? await rendererMemory(page, whole) : NaN,
    workers: page.workers().length,
  };
  await Promise.all([session.detach(), whole.detach()]);
  return memory;
}

/** Minimizes what is chosen, on coarse meshes. @param {Page} page @param {string} shape */
async function minimize(page, shape) {
  await page.locator('[name=shape]').selectOption(shape);
  await page.locator('[name=functional]').selectOption('bending');
  for (const name of ['last', 'first']) await page.locator(`[name=${name}]`).selectOption('0');
  await status(page, /^Ready/);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await status(page, minimized);
}

/** Sizes of cages in turn, so that memory that is free again has to serve for others. */
const SHAPES = ['cube', 'torus', 'two-3', 'tetrahedron-frame'];

/** What is soaked. @type {Record<string, Cycle>} */
export const cycles = {
  /** A document is opened, minimized and closed, with its worker. */
  async documents(page, cycle) {
    await page.getByRole('button', { name: 'New', exact: true }).click();
    await status(page, /^Ready/);
    await minimize(page, SHAPES[cycle % SHAPES.length]);
    await page.locator('#documents .active .close').click();
    await page.waitForFunction(() => document.querySelectorAll('#documents li').length === 1);
    await status(page, /^Ready/);
  },

  /** A cage is opened and minimized by the worker that does so for all, and everything is taken back. */
  async cages(page, cycle) {
    await minimize(page, SHAPES[cycle % SHAPES.length]);
    const undo = page.locator('#undo:not([aria-disabled=true])');
    while (await undo.count()) {
      await undo.click();
      await status(page, /^Ready/);
    }
  },
};

/**
 * @param {Browser} browser
 * @param {string} url of the site
 * @param {Cycle} cycle
 * @param {{first: number, last: number, all?: boolean}} when it is measured, in cycles; `all` as of `measure`
 * @param {(cycle: number) => void} [told] called after each cycle
 * @returns {Promise<{first: Memory, last: Memory}>}
 */
export async function soak(browser, url, cycle, { first, last, all = true }, told = () => {}) {
  const { page, errors } = await openPage(browser, url, SMALL, async (fresh) => {
    /** @type {Promise<string> | undefined} */
    let script;
    await fresh.route(CORE, async (route) => {
      script ??= fetch(route.request().url()).then((response) => response.text());
      await route.fulfill({ contentType: 'text/javascript', body: CAPTURE + (await script) });
    });
  });
  page.setDefaultTimeout(120_000);
  /** @type {Memory | undefined} */
  let early;
  for (let i = 1; i <= last; i++) {
    await cycle(page, i);
    told(i);
    if (i === first) early = await measure(page, all);
  }
  const late = await measure(page, all);
  await page.context().close();
  if (errors.length) throw new Error(errors.join('\n'));
  return { first: early ?? late, last: late };
}
