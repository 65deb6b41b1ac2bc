// SPDX-License-Identifier: MIT
/**
 * @file Threads for a host that sends no headers: a service worker adds them (service_worker.js), from the next visit on. The
 * page that is open goes on as it is, since nothing would be worth loading it again.
 */

/** Registers the service worker where it would gain something. Without it the core has one thread. */
export function isolateNextVisit() {
  if (globalThis.crossOriginIsolated || !('serviceWorker' in navigator) || navigator.hardwareConcurrency === 1) return;
  navigator.serviceWorker.register('service_worker.js').catch(() => {});
}
