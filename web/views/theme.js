// SPDX-License-Identifier: MIT
/**
 * @file The theme button of the header, on every page.
 */
import { setText } from './dom.js';

/** @import {Theme} from '../files/theme.js' */

/**
 * @param {HTMLButtonElement} button
 * @param {(theme: Theme) => void} choose called with the theme that the button offers
 */
export function createThemeView(button, choose) {
  const listening = new AbortController();
  const system = matchMedia('(prefers-color-scheme: dark)');
  /** @type {Theme} */
  let theme = 'system';
  const isDark = () => theme === 'dark' || (theme === 'system' && system.matches);
  button.addEventListener('click', () => choose(isDark() ? 'light' : 'dark'), { signal: listening.signal });
  function show() {
    document.documentElement.dataset.theme = theme;
    setText(button, isDark() ? 'Light' : 'Dark');
    button.setAttribute('aria-label', isDark() ? 'Light theme' : 'Dark theme');
  }
  system.addEventListener('change', show, { signal: listening.signal });
  return {
    /** @param {Theme} chosen @returns {boolean} whether the page is dark now */
    update(chosen) {
      theme = chosen;
      show();
      return isDark();
    },
    dispose: () => listening.abort(),
  };
}
