// SPDX-License-Identifier: MIT
/**
 * @file Adds to the site's own pages and workers, on their way to the browser, the headers that let the core have threads,
 * for hosts that send none. It keeps nothing, and leaves everything else alone.
 */

import { isolation } from './headers.js';

/** @typedef {{request: Request, respondWith: (response: Promise<Response>) => void}} FetchEvent */

/** @param {Request} request @returns {Promise<Response>} */
async function isolated(request) {
  const response = await fetch(request);
  if (!response.ok) return response; // redirections among them
  const all = new Headers(response.headers);
  for (const [name, value] of Object.entries(isolation)) all.set(name, value);
  return new Response(response.body, { status: response.status, statusText: response.statusText, headers: all });
}

self.addEventListener('fetch', (event) => {
  const { request, respondWith } = /** @type {FetchEvent & Event} */ (/** @type {unknown} */ (event));
  const own = new URL(request.url).origin === self.location.origin;
  if (own && (request.mode === 'navigate' || request.destination === 'worker')) {
    respondWith.call(event, isolated(request));
  }
});
