// SPDX-License-Identifier: MIT
/**
 * @file Notices about a page's address or about files that could not be loaded, shown until they are dismissed.
 */
import { find, setText } from './dom.js';

/**
 * @param {HTMLElement} root
 * @param {() => void} dismiss
 */
export function createNoticesView(root, dismiss) {
  const listening = new AbortController();
  const words = find(root, 'p');
  find(root, 'button').addEventListener('click', dismiss, { signal: listening.signal });
  return {
    /** @param {{notices: string[]}} state */
    update({ notices }) {
      root.hidden = !notices.length;
      setText(words, notices.join(' '));
    },
    dispose: () => listening.abort(),
  };
}
