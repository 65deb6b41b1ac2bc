// SPDX-License-Identifier: MIT
/**
 * @file The page's end of the worker that makes the meshes of catalog entries, which is started with the first request.
 */

/** @import {Mesh} from '../../wasm/types.js' */
/** @import {SurfaceCommand, SurfaceMessage} from './surfaces.js' */

/** @typedef {Pick<Worker, 'postMessage' | 'onmessage' | 'onerror'>} SurfaceWorker */

/** @typedef {(command: Omit<SurfaceCommand, 'request'>) => Promise<string | Mesh>} MakeSurface */

/** @param {() => SurfaceWorker} createWorker @returns {MakeSurface} */
export function createSurfaceClient(createWorker) {
  /** @type {SurfaceWorker | null} */
  let worker = null;
  let requests = 0;
  /** @type {Map<number, {resolve: (made: string | Mesh) => void, reject: (error: Error) => void}>} */
  const waiting = new Map();

  function start() {
    const mine = createWorker();
    mine.onmessage = (/** @type {MessageEvent<SurfaceMessage>} */ { data }) => {
      const request = waiting.get(data.request);
      waiting.delete(data.request);
      if ('made' in data) request?.resolve(data.made);
      else request?.reject(new Error(data.failure));
    };
    mine.onerror = (event) => {
      worker = null;
      for (const { reject } of waiting.values()) reject(new Error(event.message || 'the computation is not available'));
      waiting.clear();
    };
    return mine;
  }

  return (command) =>
    new Promise((resolve, reject) => {
      worker ??= start();
      const request = ++requests;
      waiting.set(request, { resolve, reject });
      worker.postMessage({ ...command, request });
    });
}
