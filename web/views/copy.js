// SPDX-License-Identifier: MIT
/**
 * @file The button that copies the page's address.
 */
import { setText } from './dom.js';

/** For how many milliseconds the button shows whether it has copied. */
const TOLD = 1600;

/** @param {HTMLButtonElement} button */
export function createCopyView(button) {
  const listening = new AbortController();
  const label = button.textContent ?? '';
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  button.addEventListener(
    'click',
    async () => {
      // If the page may not copy, the user can copy from the address bar.
      const copied = await copy(location.href);
      setText(button, copied ? 'Copied' : 'See the address bar');
      clearTimeout(timer);
      timer = setTimeout(() => setText(button, label), TOLD);
    },
    { signal: listening.signal },
  );
  return {
    dispose() {
      listening.abort();
      clearTimeout(timer);
    },
  };
}

/** @param {string} text @returns {Promise<boolean>} whether it was copied; the browser may forbid it */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
