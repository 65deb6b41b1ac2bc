// SPDX-License-Identifier: MIT
/**
 * @file Stores the chosen theme between visits, if the browser allows it.
 */

/** @typedef {'light' | 'dark' | 'system'} Theme */

const KEY = 'umbilic.theme';

/** @returns {Theme} */
export function storedTheme() {
  try {
    const stored = localStorage.getItem(KEY);
    return stored === 'light' || stored === 'dark' ? stored : 'system';
  } catch {
    return 'system';
  }
}

/** @param {Theme} theme */
export function storeTheme(theme) {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // Only the choice is lost.
  }
}
