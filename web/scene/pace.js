// SPDX-License-Identifier: MIT
/**
 * @file When frames are drawn: on request only, one for many requests, and for no more than half of the time, so that the
 * page answers also where drawing is slow.
 */

/** Milliseconds that a frame may take without a pause after it. */
const QUICK = 20;
/** Frames that take longer cannot show a motion. */
const SLOW = 80;

/**
 * @param {() => void} draw may request the next frame
 * @param {() => void} [drawn] is called once the browser has done its part
 * @returns {{request: () => void, isSlow: () => boolean, dispose: () => void}}
 */
export function createPace(draw, drawn = () => {}) {
  let frame = 0;
  let busy = false;
  let again = false;
  let start = 0;
  let cost = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;
  // What the browser does for a frame after `draw` returns delays this message, so it tells what the frame has cost.
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
    dispose() {
      cancelAnimationFrame(frame);
      clearTimeout(pause);
      channel.port1.close();
      busy = true;
    },
  };
}
