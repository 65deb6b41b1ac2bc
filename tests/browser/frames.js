// SPDX-License-Identifier: MIT
/**
 * @file Where the surface is in each picture that the page draws during a run, found from the pixels that are not
 * background.
 */

/** @typedef {import('playwright-core').Page} Page */

/**
 * The bounding box of what is drawn, as fractions of the picture's width and height from its top left corner; `filled`
 * is the fraction of all pixels.
 * @typedef {{filled: number, left: number, right: number, top: number, bottom: number}} Covered
 */

/**
 * To be called before the page loads. Records what each picture covers, starting with the next press of Start.
 * @param {Page} page
 */
export async function recordFrames(page) {
  await page.addInitScript(() => {
    /** Size in pixels of the reduced copy that is examined. */
    const side = 128;
    /** @type {Covered[]} */
    let frames = [];

    /** @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} context @returns {Covered} */
    function covered(context) {
      const { data } = context.getImageData(0, 0, side, side);
      let count = 0;
      let [left, right, top, bottom] = [side, 0, side, 0];
      for (let i = 0; i < side * side; i++) {
        // The canvas is transparent where nothing has been drawn.
        if (data[4 * i + 3] < 128) continue;
        count++;
        const [x, y] = [i % side, Math.floor(i / side)];
        [left, right, top, bottom] = [
          Math.min(left, x),
          Math.max(right, x + 1),
          Math.min(top, y),
          Math.max(bottom, y + 1),
        ];
      }
      return {
        filled: count / side ** 2,
        left: left / side,
        right: right / side,
        top: top / side,
        bottom: bottom / side,
      };
    }

    addEventListener('DOMContentLoaded', () => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('#surface canvas'));
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
        new OffscreenCanvas(side, side).getContext('2d', { willReadFrequently: true })
      );
      // Called at the end of the task that draws, before the browser clears the picture.
      new MutationObserver(() => {
        if (canvas.dataset.picture === 'old') return;
        context.clearRect(0, 0, side, side);
        context.drawImage(canvas, 0, 0, side, side);
        frames.push(covered(context));
      }).observe(canvas, { attributeFilter: ['data-picture'] });
      document.querySelector('#primary')?.addEventListener('click', () => (frames = []), { capture: true });
    });
    Object.assign(window, { recordedFrames: () => frames });
  });
}

/** The recorded frames. @param {Page} page @returns {Promise<Covered[]>} */
export function recordedFrames(page) {
  return page.evaluate(() => /** @type {any} */ (window).recordedFrames());
}
