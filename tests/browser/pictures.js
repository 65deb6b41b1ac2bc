// SPDX-License-Identifier: MIT
/**
 * @file Takes pictures of parts of a page and measures how much two pictures differ.
 */

/** @typedef {import('playwright-core').Locator} Locator */
/** @typedef {import('playwright-core').Page} Page */

/** Waits until the current state has been drawn. @param {Page} page */
async function settled(page) {
  await page.waitForFunction(() => document.querySelector('canvas')?.dataset.picture === 'fine');
}

/**
 * Waits until the address has not changed for longer than a camera must rest before the page reports it. (On a slow
 * machine the camera also rests in the middle of a drag.)
 * @param {Page} page
 * @param {string | null} before the camera in the address before the motion
 */
export async function cameraRests(page, before) {
  await page.waitForFunction((was) => new URLSearchParams(location.search).get('camera') !== was, before);
  let address = '';
  while (address !== page.url()) {
    address = page.url();
    await page.waitForTimeout(800);
  }
}

/**
 * @param {Page} page
 * @param {Locator} part
 * @returns {Promise<string>} PNG, in base 64
 */
export async function pictureOf(page, part) {
  await settled(page);
  return (await part.screenshot()).toString('base64');
}

/**
 * The picture of the studio's surface, without what lies over it. The page must have been opened with `bypassCSP`.
 * @param {Page} page
 * @returns {Promise<string>} PNG, in base 64
 */
export async function surfacePicture(page) {
  await settled(page);
  const style = '#surface > :not(.view) { visibility: hidden !important } canvas { outline: none !important }';
  return (await page.locator('#surface .view').screenshot({ style })).toString('base64');
}

/**
 * The fraction of pixels whose colours differ visibly; 1 if the sizes differ.
 * @param {Page} page any page; only used to compute in a browser
 * @param {string} a
 * @param {string} b
 */
export function difference(page, a, b) {
  return page.evaluate(
    async (pictures) => {
      const [one, other] = await Promise.all(
        pictures.map(async (encoded) => {
          const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
          const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
          const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
          const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
          context.drawImage(bitmap, 0, 0);
          return context.getImageData(0, 0, bitmap.width, bitmap.height);
        }),
      );
      if (one.width !== other.width || one.height !== other.height) return 1;
      let different = 0;
      for (let i = 0; i < one.data.length; i += 4) {
        if ([0, 1, 2].some((k) => Math.abs(one.data[i + k] - other.data[i + k]) > 16)) different++;
      }
      return (4 * different) / one.data.length;
    },
    [a, b],
  );
}
