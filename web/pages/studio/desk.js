// SPDX-License-Identifier: MIT
/**
 * @file The documents that are open in a page, one of which is on the screen. They are kept in the store, from which they
 * come back with the next visit.
 */
import { parseStudioAddress } from '../../address/studio.js';
import { numbered, projectName } from './names.js';
import { createOpenDocument, withFile } from './open_document.js';
import { formatProject, parseProject } from './project.js';
import { isBusy, isUntouched, keepsOther, keptFrom, stateFrom } from './state/kept.js';
import { withView } from './state/parts.js';
import { initialState } from './state/reduce.js';
import { documentName } from './state/select.js';

/** @import {Stored} from '../../worker/store.js' */
/** @import {createKeeper, Copy, Writer, Writing} from './keeper.js' */
/** @import {OfferedFile, OpenDocument, Surroundings} from './open_document.js' */
/** @import {createOwnership} from './ownership.js' */
/** @import {Action, State} from './state/types.js' */

/** A document that sleeps after this, in milliseconds, has told all about its surface at rest. */
const SLEEP_AFTER = 4_000;
/** So many closed documents can be opened again. */
const MOST_CLOSED = 5;

/** @typedef {{id: string, name: string, running: boolean, active: boolean}} Tab */
/** @typedef {{id: string, document: OpenDocument, writer: Writer, address: string, seen: number, lastDone: State['history'],
 *   file: string | null, after: string | null}} Open `file` is the one that it began with, until it has opened; `after` the page that
 *   wrote it before this one */

let lastTime = 0;
/** Milliseconds, later at each call. */
const later = () => (lastTime = Math.max(Date.now(), lastTime + 1));
/** In the order in which they are made. */
const newId = () => `${later().toString(36)}-${Math.random().toString(36).slice(2, 10)}`;

/**
 * @param {object} surroundings
 * @param {Pick<Surroundings, 'connect' | 'save' | 'takePicture' | 'load'>} surroundings.outside
 * @param {ReturnType<typeof createKeeper>} surroundings.keeper
 * @param {ReturnType<typeof createOwnership>} surroundings.ownership
 * @param {(search: string, id: string) => void} surroundings.setAddress of the document on the screen
 * @param {() => void} surroundings.changed called whenever something on the screen may have changed
 */
