// SPDX-License-Identifier: MIT
/**
 * @file Draws on a canvas, only when asked: one renderer whose resolution fits the machine's speed. On a slow machine
 * it draws again at full resolution after a rest.
 */
import { NeutralToneMapping, WebGLRenderer } from 'three';
import { PICTURE } from './glide.js';
import { createPace } from './pace.js';

/** More pixels per CSS pixel than this cost time without a visible gain. */
const MAX_PIXEL_RATIO = 2;
/** Milliseconds of rest after which a slow machine draws once more at full resolution. */
const REFINE_AFTER = 350;

/**
 * @param {HTMLCanvasElement} canvas fills its parent; its `data-picture` is `old`, `moving`, `coarse` or `fine`
 * @param {object} options
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(renderer: WebGLRenderer) => void} options.draw draws a picture
 * @param {(width: number, height: number) => void} options.resized called with CSS pixels before the first picture of a
 *   new size
 * @param {() => boolean} [options.prepare] before each requested picture; may request the next one. Whether what is shown
 *   moves: then the next one is drawn in time to show that
 * @param {() => void} [options.drawn] after each requested picture
 */
export function createPainter(canvas, { slow, draw, resized, prepare = () => false, drawn }) {
  const renderer = new WebGLRenderer({ canvas, antialias: !slow, alpha: true, powerPreference: 'high-performance' });
  // Skips checks that would wait for the driver's report on each shader.
  renderer.debug.checkShaderErrors = false;
  renderer.toneMapping = NeutralToneMapping;
  const pixelRatio = Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO);
  renderer.setPixelRatio(pixelRatio);

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let refining;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let next;
  const pace = createPace(() => {
    canvas.dataset.picture = slow ? 'coarse' : 'fine';
    clearTimeout(next);
    const moves = prepare();
    if (moves) canvas.dataset.picture = 'moving';
    paint();
    // The browser's next frame comes at most 1/60 s later.
    if (moves) next = setTimeout(request, 0.6 * PICTURE);
    else refineSoon();
  }, drawn);

  function refineSoon() {
    if (!slow) return;
    clearTimeout(refining);
    refining = setTimeout(() => {
      if (canvas.dataset.picture !== 'coarse') return;
      paint(2);
      canvas.dataset.picture = 'fine';
    }, REFINE_AFTER);
  }

  /** @param {number} [fineness] */
  function paint(fineness = 1) {
    if (renderer.getPixelRatio() !== fineness * pixelRatio) renderer.setPixelRatio(fineness * pixelRatio);
    draw(renderer);
  }

  function request() {
    canvas.dataset.picture = 'old';
    pace.request();
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas.parentElement ?? canvas;
    if (!clientWidth || !clientHeight) return;
    renderer.setSize(clientWidth, clientHeight, false);
    resized(clientWidth, clientHeight);
    // Draws at once, because resizing a canvas clears it.
    paint();
    if (canvas.dataset.picture !== 'fine') return;
    canvas.dataset.picture = slow ? 'coarse' : 'fine';
    refineSoon();
  }

  const observer = new ResizeObserver(resize);
  observer.observe(canvas.parentElement ?? canvas);
  canvas.addEventListener('webglcontextrestored', request);

  return {
    request,
    /** Draws without a request, so that the shaders are compiled before the first picture. */
    rehearse: () => draw(renderer),
    /** Whether pictures take too long to show a motion. */
    isSlow: () => slow || pace.isSlow(),
    /** The shortest time between two pictures, in milliseconds. */
    interval: pace.interval,
    dispose() {
      clearTimeout(refining);
      clearTimeout(next);
      pace.dispose();
      observer.disconnect();
      canvas.removeEventListener('webglcontextrestored', request);
      renderer.dispose();
    },
  };
}
