// SPDX-License-Identifier: MIT
/**
 * @file The chosen theme, kept from one visit to the next where the browser allows it.
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
    // Nothing is lost but the choice.
  }
}
