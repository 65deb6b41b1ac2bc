// SPDX-License-Identifier: MIT
/**
 * @file The button that copies a link to what the page shows.
 */
import { setText } from './dom.js';

/** For how many milliseconds the button shows whether it has copied. */
const TOLD = 1600;

/**
 * @param {HTMLButtonElement} button
 * @param {() => Promise<string | null>} [linkOf] the link that is copied, by default the page's address; null if there is none,
 *   which is said elsewhere
 */
export function createCopyView(button, linkOf = async () => location.href) {
  const listening = new AbortController();
  const label = (button.textContent ?? '').trim();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  button.addEventListener(
    'click',
    async () => {
      const link = await linkOf();
      if (link === null) return;
      const copied = await copy(link);
      // If the page may not copy, the user can copy from the address bar.
      if (!copied) history.replaceState(history.state, '', link);
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
