// SPDX-License-Identifier: MIT
/**
 * @file Puts pictures on a canvas when they are asked for and at no other time: one renderer, as fine as the machine is fast, and once
 * more finely after a rest where it is slow.
 */
import { NeutralToneMapping, WebGLRenderer } from 'three';
import { createPace } from './pace.js';

/** More pixels than this per CSS pixel cost time and are not seen. */
const MAX_PIXEL_RATIO = 2;
/** Milliseconds of rest after which a slow machine draws once more, finely. */
const REFINE_AFTER = 350;

/**
 * @param {HTMLCanvasElement} canvas fills its parent; its `data-picture` is `old`, `coarse` or `fine`
 * @param {object} options
 * @param {boolean} options.slow drawn without graphics hardware
 * @param {(renderer: WebGLRenderer) => void} options.draw the whole picture
 * @param {(width: number, height: number) => void} options.resized in CSS pixels, before the picture of that size is drawn
 * @param {() => void} [options.prepare] before each requested picture; may request the next one
 * @param {() => void} [options.drawn] after each requested picture
 */
export function createPainter(canvas, { slow, draw, resized, prepare = () => {}, drawn }) {
  const renderer = new WebGLRenderer({ canvas, antialias: !slow, alpha: true, powerPreference: 'high-performance' });
  // The driver's words on a shader are waited for.
  renderer.debug.checkShaderErrors = false;
  renderer.toneMapping = NeutralToneMapping;
  const pixelRatio = Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO);
  renderer.setPixelRatio(pixelRatio);

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let refining;
  const pace = createPace(() => {
    canvas.dataset.picture = slow ? 'coarse' : 'fine';
    prepare();
    paint();
    refineSoon();
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
    // At once: a canvas that has been resized is blank until it is drawn.
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
    /** Draws without being asked, so that shaders are there when the first picture is. */
    rehearse: () => draw(renderer),
    /** Whether pictures take too long to show a motion. */
    isSlow: () => slow || pace.isSlow(),
    dispose() {
      clearTimeout(refining);
      pace.dispose();
      observer.disconnect();
      canvas.removeEventListener('webglcontextrestored', request);
      renderer.dispose();
    },
  };
}
