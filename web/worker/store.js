// SPDX-License-Identifier: MIT
/**
 * @file The worker that keeps the studio's documents in the browser's database, away from the page. It knows nothing of
 * what is in them: a document is a record with parts.
 */
import { openDB } from 'idb';
import { answerRequests } from './requests.js';

/**
 * What is known of a document without its parts. `seen` is when it was on the screen last, in milliseconds; `closed` when
 * it was closed, 0 if it is open; `page` which page wrote it, unless an earlier version did.
 * @typedef {{id: string, seen: number, closed: number, page?: string, content: any}} Stored
 */

/**
 * `list`: all documents. `read`: the parts of one. `keep`: writes a document and its new parts, and forgets those that are not
 * in `keys`: all or nothing, and nothing where another page than its own and `after` wrote it last, or where parts are missing.
 * `remove`: forgets documents.
 * @typedef {{ask: 'list'} | {ask: 'read', id: string} | {ask: 'remove', ids: string[]}
 *   | {ask: 'keep', stored: Stored, parts: Map<string, any>, keys: string[], after: string | null}} StoreQuestion
 */

/** What came of `keep`. @typedef {'kept' | 'changed' | 'incomplete'} KeepOutcome */

/** The page's function for asking this worker. @typedef {(question: StoreQuestion) => Promise<any>} AskStore */

const DOCUMENTS = 'documents';
/** Keys are [document, part]. */
const PARTS = 'parts';

const opened = openDB('umbilic', 1, {
  upgrade(database) {
    database.createObjectStore(DOCUMENTS, { keyPath: 'id' });
    database.createObjectStore(PARTS);
  },
});

/** All parts of a document. @param {string} id */
const partsOf = (id) => IDBKeyRange.bound([id], [id, []]);

/** @param {StoreQuestion} question */
async function answer(question) {
  const database = await opened;
  if (question.ask === 'list') return database.getAll(DOCUMENTS);
  if (question.ask === 'read') {
    const range = partsOf(question.id);
    const [keys, parts] = await Promise.all([database.getAllKeys(PARTS, range), database.getAll(PARTS, range)]);
    return new Map(keys.map((key, i) => [/** @type {string[]} */ (key)[1], parts[i]]));
  }
  const writing = database.transaction([DOCUMENTS, PARTS], 'readwrite');
  const [documents, parts] = [writing.objectStore(DOCUMENTS), writing.objectStore(PARTS)];
  if (question.ask === 'remove') {
    for (const id of question.ids) await Promise.all([documents.delete(id), parts.delete(partsOf(id))]);
    return writing.done;
  }
  const { id, page } = question.stored;
  /** @type {[Stored | undefined, IDBValidKey[]]} */
  const [before, keys] = await Promise.all([documents.get(id), parts.getAllKeys(partsOf(id))]);
  if (before?.page && before.page !== page && before.page !== question.after) return 'changed';
  const there = new Set(keys.map((key) => /** @type {string[]} */ (key)[1]));
  if (question.keys.some((key) => !there.has(key) && !question.parts.has(key))) return 'incomplete';
  const wanted = new Set(question.keys);
  const gone = keys.filter((key) => !wanted.has(/** @type {string[]} */ (key)[1]));
  await Promise.all([
    documents.put(question.stored),
    ...[...question.parts].map(([key, part]) => parts.put(part, [id, key])),
    ...gone.map((key) => parts.delete(key)),
  ]);
  await writing.done;
  return 'kept';
}

answerRequests(
  async () => {
    await opened;
  },
  async (question) => ({ answer: await answer(question) }),
);
