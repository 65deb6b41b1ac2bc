// SPDX-License-Identifier: MIT
/**
 * @file Both sides of a worker that only answers questions: one answer to each, in order. The first question starts the
 * worker.
 */

/** @typedef {Pick<Worker, 'postMessage' | 'onmessage' | 'onerror'>} Answering */

/** @typedef {{request: number, question: any}} Request */
/** @typedef {{answer: any, transfer?: ArrayBuffer[]}} Answered */
/** @typedef {{request: number, answer: any} | {request: number, failure: string}} Response */

/**
 * The page's side.
 * @template Q, A
 * @param {() => Answering} createWorker
 * @returns {(question: Q) => Promise<A>}
 */
export function createRequests(createWorker) {
  /** @type {Answering | null} */
  let worker = null;
  let requests = 0;
  /** @type {Map<number, {resolve: (answer: A) => void, reject: (error: Error) => void}>} */
  const waiting = new Map();

  function start() {
    const mine = createWorker();
    mine.onmessage = (/** @type {MessageEvent<Response>} */ { data }) => {
      const request = waiting.get(data.request);
      waiting.delete(data.request);
      if ('answer' in data) request?.resolve(data.answer);
      else request?.reject(new Error(data.failure));
    };
    mine.onerror = (event) => {
      worker = null;
      for (const { reject } of waiting.values()) reject(new Error(event.message || 'the computation is not available'));
      waiting.clear();
    };
    return mine;
  }

  return (question) =>
    new Promise((resolve, reject) => {
      worker ??= start();
      const request = ++requests;
      waiting.set(request, { resolve, reject });
      worker.postMessage({ request, question });
    });
}

/**
 * The worker's side.
 * @param {() => Promise<void>} load called before the first answer
 * @param {(question: any) => Answered | Promise<Answered>} answer
 */
export function answerRequests(load, answer) {
  const loaded = load();
  loaded.catch(() => {}); // every answer reports the failure
  self.onmessage = async (/** @type {MessageEvent<Request>} */ { data: { request, question } }) => {
    try {
      await loaded;
      const { answer: found, transfer = [] } = await answer(question);
      self.postMessage({ request, answer: found }, { transfer });
    } catch (error) {
      self.postMessage({ request, failure: error instanceof Error ? error.message : String(error) });
    }
  };
}
