// SPDX-License-Identifier: MIT
/**
 * @file Several documents and their store, with workers' sessions on the real core: what is written when, what is shown for
 * which address, and which documents have a worker.
 */
import { beforeAll, beforeEach, describe, expect, jest, test } from '@jest/globals';
import { load } from '../../../wasm/umbilic.js';
import { createDesk } from '../../../web/pages/studio/desk.js';
import { KEEP_INTERVAL, createKeeper } from '../../../web/pages/studio/keeper.js';
import { createOwnership } from '../../../web/pages/studio/ownership.js';
import { keptFrom } from '../../../web/pages/studio/state/kept.js';
import { reduce } from '../../../web/pages/studio/state/reduce.js';
import { nameOfPasted } from '../../../web/pages/studio/views/paste.js';
import { createSession } from '../../../web/worker/session.js';
import { copied, core } from './real.js';
import { after, drop, openedMessages, resting, running } from './state.js';

/** @typedef {import('../../../web/worker/store.js').StoreQuestion} StoreQuestion */
/** @typedef {import('../../../web/pages/studio/open_document.js').Hear} Hear */

beforeAll(() => load());

/** What the store has: documents, and their parts. @type {Map<string, {stored: any, parts: Map<string, any>}>} */
let stored;
/** @type {StoreQuestion[]} */
let questions;
/** @type {string | null} */
let broken;

beforeEach(() => {
  stored = new Map();
  questions = [];
  broken = null;
});

/** A store in memory. @param {StoreQuestion} question @returns {Promise<any>} */
async function ask(question) {
  questions.push(question);
  if (broken) throw new Error(broken);
  switch (question.ask) {
    case 'list':
      return [...stored.values()].map((one) => copied(one.stored));
    case 'read':
      return copied(stored.get(question.id)?.parts ?? new Map());
    case 'remove':
      return question.ids.forEach((id) => stored.delete(id));
    case 'keep': {
      const { id, page } = question.stored;
      const before = stored.get(id);
      if (before && before.stored.page !== page && before.stored.page !== question.after) return 'changed';
      if (question.keys.some((key) => !before?.parts.has(key) && !question.parts.has(key))) return 'incomplete';
      const parts = new Map([...(stored.get(id)?.parts ?? []), ...copied(question.parts)]);
      for (const key of parts.keys()) if (!question.keys.includes(key)) parts.delete(key);
      stored.set(id, { stored: copied(question.stored), parts });
      return 'kept';
    }
  }
}

/** A page with its documents. */
function createPage() {
  /** @type {Array<() => void>} */
  const waiting = [];
  let workers = 0;
  let clock = 0;
  /** @param {Hear} hear */
  function connect({ onMessage }) {
    workers++;
    let alive = true;
    const obey = createSession({
      core,
      post: (message) => alive && onMessage(message),
      yieldThen: (task) => waiting.push(() => alive && task()),
      now: () => (clock += 5),
    });
    return {
      send: (/** @type {any} */ command) => void waiting.push(() => alive && obey(command)),
      abandon() {},
      restart() {},
      dispose() {
        workers -= alive ? 1 : 0;
        alive = false;
      },
    };
  }
  /** @type {string[]} */
  const addresses = [];
  const desk = createDesk({
    outside: {
      connect,
      save() {},
      takePicture: async () => ({ type: 'pictureTaken', failure: null }),
      load: async (name) => ({ type: 'entryMissing', name, message: 'none' }),
    },
    keeper: createKeeper({ ask, told() {} }),
    ownership: createOwnership(undefined),
    setAddress: (search) => addresses.push(search),
    changed() {},
  });
  return {
    desk,
    addresses,
    get workers() {
      return workers;
    },
    /** @param {string} [search] @param {string | null} [shown] */
    async begin(search = '', shown = null) {
      await desk.restore({ search, shown, theme: 'light' });
      this.work();
    },
    /** @param {number} [turns] */
    work(turns = Infinity) {
      for (let i = 0; i < turns && waiting.length; i++) waiting.shift()?.();
    },
    names: () => desk.tabs().map(({ name, active }) => `${name}${active ? ' *' : ''}`),
  };
}

/** @param {string} name @returns {import('../../../web/pages/studio/state/types.js').Action} */
const shape = (name) => ({ type: 'generatorChanged', change: { name } });
/** @type {import('../../../web/pages/studio/state/types.js').Action} */
const quick = { type: 'settingsChanged', change: { functional: 'bending', levels: [0, 0] } };