export function createDesk({ outside, keeper, ownership, setAddress, changed }) {
  /** In the order of their tabs. @type {Map<string, Open>} */
  const open = new Map();
  /** Closed documents, and those whose page was closed, the last one last. @type {string[]} */
  let closed = [];
  let active = '';
  /** How many documents another page had when this one began, until something is opened or closed here. */
  let elsewhere = 0;

  /** @returns {Open} */
  function current() {
    const mine = open.get(active);
    if (!mine) throw new Error('no document is open');
    return mine;
  }

  /** @param {Open} mine @param {number} [closedAt] @returns {Copy} */
  const copyOf = ({ document, address, seen }, closedAt = 0) => ({
    kept: keptFrom(document.state),
    address,
    seen,
    closed: closedAt,
  });

  /**
   * @param {string} id
   * @param {State} state
   * @param {Partial<Pick<Copy, 'address' | 'seen'>> & Pick<Writing, 'known' | 'after'>} [copy] in the store
   * @returns {Open}
   */
  function put(id, state, { address = '', seen = later(), ...stored } = {}) {
    const document = createOpenDocument(state, {
      ...outside,
      setAddress(search) {
        mine.address = search;
        if (mine.id === active) setAddress(search, mine.id);
      },
      changed(before, after) {
        if (after.document.cage && keepsOther(before, after)) mine.writer.touch();
        if (mine.file !== null) followFile(mine, after);
        if (mine.id !== active && isBusy(before) && !isBusy(after)) sleepSoon(mine.id);
        changed();
      },
    });
    /** @type {Open} */
    const mine = {
      id,
      document,
      writer: writerOf(id, () => mine, stored),
      address,
      seen,
      lastDone: state.history,
      file: null,
      after: stored.after ?? null,
    };
    open.set(id, mine);
    return mine;
  }

  /** @param {string} id @param {() => Open} mine @param {Pick<Writing, 'known' | 'after'>} stored */
  function writerOf(id, mine, stored) {
    return keeper.writer(id, () => copyOf(mine()), {
      ...stored,
      written: ({ kept }) => (mine().lastDone = kept.history),
      parted: () => part(mine()),
    });
  }

  /** Another page has written the document: what is here goes on as one of its own, beside it. @param {Open} mine */
  function part(mine) {
    const before = mine.id;
    if (open.get(before) !== mine) return;
    const all = [...open.values()];
    mine.id = newId();
    void ownership.take(mine.id);
    ownership.give(before);
    mine.after = null;
    mine.writer = writerOf(mine.id, () => mine, {});
    open.clear();
    for (const one of all) open.set(one.id, one); // in the order of their tabs
    if (active === before) {
      active = mine.id;
      setAddress(mine.address, mine.id);
    }
    mine.writer.touch();
    mine.document.dispatch({ type: 'documentParted' });
  }

  /** A document that its file does not fill gives way to the others, where that is said. @param {Open} mine @param {State} after */
  function followFile(mine, { document, session, view }) {
    if (document.cage) {
      mine.file = null;
      return;
    }
    if (session.opening?.source.kind !== 'generated') return;
    const name = mine.file ?? '';
    mine.file = null;
    if (open.size === 1) return;
    queueMicrotask(async () => {
      await desk.close(mine.id);
      const message = view.alert?.message ?? '';
      current().document.dispatch({ type: 'fileRefused', name, message });
    });
  }

  /** Writes a document as a closed one; under another id where another page has written it. @param {Open} mine @param {string} id @param {string | null} after @returns {Promise<string>} */
  async function keepClosed(mine, id, after) {
    let parted = false;
    const writer = keeper.writer(id, () => copyOf(mine, Date.now()), { after, parted: () => (parted = true) });
    writer.touch();
    await writer.flush();
    await writer.stop();
    return parted ? keepClosed(mine, newId(), null) : id;
  }

  /** @param {string} id */
  function sleepSoon(id) {
    setTimeout(() => id !== active && open.get(id)?.document.sleep(), SLEEP_AFTER);
  }

  /** Shows another document. What all documents share goes with the screen. @param {string} id */
  function show(id) {
    const mine = open.get(id);
    if (!mine || id === active) return;
    const before = open.get(active);
    active = id;
    if (before) {
      before.writer.touch();
      const { theme, fits } = before.document.state.view;
      mine.document.dispatch({ type: 'viewChanged', change: { theme, fits } });
      before.document.sleep();
    }
    mine.seen = later();
    mine.document.wake();
    if (mine.document.state.document.cage) mine.writer.touch();
    setAddress(mine.address, id);
    changed();
  }

  /**
   * Opens a new document beside the others, and shows it.
   * @param {State} state
   * @param {string | null} [file] the one that it opens
   */
  function begin(state, file = null) {
    const id = newId();
    void ownership.take(id);
    const mine = put(id, state);
    mine.file = file;
    elsewhere = 0;
    const before = open.get(active);
    active = id;
    before?.document.sleep();
    mine.document.begin();
    changed();
  }

  /** @param {Stored} stored @param {State} blank @returns {Promise<Open | null>} null if another page has it, or if it cannot be read */
  async function bringBack(stored, blank) {
    if (!(await ownership.take(stored.id))) return null;
    try {
      const { kept, ...copy } = await keeper.read(stored);
      return put(stored.id, stateFrom(blank, kept), copy);
    } catch {
      ownership.give(stored.id);
      return null;
    }
  }

  /**
   * Brings back what was open in this browser tab, or in any if there is nothing of its own, and shows what the page was asked for: the document that it showed before a reload, one
   * with the address, or a new one; or else the problem of a link.
   * @param {{search: string, shown: string | null, theme: State['view']['theme'], problem?: OfferedFile | null}} asked `shown` is
   *   the document that this page showed
   */
  async function restore({ search, shown, theme, problem = null }) {
    const begun = initialState(theme, parseStudioAddress(search));
    const all = await keeper.list().catch(() => []);
    const order = all.filter((one) => !one.closed).sort((a, b) => (a.id < b.id ? -1 : 1));
    const own = order.filter(({ id }) => ownership.had(id));
    const mine = own.length ? own : order;
    // At once, since each may wait for the page before this one.
    await Promise.all(mine.map(({ id }) => ownership.take(id)));
    for (const stored of mine) await bringBack(stored, begun);
    const again = shown !== null && open.has(shown);
    if (!again) await dropUntouched(search);
    const last = [...open.values()].sort((a, b) => b.seen - a.seen)[0];
    const same = [...open.values()].find(({ address }) => address === search);
    const chosen = again ? shown : search ? same?.id : last?.id;
    await forgetClosed(all.filter((one) => one.closed));
    // Those of a page that is gone. One that is being loaded again must not find them taken.
    const others = order.filter(({ id, content }) => !open.has(id) && content.past.length + content.future.length > 0);
    const free = await ownership.free(others.map(({ id }) => id));
    closed = [...closed, ...free];
    if (problem) begin(withFile(begun, problem), 'text' in problem ? problem.name : null);
    else if (chosen) show(chosen);
    else begin(begun);
    elsewhere = others.length - free.length;
    changed();
    for (const { id, document } of open.values()) {
      if (id !== active && document.state.session.phase.name === 'running') document.wake(true);
    }
  }

  /** Forgets documents with which nothing was done, since their addresses say all there is, but for one with this address. @param {string} search */
  async function dropUntouched(search) {
    const idle = [...open.values()].filter(
      ({ document, address }) => isUntouched(document.state) && (!search || address !== search),
    );
    // The last one of all stays, or else an address without a query would bring back nothing.
    if (!search && idle.length === open.size) idle.pop();
    for (const { id } of idle) open.delete(id);
    if (idle.length) await keeper.remove(idle.map(({ id }) => id)).catch(() => {});
    for (const { id } of idle) ownership.give(id);
  }

  /** Keeps the last few closed documents that no other page has. @param {Stored[]} all */
  async function forgetClosed(all) {
    const mine = [];
    for (const { id, closed: when } of all.sort((a, b) => a.closed - b.closed)) {
      if (when && (await ownership.take(id))) mine.push(id);
    }
    closed = mine.slice(-MOST_CLOSED);
    const gone = mine.slice(0, -MOST_CLOSED);
    if (gone.length) await keeper.remove(gone).catch(() => {});
    mine.forEach((id) => ownership.give(id));
  }

  const desk = {
    restore,
    show,

    get state() {
      return current().document.state;
    },

    get isOpen() {
      return open.has(active);
    },

    /** @param {Action} action on the document on the screen */
    dispatch: (action) => current().document.dispatch(action),

    /** @returns {Tab[]} */
    tabs() {
      const all = [...open.values()];
      const names = numbered(all.map(({ document }) => documentName(document.state)));
      return all.map(({ id, document: { state } }, i) => ({
        id,
        name: names[i],
        running: state.session.phase.name === 'running',
        active: id === active,
      }));
    },

    /** The file of the document on the screen. @returns {{name: string, text: string} | null} null if it has nothing yet */
    project() {
      const { state } = current().document;
      if (!state.document.cage) return null;
      return { name: projectName(state), text: formatProject(keptFrom(state), documentName(state)) };
    },

    /** Opens the file of a project as a document of its own, in the place of one with which nothing was done. @param {string} name @param {Uint8Array} text */
    openProject(name, text) {
      const before = current();
      try {
        const { kept } = parseProject(new TextDecoder().decode(text));
        const id = newId();
        void ownership.take(id);
        put(id, stateFrom(withView(initialState(), { theme: before.document.state.view.theme }), kept));
        show(id);
        if (isUntouched(before.document.state) && before.file === null) void desk.close(before.id);
      } catch (error) {
        const message = error instanceof Error ? error.message : String(error);
        before.document.dispatch({ type: 'fileRefused', name, message });
      }
    },

    /** Opens a file as a document of its own, in the place of one with which nothing was done. @param {OfferedFile} file */
    openBeside(file) {
      const before = current();
      if ('refused' in file) {
        before.document.dispatch({ type: 'fileRefused', name: file.name, message: file.refused });
        return;
      }
      const { theme } = before.document.state.view;
      begin(withFile(initialState(theme, parseStudioAddress('')), file), file.name);
      if (isUntouched(before.document.state) && before.file === null) void desk.close(before.id);
    },

    /** Opens a new document with the shape that the studio begins with. */
    create() {
      const { theme } = current().document.state.view;
      begin(initialState(theme, parseStudioAddress('')));
    },

    /** How many documents, with which something was done, are open in other pages. */
    get elsewhere() {
      return elsewhere;
    },

    get canReopen() {
      return closed.length > 0;
    },

    /** Closes a document, which can be opened again. Another one is shown; there is always one. @param {string} id */
    async close(id) {
      const mine = open.get(id);
      if (!mine) return;
      const ids = [...open.keys()];
      if (id === active) {
        const next = ids[ids.indexOf(id) + 1] ?? ids[ids.indexOf(id) - 1];
        if (next) show(next);
        else desk.create();
      }
      elsewhere = 0;
      open.delete(id);
      mine.document.dispose();
      await mine.writer.stop();
      if (mine.document.state.document.cage && !isUntouched(mine.document.state)) {
        closed = [...closed, await keepClosed(mine, id, mine.after)].slice(-MOST_CLOSED);
      } else {
        await keeper.remove([id]).catch(() => {});
      }
      ownership.give(id);
      changed();
    },

    /** Opens the document again that was closed last. */
    async reopen() {
      const all = await keeper.list().catch(() => []);
      const free = new Set(await ownership.free(closed));
      const id = closed.findLast((one) => free.has(one) && all.some((stored) => stored.id === one));
      const stored = all.find((one) => one.id === id);
      closed = closed.filter((one) => one !== id && free.has(one));
      const back =
        stored && (await bringBack(stored, withView(initialState(), { theme: current().document.state.view.theme })));
      if (back) show(back.id);
      changed();
    },

    /** Whether something was done that is not in the store. */
    get isUnkept() {
      return [...open.values()].some(({ document, lastDone }) => document.state.history !== lastDone);
    },

    /** Writes all that has changed at once, as far as the browser lets it. */
    flush: () => Promise.all([...open.values()].map(({ writer }) => writer.flush())),
  };
  return desk;
}
