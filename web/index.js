// SPDX-License-Identifier: MIT
/**
 * @file The catalog's entry, which is also the home page.
 */
import { storeTheme, storedTheme } from './files/theme.js';
import { find } from './views/dom.js';
import { createThemeView } from './views/theme.js';

const theme = createThemeView(find(document, '#theme'), (chosen) => {
  storeTheme(chosen);
  theme.update(chosen);
});
theme.update(storedTheme());