describe('documents', () => {
  test('come back with the next page: the one that was on the screen last, or the one that the address is of', async () => {
    const page = createPage();
    await page.begin('?shape=cube');
    page.desk.dispatch(quick);
    page.desk.create();
    page.work();
    page.desk.dispatch(shape('two-4'));
    page.work();
    expect(page.names()).toEqual(['Cube', 'Two junctions, 4 arms *']);
    await page.desk.flush();
    expect(page.desk.isUnkept).toBe(false);

    const next = createPage();
    await next.begin();
    expect(next.names()).toEqual(['Cube', 'Two junctions, 4 arms *']);
    expect(next.desk.state.document.cage?.name).toBe('two-4');
    expect(next.desk.state.history.past.map(({ name }) => name)).toEqual(['open Two junctions, 4 arms']);
    expect(next.workers).toBe(1);

    const [cube] = [...stored.values()].filter(({ stored: one }) => /cube/.test(one.content.address));
    const other = createPage();
    await other.begin(cube.stored.content.address);
    expect(other.names()).toEqual(['Cube *', 'Two junctions, 4 arms']);
  });

  test('with which nothing was done make way for what another address asks, and not for a reload', async () => {
    const page = createPage();
    await page.begin('?shape=cube');
    await page.desk.flush();
    const [id] = stored.keys();
    const again = createPage();
    await again.begin('?shape=cube', id);
    expect(again.names()).toEqual(['Cube *']);
    expect([...stored.keys()]).toEqual([id]);
    const asked = createPage();
    await asked.begin('?shape=torus');
    expect(asked.names()).toEqual(['Torus *']);
    expect(stored.has(id)).toBe(false);
  });

  test('have a worker while they run or are on the screen', async () => {
    jest.useFakeTimers({ doNotFake: ['queueMicrotask', 'performance', 'Date'] });
    const page = createPage();
    await page.begin();
    page.desk.dispatch({ type: 'startPressed' });
    page.work(20);
    page.desk.create();
    page.work(5);
    expect(page.workers).toBe(2);
    expect(page.desk.tabs().map(({ running: runs }) => runs)).toEqual([true, false]);
    page.work();
    expect(page.desk.tabs().map(({ running: runs }) => runs)).toEqual([false, false]);
    jest.runAllTimers();
    expect(page.workers).toBe(1);
    page.desk.show(page.desk.tabs()[0].id);
    page.work();
    expect(page.workers).toBe(1);
    expect(page.desk.state.document.result.stop).toBe('converged');
    expect(page.desk.state.view.surface).not.toBeNull();
    jest.useRealTimers();
  });

  test('that are closed leave the screen, and come back as they were', async () => {
    const page = createPage();
    await page.begin('?shape=cube');
    page.desk.dispatch(quick);
    page.work();
    page.desk.dispatch({ type: 'startPressed' });
    page.work();
    const before = keptFrom(page.desk.state).document;
    await page.desk.close(page.desk.tabs()[0].id);
    page.work();
    expect(page.names()).toEqual(['Two junctions, 3 arms *']);
    const next = createPage();
    await next.begin();
    expect(next.names()).not.toContain('Cube');
    await next.desk.reopen();
    next.work();
    expect(next.desk.state.document).toEqual(before);
    expect(next.desk.canReopen).toBe(false);
  });
});

describe('two pages with one document, where the browser cannot say whose it is,', () => {
  /** @param {ReturnType<typeof createPage>} page */
  const tolerance = (page) => page.desk.state.document.settings.tolerance;
  const change = (/** @type {number} */ value) =>
    /** @type {const} */ ({ type: 'settingsChanged', change: { tolerance: value } });

  /** Two pages on a document, of which one has been changed. */
  async function both() {
    const first = createPage();
    await first.begin('?shape=cube');
    first.desk.dispatch(quick);
    first.work();
    await first.desk.flush();
    const [id] = stored.keys();
    const second = createPage();
    await second.begin('', id);
    second.desk.dispatch(change(0.25));
    await second.desk.flush();
    expect(first.desk.state.view.alert).toBeNull();
    return { first, second, id };
  }

  test('keep both: the one that writes later goes on as a document of its own, and says so', async () => {
    const { first, second, id } = await both();
    first.desk.dispatch(change(0.5));
    await first.desk.flush();
    expect(first.desk.state.view.alert?.title).toBe('Another tab has changed this document');
    expect(second.desk.state.view.alert).toBeNull();
    await first.desk.flush();
    expect(first.desk.tabs().map((tab) => tab.id === id)).toEqual([false]);
    second.desk.dispatch(change(0.125));
    await Promise.all([first.desk.flush(), second.desk.flush()]);
    expect(second.desk.state.view.alert).toBeNull();

    const next = createPage();
    await next.begin();
    expect(next.names()).toEqual(['Cube *', 'Cube (2)']);
    const found = next.desk.tabs().map((tab) => {
      next.desk.show(tab.id);
      return [tolerance(next), next.desk.state.history.past.length];
    });
    expect(found).toEqual([
      [0.125, 3],
      [0.5, 2],
    ]);
  });

  test('keep what is closed in one of them, beside what the other has', async () => {
    const { first, second } = await both();
    first.desk.dispatch(change(0.5));
    await first.desk.close(first.desk.tabs()[0].id);
    expect(tolerance(second)).toBe(0.25);
    await first.desk.reopen();
    expect(tolerance(first)).toBe(0.5);
  });

  test('write a document that the other one has forgotten with all its parts', async () => {
    const { second, id } = await both();
    await ask({ ask: 'remove', ids: [id] });
    second.desk.dispatch(change(0.5));
    await second.desk.flush();
    const next = createPage();
    await next.begin('', id);
    expect(tolerance(next)).toBe(0.5);
    expect(next.desk.state.history.past).toHaveLength(3);
  });
});

