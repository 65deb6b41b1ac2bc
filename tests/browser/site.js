// SPDX-License-Identifier: MIT
/**
 * @file Serves the built page like a cheap static host: under a sub-path, and without special headers unless
 * a test asks for some.
 */
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';

/** @type {Record<string, string>} */
const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
  '.wasm': 'application/wasm',
};

export const SUB_PATH = '/some/where/';

/**
 * @param {string} folder
 * @param {object} [how]
 * @param {Record<string, string>} [how.headers] that are sent with everything
 * @param {RegExp} [how.missing] the paths of files that are kept back
 * @returns {Promise<{url: string, close: () => Promise<void>}>}
 */
export async function serve(folder, { headers = {}, missing = /(?!)/ } = {}) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const relative = pathname.startsWith(SUB_PATH) ? pathname.slice(SUB_PATH.length) || 'index.html' : null;
    const file = relative === null ? null : path.join(folder, path.normalize(`/${relative}`));
    const content = file && !missing.test(pathname) && (await readFile(file).catch(() => null));
    if (!content) {
      response.writeHead(404).end();
      return;
    }
    const type = types[path.extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { ...headers, 'content-type': type }).end(content);
  });
  await new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => resolve(undefined));
  });
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    url: `http://127.0.0.1:${address.port}${SUB_PATH}`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
