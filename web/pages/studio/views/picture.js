// SPDX-License-Identifier: MIT
/**
 * @file A picture of the surface as PNG, of any size: a second view of the surface, which is not shown, draws all that the
 * one on the screen does.
 */

/** @import {Range} from '../../../colour/range.js' */
/** @import {State} from '../state/types.js' */
/** @import {createSurfaceView} from './surface.js' */

/** As in painter.js: the largest number of pixels per CSS pixel. */
const MAX_PIXEL_RATIO = 2;
/** Milliseconds after which a picture that was not drawn will not be. */
const PATIENCE = 30_000;

/** What is seen of the surface. @typedef {{state: State, range: Range | null, dark: boolean}} Seen */

/**
 * @param {HTMLElement} shown the element of the view on the screen
 * @param {typeof createSurfaceView} create
 * @param {Seen} seen
 * @param {{size?: [number, number], background?: boolean}} options in pixels; with the page's background, or none
 * @returns {Promise<Blob>}
 */
export async function takePicture(shown, create, { state, range, dark }, { size, background = false }) {
  const [width, height] = size ?? [shown.clientWidth, shown.clientHeight];
  const ratio = Math.min(devicePixelRatio, MAX_PIXEL_RATIO);
  const root = /** @type {HTMLElement} */ (shown.cloneNode(true));
  root.inert = true;
  root.setAttribute('aria-hidden', 'true');
  Object.assign(root.style, {
    position: 'fixed',
    inset: '0 auto auto 0',
    flex: 'none',
    width: `${Math.ceil(width / ratio)}px`,
    height: `${Math.ceil(height / ratio)}px`,
    visibility: 'hidden',
  });
  document.body.append(root);
  const shownBy = create(
    root,
    () => {},
    () => {},
  );
  try {
    const taken = capture(root, width, height, background ? colourBehind(shown) : null);
    // What edits the surface is no part of it.
    const view = { ...state.view, pointer: /** @type {const} */ ('turn'), pin: null };
    shownBy.update({ ...state, view }, range, dark);
    const blob = await (await taken).convertToBlob({ type: 'image/png' });
    return blob;
  } finally {
    shownBy.dispose();
    const canvas = root.querySelector('canvas');
    canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    root.remove();
  }
}

/** @param {HTMLElement} root @param {number} width @param {number} height @param {string | null} colour @returns {Promise<OffscreenCanvas>} */
function capture(root, width, height, colour) {
  const canvas = root.querySelector('canvas');
  if (!canvas || canvas.hidden) return Promise.reject(new Error('This browser cannot draw the surface.'));
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => {
      observer.disconnect();
      reject(new Error('It was not drawn in time.'));
    }, PATIENCE);
    // Told in the task that draws, in which the picture can still be read.
    const observer = new MutationObserver(() => {
      if (canvas.dataset.picture !== 'fine' || canvas.width < width - 1 || canvas.height < height - 1) return;
      observer.disconnect();
      clearTimeout(timer);
      resolve(copied(canvas, width, height, colour));
    });
    observer.observe(canvas, { attributeFilter: ['data-picture'] });
  });
}

/** @param {HTMLCanvasElement} canvas @param {number} width @param {number} height @param {string | null} colour of the background */
function copied(canvas, width, height, colour) {
  const copy = new OffscreenCanvas(width, height);
  const context = copy.getContext('2d');
  if (!context) throw new Error('There is not enough memory for a picture of this size.');
  if (colour !== null) {
    context.fillStyle = colour;
    context.fillRect(0, 0, width, height);
  }
  context.imageSmoothingQuality = 'high';
  context.drawImage(canvas, 0, 0, width, height);
  return copy;
}

/** The page's own colour. @param {Element} element */
const colourBehind = ({ ownerDocument }) => getComputedStyle(ownerDocument.documentElement).backgroundColor;
