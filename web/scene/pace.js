// SPDX-License-Identifier: MIT
/**
 * @file Decides when frames are drawn: only on request, one for many requests, and for at most half of the time, so
 * that the page stays responsive even if drawing is slow.
 */

/** A frame that takes at most this many milliseconds needs no pause after it. */
const QUICK = 20;
/** Frames that take longer (milliseconds) cannot show motion smoothly. */
const SLOW = 80;

/**
 * @param {() => void} draw may request the next frame
 * @param {() => void} [drawn] called once the browser has finished the frame
 * @returns {{request: () => void, isSlow: () => boolean, interval: () => number, dispose: () => void}} `interval`: the
 *   shortest time between two frames that it allows, in milliseconds
 */
export function createPace(draw, drawn = () => {}) {
  let frame = 0;
  let busy = false;
  let again = false;
  let start = 0;
  let cost = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  // The browser's work for a frame after `draw` returns delays this message, so its arrival shows what the frame cost.
  const channel = new MessageChannel();
  channel.port1.onmessage = () => {
    cost = performance.now() - start;
    drawn();
    if (cost <= QUICK) return settle();
    pause = setTimeout(settle, cost);
  };

  function settle() {
    busy = false;
    if (again) request();
  }

  function request() {
    again = true;
    if (busy) return;
    busy = true;
    frame = requestAnimationFrame(() => {
      again = false;
      start = performance.now();
      draw();
      channel.port2.postMessage(null);
    });
  }

  return {
    request,
    isSlow: () => cost > SLOW,
    interval: () => (cost > QUICK ? 2 * cost : 0),
    dispose() {
      cancelAnimationFrame(frame);
      clearTimeout(pause);
      channel.port1.close();
      busy = true;
    },
  };
}
