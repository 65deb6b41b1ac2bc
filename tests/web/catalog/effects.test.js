// SPDX-License-Identifier: MIT
/**
 * @file What the catalog's actions cause: addresses, files to save, and what happens when a surface cannot be made.
 */
import { describe, expect, test } from '@jest/globals';
import { parseCatalogAddress } from '../../../web/address/catalog.js';
import { createEffects } from '../../../web/pages/catalog/effects.js';
import { initialState, reduce } from '../../../web/pages/catalog/reduce.js';
import { createRequests } from '../../../web/worker/requests.js';
import { catalog } from './small.js';

/** @import {Action, State} from '../../../web/pages/catalog/types.js' */

/** A page without a browser: what it saved, where it went, and what it asked the worker for. */
function page({ failure = '' } = {}) {
  const log = {
    saved: /** @type {Array<[string, string | ArrayBuffer]>} */ ([]),
    addresses: /** @type {string[]} */ ([]),
    asked: /** @type {any[]} */ ([]),
  };
  let state = /** @type {State} */ ({ ...initialState(parseCatalogAddress(''), 'system'), catalog });
  /** @type {() => void} */
  let settle = () => {};
  const report = /** @type {any} */ ({ umbilic: 'report', surface: { level: 3, points: [1, 2, 3] } });
  const effects = createEffects({
    dispatch,
    makeSurface: async (command) => {
      log.asked.push(command);
      if (failure) throw new Error(failure);
      return command.what === 'stl' || command.what === 'glb' ? new ArrayBuffer(1) : 'v 0 0 0\n';
    },
    loadReport: async () => report,
    save: (name, content) => log.saved.push([name, content]),
    setAddress: (search, how) => log.addresses.push(`${how} ${search}`),
  });
  /** @param {Action} action */
  function dispatch(action) {
    const before = state;
    state = reduce(before, action);
    effects(action, before, state);
    if (action.type === 'exported' || action.type === 'exportFailed') settle();
  }
  /** @param {Action} action @returns {Promise<void>} when its download has ended */
  const finished = (action) =>
    new Promise((resolve) => {
      settle = resolve;
      dispatch(action);
    });
  return { log, dispatch, finished, state: () => state };
}

describe('the address', () => {
  test('follows the order and the rows in place, and keeps an entry that is opened as a step back', () => {
    const { log, dispatch } = page();
    dispatch({ type: 'sortPressed', key: 'genus' });
    dispatch({ type: 'filterChanged', change: { genus: 3 } });
    dispatch({ type: 'filterChanged', change: { genus: 3 } });
    dispatch({ type: 'entryOpened', entry: 'torus.mvs' });
    dispatch({ type: 'entryChosen', entry: 'torus.mvs', chosen: true });
    expect(log.addresses).toEqual([
      'replace ?sort=genus',
      'replace ?sort=genus&genus=3',
      'push ?sort=genus&genus=3&entry=torus.mvs',
    ]);
  });

  test('is not written when it is what has been followed', () => {
    const { log, dispatch } = page();
    dispatch({ type: 'addressFollowed', ...parseCatalogAddress('?entry=torus.mvs') });
    expect(log.addresses).toEqual([]);
  });
});

describe('a download', () => {
  test('of the table is one file', () => {
    const { log, dispatch } = page();
    dispatch({ type: 'tablePressed' });
    expect(log.saved).toHaveLength(1);
    expect(log.saved[0][1]).toMatch(/^shape,genus,/);
  });

  test.each(
    /** @type {const} */ ([
      ['cage', 'two-3.cage.obj', false],
      ['control', 'two-3.bending.control.obj', true],
      ['limit', 'two-3.bending.limit.obj', true],
      ['stl', 'two-3.bending.stl', true],
      ['glb', 'two-3.bending.glb', true],
    ]),
  )('of an entry, %s, is saved as %s', async (what, name, needsSurface) => {
    const { log, finished, state } = page();
    await finished({ type: 'downloadPressed', entry: 'two-3.bending', what });
    expect(log.saved.map(([saved]) => saved)).toEqual([name]);
    expect(log.asked).toHaveLength(1);
    expect(log.asked[0].report !== null).toBe(needsSurface);
    expect(state().exporting).toBeNull();
  });

  test('that fails saves nothing and says why', async () => {
    const { log, finished, state } = page({ failure: 'not enough memory' });
    await finished({ type: 'downloadPressed', entry: 'two-3.bending', what: 'limit' });
    expect(log.saved).toEqual([]);
    expect(state().exportProblem).toBe('not enough memory');
  });
});

describe('the worker of the surfaces', () => {
  const command = { what: /** @type {const} */ ('cage'), cage: catalog.shapes[0].cage };

  /** Workers that never answer by themselves. */
  function workers() {
    /** @type {any[]} */
    const started = [];
    const make = createRequests(() => {
      const worker = {
        postMessage: (/** @type {any} */ data) => worker.got.push(data),
        got: /** @type {any[]} */ ([]),
      };
      started.push(worker);
      return /** @type {any} */ (worker);
    });
    return { started, make };
  }

  test('is started with the first request, and its answers find the requests that they are about', async () => {
    const { started, make } = workers();
    expect(started).toHaveLength(0);
    const [first, second] = [make(command), make(command)];
    const [worker] = started;
    worker.onmessage({ data: { request: worker.got[1].request, answer: 'second' } });
    worker.onmessage({ data: { request: worker.got[0].request, failure: 'no such cage' } });
    expect(await second).toBe('second');
    await expect(first).rejects.toThrow('no such cage');
    expect(started).toHaveLength(1);
  });

  test('that breaks fails what it was asked for, and the next request has a new one', async () => {
    const { started, make } = workers();
    const lost = make(command);
    started[0].onerror({ message: 'out of memory' });
    await expect(lost).rejects.toThrow('out of memory');
    const next = make(command);
    started[1].onmessage({ data: { request: started[1].got[0].request, answer: 'v' } });
    expect(await next).toBe('v');
  });
});