describe('the keeper', () => {
  const written = () =>
    questions.flatMap((question) => (question.ask === 'keep' && question.stored.id === 'one' ? [question] : []));
  const wait = (/** @type {number} */ time) => jest.advanceTimersByTimeAsync(time);

  test('writes soon after a change, not too often, and each step and file once', async () => {
    jest.useFakeTimers();
    let state = after(resting(), drop('a.obj'), ...openedMessages(2));
    const keeper = createKeeper({ ask, told() {} });
    const writer = keeper.writer('one', () => ({ kept: keptFrom(state), address: '', seen: 0, closed: 0 }));
    writer.touch();
    writer.touch();
    await wait(KEEP_INTERVAL / 2);
    expect(written()).toHaveLength(1);
    expect(written()[0].parts.size).toBe(2); // the step that opened it, and its text
    for (let i = 0; i < 20; i++) {
      state = reduce(state, { type: 'settingsChanged', change: { tolerance: 1 / (i + 2) } });
      writer.touch();
      await wait(KEEP_INTERVAL / 10);
    }
    expect(written().length).toBeLessThanOrEqual(4);
    const sent = written().flatMap(({ parts }) => [...parts.keys()]);
    expect(new Set(sent).size).toBe(sent.length);
    await writer.stop();
    jest.useRealTimers();
  });

  test('tells why it could not write, and writes all of it the next time', async () => {
    jest.useFakeTimers();
    /** @type {Array<string | null>} */
    const told = [];
    const keeper = createKeeper({ ask, told: (failure) => told.push(failure) });
    const state = after(running(), drop('a.obj'), ...openedMessages(2));
    const writer = keeper.writer('one', () => ({ kept: keptFrom(state), address: '?a', seen: 1, closed: 0 }));
    broken = 'the disk is full';
    writer.touch();
    await wait(1000);
    expect(told).toEqual(['the disk is full']);
    broken = null;
    writer.touch();
    await wait(1000);
    expect(told.at(-1)).toBeNull();
    const [one] = await keeper.list();
    const { kept, address } = await createKeeper({ ask, told() {} }).read(one);
    expect(kept).toEqual(keptFrom(state));
    expect(address).toBe('?a');
    jest.useRealTimers();
  });
});

describe('files that are opened together', () => {
  const bytes = (/** @type {string} */ text) => new TextEncoder().encode(text);
  const tetrahedron = 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n';

  test('are documents in their order, in the place of one with which nothing was done', async () => {
    const page = createPage();
    await page.begin();
    for (const name of ['a.obj', 'b.obj', 'c.obj']) page.desk.openBeside({ name, text: bytes(tetrahedron) });
    page.work();
    expect(page.names()).toEqual(['a.obj', 'b.obj', 'c.obj *']);
    await page.desk.flush();
    // No address brings them back, so they are not forgotten although nothing was done with them.
    const next = createPage();
    await next.begin();
    expect(next.names()).toEqual(['a.obj', 'b.obj', 'c.obj *']);
  });

  test('leave out one that is broken, which is said on the document that is shown', async () => {
    const page = createPage();
    await page.begin('?shape=cube');
    page.desk.dispatch(quick);
    page.work();
    page.desk.openBeside({ name: 'good.obj', text: bytes(tetrahedron) });
    page.desk.openBeside({ name: 'broken.obj', text: bytes(`${tetrahedron}f 1 2 9\n`) });
    page.work();
    await new Promise(setImmediate);
    page.work();
    expect(page.names()).toEqual(['Cube', 'good.obj *']);
    expect(page.desk.state.view.alert).toEqual({
      title: 'broken.obj was not opened',
      message: expect.stringMatching(/^line 9: /),
    });
  });

  test('and are all broken leave the page with the shape that it begins with', async () => {
    const page = createPage();
    await page.begin();
    page.desk.openBeside({ name: 'broken.obj', text: bytes('f 1 2 3\n') });
    page.work();
    await new Promise(setImmediate);
    page.work();
    expect(page.names()).toEqual(['Two junctions, 3 arms *']);
    expect(page.desk.state.view.alert?.title).toBe('broken.obj was not opened');
  });
});

describe('a text that is pasted', () => {
  test.each([
    ['v 0 0 0\nf 1 2 3\n', 'pasted.obj'],
    ['# made by hand\nv 0 0 0\n', 'pasted.obj'],
    ['OFF\n4 4 0\n', 'pasted.off'],
    ['# a comment\nCOFF 4 4 0\n', 'pasted.off'],
    [' {"umbilic": "problem"}', 'pasted.json'],
    ['ply\r\nformat ascii 1.0\n', 'pasted.ply'],
    ['plywood', 'pasted.obj'],
    ['OFFICE', 'pasted.obj'],
  ])('%j is taken as the file %s', (text, name) => expect(nameOfPasted(text)).toBe(name));
});
